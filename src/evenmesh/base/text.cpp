// SPDX-License-Identifier: MIT
#include "evenmesh/base/text.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evenmesh {
namespace {

constexpr std::size_t kLongest = 40;

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// How many letters to change, add or leave out to get from one word to the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string shown(std::string_view text) {
  std::string result(text.substr(0, kLongest));
  for (char& c : result) {
    if (c < 0x20 || c > 0x7e) c = '?';
  }
  if (text.size() > kLongest) result += "...";
  return result;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), small_letter);
  return result;
}

bool equal_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return small_letter(x) == small_letter(y); });
}

std::string nearest_word(std::string_view word, std::span<const std::string_view> known) {
  if (word.size() > kLongest || known.empty()) return "";
  const std::string typed = lower(word);
  std::size_t least = typed.size() + kLongest;
  std::string_view best;
  for (const std::string_view candidate : known) {
    if (candidate.size() > kLongest) continue;
    const std::size_t distance = edit_distance(typed, lower(candidate));
    if (distance >= least) continue;
    least = distance;
    best = candidate;
  }
  return least <= 1 + best.size() / 4 ? std::string(best) : "";
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  const std::string best = nearest_word(word, known);
  return best.empty() ? "" : " (did you mean '" + best + "'?)";
}

}  // namespace evenmesh
