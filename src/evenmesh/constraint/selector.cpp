// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/selector.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

constexpr std::string_view kKnown =
    "all, none, boundary, features, corners, interface, non_manifold, id:1,5-9, "
    "box:x0,y0,z0,x1,y1,z1, joined by + (and), - (without) or & (in both)";

constexpr std::array<std::string_view, 9> kWords = {
    "all", "none", "boundary", "features", "corners", "interface", "non_manifold", "id:", "box:"};

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_operator(char c) { return c == '+' || c == '-' || c == '&'; }

/// How many letters to change, add or leave out to get from one word to the other.
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

/// " (did you mean 'boundary'?)", or nothing if no word is near.
std::string suggestion(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  if (word.size() > kLongest) return "";
  std::string lower(word);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  const auto near = [&](std::string_view known) { return edit_distance(lower, known); };
  const auto best =
      std::min_element(kWords.begin(), kWords.end(),
                       [&](std::string_view a, std::string_view b) { return near(a) < near(b); });
  const std::size_t allowed = 1 + best->size() / 4;
  return near(*best) <= allowed ? fmt::format(" (did you mean '{}'?)", *best) : "";
}

/// A piece of the text fit for a message, whatever its length and bytes: no known word has letters
/// outside ASCII, and half a UTF-8 sequence would spoil a terminal or a JSON report.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result(text.substr(0, kLongest));
  for (char& c : result) {
    if (c < 0x20 || c > 0x7e) c = '?';
  }
  if (text.size() > kLongest) result += "...";
  return result;
}

class Parser {
 public:
  Parser(std::string_view text, const Mesh& mesh, const Topology& topology, Index first_id)
      : text_(text), mesh_(mesh), topology_(topology), first_id_(first_id) {}

  std::vector<char> parse() {
    skip_spaces();
    if (at_end()) fail(0, "it is empty; write 'none' to select nothing");
    std::vector<char> selected = term();
    for (skip_spaces(); !at_end(); skip_spaces()) {
      const char joint = text_[at_];
      if (!is_operator(joint))
        fail(at_, fmt::format("'+', '-' or '&' expected before '{}'", rest()));
      ++at_;
      skip_spaces();
      join(joint, selected, term());
    }
    return selected;
  }

 private:
  static void join(char joint, std::vector<char>& selected, const std::vector<char>& other) {
    for (std::size_t v = 0; v < selected.size(); ++v) {
      switch (joint) {
        case '+':
          selected[v] = selected[v] || other[v];
          break;
        case '-':
          selected[v] = selected[v] && !other[v];
          break;
        default:
          selected[v] = selected[v] && other[v];
      }
    }
  }

  std::vector<char> term() {
    const std::size_t start = at_;
    while (!at_end() && !is_space(text_[at_]) && !is_operator(text_[at_]) && text_[at_] != ':') {
      ++at_;
    }
    const bool has_list = !at_end() && text_[at_] == ':';
    if (has_list) ++at_;
    const std::string_view word = text_.substr(start, at_ - start);
    if (word == "id:") return ids(start);
    if (word == "box:") return box(start);
    if (word == "all") return constant(1);
    if (word == "none") return constant(0);
    if (word == "boundary") return topology_.boundary;
    if (word == "corners") return topology_.corners;
    if (word == "interface") return topology_.interface;
    if (word == "non_manifold") return topology_.non_manifold;
    if (word == "features") {
      std::vector<char> result = topology_.features;
      join('+', result, topology_.non_manifold);
      return result;
    }
    if (word.empty()) {
      fail(start, start == text_.size() ? "it ends where a term is expected"
                                        : fmt::format("a term is expected before '{}'", rest()));
    }
    const std::string_view hyphenated = word_with_hyphens(start);
    const std::string hint = suggestion(hyphenated);  // non-manifold
    if (!hint.empty()) fail(start, fmt::format("'{}' is not known{}", shown(hyphenated), hint));
    fail(start, fmt::format("'{}' is not known{}", shown(word), suggestion(word)));
  }

  std::string_view word_with_hyphens(std::size_t start) const {
    std::size_t end = start;
    while (end < text_.size() && !is_space(text_[end]) && text_[end] != '+' && text_[end] != '&') {
      ++end;
    }
    return text_.substr(start, end - start);
  }

  std::vector<char> constant(char value) const {
    return std::vector<char>(mesh_.point_count(), value);
  }

