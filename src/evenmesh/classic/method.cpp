// SPDX-License-Identifier: MIT
#include "evenmesh/classic/method.h"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"

namespace evenmesh {
namespace {

constexpr std::string_view kNames[] = {
    "lagrange_newton",  "laplacian",       "smart_laplacian",       "combined",
    "global_laplacian", "lennard_jones",   "lennard_jones_printed", "pliant",
    "angle_based",      "optimal_delaunay"};

}  // namespace

std::string_view name(Method method) { return kNames[static_cast<int>(method)]; }

std::vector<std::string_view> method_names() { return {std::begin(kNames), std::end(kNames)}; }

Method method_of(const std::string& word) {
  const auto found = std::find(std::begin(kNames), std::end(kNames), word);
  if (found == std::end(kNames)) {
    throw InvalidOption(fmt::format("there is no method '{}'{}; known are {}", shown(word),
                                    suggestion(word, kNames), fmt::join(kNames, ", ")));
  }
  return static_cast<Method>(found - std::begin(kNames));
}

}  // namespace evenmesh
