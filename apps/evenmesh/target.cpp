// SPDX-License-Identifier: MIT
#include "apps/evenmesh/target.h"

#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"
#include "evenmesh/mesh/rings.h"
#include "evenmesh/quality/quality.h"

namespace evenmesh::app {

std::optional<double> parse_target(const std::string& text) {
  if (text.empty()) return std::nullopt;
  constexpr std::string_view kBegin = "shape>=";
  if (text.starts_with(kBegin)) {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + kBegin.size(), end, value);
    if (error == std::errc() && rest == end && value > 0.0 && value < 1.0) return value;
  }
  throw InvalidOption(fmt::format(
      "--target '{}': should be shape>=X with X between 0 and 1, as in shape>=0.3", shown(text)));
}

std::vector<std::size_t> cells_below(double target, const Mesh& mesh, Points points,
                                     const Orientation& orientation, int threads) {
  Workers workers(threads);
  const CellQuality quality = measure_cells(workers, mesh, points, orientation);
  std::vector<std::size_t> below;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    if (quality.of(Metric::shape)[c] < target || quality.inverted[c] != 0) below.push_back(c);
  }
  return below;
}

std::vector<char> vertices_far_from(const std::vector<std::size_t>& cells, const Mesh& mesh,
                                    int rings) {
  std::vector<char> flags(mesh.point_count(), 0);
  for (const std::size_t c : cells) {
    for (const Index v : mesh.cells().vertices(c)) flags[v] = 1;
  }
  flags = with_rings(mesh.cells(), std::move(flags), rings);
  for (char& flag : flags) flag = flag == 0;
  return flags;
}

}  // namespace evenmesh::app
