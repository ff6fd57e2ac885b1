// SPDX-License-Identifier: MIT
#include "evenmesh/io/node_numbers.h"

#include <algorithm>

namespace evenmesh {
namespace {

/// Numbers up to so many times their count are looked up in a table, larger ones in a sorted list.
constexpr std::uint64_t kTableRatio = 4;

}  // namespace

std::size_t NodeNumbers::index(std::span<const std::uint64_t> numbers) {
  count_ = numbers.size();
  table_.clear();
  sorted_.clear();
  std::size_t straight = 0;
  while (straight < count_ && numbers[straight] == straight + 1) ++straight;
  if (straight == count_) return count_;

  const std::uint64_t largest = *std::max_element(numbers.begin(), numbers.end());
  if (largest / kTableRatio <= count_) {
    table_.assign(largest + 1, kNone);
    for (std::size_t i = 0; i < count_; ++i) {
      if (table_[numbers[i]] != kNone) return i;
      table_[numbers[i]] = static_cast<Index>(i);
    }
    return count_;
  }
  sorted_.reserve(count_);
  for (std::size_t i = 0; i < count_; ++i) sorted_.emplace_back(numbers[i], static_cast<Index>(i));
  std::sort(sorted_.begin(), sorted_.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end(), same);
  return twice != sorted_.end() ? twice[1].second : count_;
}

Index NodeNumbers::find(std::uint64_t number) const {
  if (!table_.empty()) return number < table_.size() ? table_[number] : kNone;
  if (sorted_.empty()) return number - 1 < count_ ? static_cast<Index>(number - 1) : kNone;
  const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{number, Index{0}});
  return at != sorted_.end() && at->first == number ? at->second : kNone;
}

}  // namespace evenmesh