  std::vector<char> ids(std::size_t start) {
    // Ranges are opened and closed here and filled once, so overlapping ones cost nothing.
    std::vector<std::int64_t> opened(mesh_.point_count() + 1, 0);
    do {
      skip_spaces();
      const std::size_t place = at_;
      const std::uint64_t low = id(start);
      std::uint64_t high = low;
      // A minus with a digit right behind it makes a range; any other starts the next term.
      if (at_ + 1 < text_.size() && text_[at_] == '-' && is_digit(text_[at_ + 1])) {
        ++at_;
        high = id(start);
        if (high < low) fail(place, fmt::format("the range {}-{} runs backwards", low, high));
      }
      ++opened[low - first_id_];
      --opened[high - first_id_ + 1];
    } while (take_comma());
    std::vector<char> result(mesh_.point_count());
    std::int64_t open = 0;
    for (std::size_t v = 0; v < result.size(); ++v) result[v] = (open += opened[v]) > 0;
    return result;
  }

  /// A number that some vertex has.
  std::uint64_t id(std::size_t term_start) {
    const std::size_t start = at_;
    std::uint64_t value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (end == text_.data() + start) {
      fail(start,
           fmt::format("a vertex number is expected in '{}'", shown(text_.substr(term_start))));
    }
    at_ = static_cast<std::size_t>(end - text_.data());
    const std::uint64_t count = mesh_.point_count();
    if (error == std::errc() && value >= first_id_ && value - first_id_ < count) return value;
    const std::string_view number = text_.substr(start, at_ - start);
    if (count == 0)
      fail(start, fmt::format("there is no vertex {}: the mesh has none", shown(number)));
    fail(start, fmt::format("there is no vertex {}: this mesh numbers its vertices {} to {}",
                            shown(number), first_id_, first_id_ + (count - 1)));
  }

  std::vector<char> box(std::size_t start) {
    std::array<double, 6> bounds{};
    for (std::size_t i = 0; i < 6; ++i) {
      skip_spaces();
      bounds[i] = number(start);
      if (i < 5 && !take_comma()) {
        fail(at_, fmt::format("a box takes six numbers x0,y0,z0,x1,y1,z1; '{}' has {}",
                              shown(text_.substr(start, at_ - start)), i + 1));
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (bounds[axis] <= bounds[axis + 3]) continue;
      const char letter = "xyz"[axis];
      fail(start, fmt::format("the box holds nothing: {0}0 = {1} is greater than {0}1 = {2}",
                              letter, bounds[axis], bounds[axis + 3]));
    }
    const Vec3 low(bounds[0], bounds[1], bounds[2]);
    const Vec3 high(bounds[3], bounds[4], bounds[5]);
    std::vector<char> result(mesh_.point_count());
    for (std::size_t v = 0; v < result.size(); ++v) {
      const Vec3& p = mesh_.points()[v];
      result[v] = (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
    }
    return result;
  }

  /// A coordinate; infinite is one too, for boxes without end.
  double number(std::size_t term_start) {
    const std::size_t start = at_;
    if (!at_end() && text_[at_] == '+') ++at_;  // from_chars takes no plus
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) {
      fail(start,
           fmt::format("'{}' is no number a double can hold", shown({text_.data() + start, end})));
    }
    if (error != std::errc() || std::isnan(value)) {
      fail(start, fmt::format("a number is expected in '{}'", shown(text_.substr(term_start))));
    }
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  bool take_comma() {
    std::size_t next = at_;
    while (next < text_.size() && is_space(text_[next])) ++next;
    if (next == text_.size() || text_[next] != ',') return false;
    at_ = next + 1;
    return true;
  }
  void skip_spaces() {
    while (!at_end() && is_space(text_[at_])) ++at_;
  }
  bool at_end() const { return at_ == text_.size(); }
  std::string rest() const { return shown(text_.substr(at_)); }

  [[noreturn]] void fail(std::size_t place, std::string_view what) const {
    throw InvalidOption(fmt::format("selector '{}', character {}: {}. Known: {}", shown(text_),
                                    place + 1, what, kKnown));
  }

  std::string_view text_;
  const Mesh& mesh_;
  const Topology& topology_;
  std::uint64_t first_id_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<char> select_vertices(std::string_view text, const Mesh& mesh, const Topology& topology,
                                  Index first_id) {
  return Parser(text, mesh, topology, first_id).parse();
}

}  // namespace evenmesh
