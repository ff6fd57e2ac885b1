// SPDX-License-Identifier: MIT
#include "apps/evenmesh/cost_text.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"

namespace evenmesh::app {

std::vector<CostChoice> parse_costs(const std::string& text) {
  std::vector<CostChoice> costs;
  std::size_t at = 0;
  while (!text.empty() && at <= text.size()) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t equals = std::min(part.find('='), part.size());
    CostChoice choice{.name = part.substr(0, equals), .weight = 1.0};
    if (equals < part.size()) {
      const char* first = part.data() + equals + 1;
      const char* last = part.data() + part.size();
      const auto [rest, error] = std::from_chars(first, last, choice.weight);
      if (error != std::errc() || rest != last) {
        throw InvalidOption(fmt::format(
            "'{}' is no weight in --cost {}; write for example local=0.3,barycenter=0.3",
            part.substr(equals + 1), text));
      }
    }
    // Beyond that, its product with a cost is soon beyond double precision.
    if (choice.weight > 0.0 && !(choice.weight >= 1e-100 && choice.weight <= 1e100)) {
      throw InvalidOption(fmt::format(
          "the weight {} in --cost {} must lie between 1e-100 and 1e100", choice.weight, text));
    }
    if (choice.name.empty()) {
      throw InvalidOption(fmt::format("a cost without a name in --cost {}", text));
    }
    costs.push_back(std::move(choice));
    at = end + 1;
  }
  return costs;
}

std::string cost_text(const Problem& problem) {
  std::string text;
  for (const Term& term : problem.terms) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", term.cost->name(), term.weight);
  }
  return text;
}

}  // namespace evenmesh::app
