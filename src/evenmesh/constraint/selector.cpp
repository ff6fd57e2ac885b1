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
#include "evenmesh/base/text.h"

namespace evenmesh {
namespace {

constexpr std::string_view kKnown =
    "all, none, boundary, features, corners, interface, non_manifold, id:1,5-9, "
    "box:x0,y0,z0,x1,y1,z1, group:NAME, nset:NAME, elset:NAME, marker:NAME, array:NAME==1, joined "
    "by + (and), - (without) or & (in both)";

constexpr std::array<std::string_view, 14> kWords = {
    "all", "none", "boundary", "features", "corners", "interface", "non_manifold",
    "id:", "box:", "group:",   "nset:",    "elset:",  "marker:",   "array:"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_operator(char c) { return c == '+' || c == '-' || c == '&'; }

/// "bolts" of "bracket.bolts": a set in a part of a deck may be called without the part.
std::string_view without_part(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

bool is_called(const NamedSet& set, std::string_view name) {
  return equal_but_for_case(set.name, name) || equal_but_for_case(without_part(set.name), name);
}

/// "cell.material"
std::string qualified(const DataArray& array) {
  return (array.on_cells ? "cell." : "point.") + array.name;
}

/// How an array's number is compared with one given. The longer ones come first.
struct Comparison {
  std::string_view sign;
  bool (*holds)(double number, double given);
};
constexpr std::array kComparisons{
    Comparison{"==", [](double a, double b) { return a == b; }},
    Comparison{"!=", [](double a, double b) { return a != b; }},
    Comparison{"<=", [](double a, double b) { return a <= b; }},
    Comparison{">=", [](double a, double b) { return a >= b; }},
    Comparison{"<", [](double a, double b) { return a < b; }},
    Comparison{">", [](double a, double b) { return a > b; }},
};

/// Calls visit for everything a group may be called: "o part, g left" also "o part", "part",
/// "g left" and "left".
template <typename Visit>
void for_each_name(std::string_view name, const Visit& visit) {
  if (name.empty()) return;
  visit(name);
  while (!name.empty()) {
    const std::size_t comma = std::min(name.find(", "), name.size());
    const std::string_view part = name.substr(0, comma);
    visit(part);
    const std::size_t space = part.find(' ');
    if (space != std::string_view::npos && space + 1 < part.size()) visit(part.substr(space + 1));
    name.remove_prefix(std::min(comma + 2, name.size()));
  }
}

/// What may help where a name is not known: the nearest, or those that there are.
std::string hint_or_list(std::string_view name, std::span<const std::string_view> known,
                         std::span<const std::string_view> listed) {
  if (known.empty()) return ": the file has none";
  const std::string hint = suggestion(name, known);
  if (!hint.empty()) return hint;
  constexpr std::size_t kListed = 8;
  std::string text;
  for (std::size_t i = 0; i < listed.size() && i < kListed; ++i) {
    text += fmt::format("{}'{}'", i > 0 ? ", " : "; the file has ", shown(listed[i]));
  }
  if (listed.size() > kListed) text += fmt::format(" and {} more", listed.size() - kListed);
  return text;
}

class Parser {
 public:
  Parser(std::string_view text, const Mesh& mesh, const Topology& topology, const FileNames& names)
      : text_(text), mesh_(mesh), topology_(topology), names_(names), groups_(names.groups) {}

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
    if (word == "group:") return group(start);
    if (word == "nset:" || word == "elset:" || word == "marker:") {
      return set(start, word.substr(0, word.size() - 1));
    }
    if (word == "array:") return array(start);
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
    const std::string hint = suggestion(hyphenated, kWords);  // non-manifold
    if (!hint.empty()) fail(start, fmt::format("'{}' is not known{}", shown(hyphenated), hint));
    fail(start, fmt::format("'{}' is not known{}", shown(word), suggestion(word, kWords)));
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

  struct Range {
    std::uint64_t low, high;
  };

  std::vector<char> ids(std::size_t start) {
    std::vector<Range> ranges;
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
      ranges.push_back({low, high});
    } while (take_comma());
    return with_corners(in_ranges(ranges));
  }

  /// Ranges are sorted and joined first, so overlapping ones cost nothing.
  std::vector<char> in_ranges(std::vector<Range>& ranges) const {
    std::sort(ranges.begin(), ranges.end(),
              [](const Range& a, const Range& b) { return a.low < b.low; });
    std::vector<Range> joined;
    for (const Range& range : ranges) {
      if (!joined.empty() && range.low <= joined.back().high) {
        joined.back().high = std::max(joined.back().high, range.high);
      } else {
        joined.push_back(range);
      }
    }
    std::vector<char> result(mesh_.point_count());
    for (std::size_t v = 0; v < result.size(); ++v) {
      const std::uint64_t number = names_.ids.empty() ? names_.first_id + v : names_.ids[v];
      const auto behind =
          std::upper_bound(joined.begin(), joined.end(), number,
                           [](std::uint64_t n, const Range& range) { return n < range.low; });
      result[v] = behind != joined.begin() && number <= behind[-1].high;
    }
    return result;
  }

  /// Nodes in the middle of edges stand for their corners.
  std::vector<char> with_corners(std::vector<char> selected) const {
    if (names_.followers == nullptr) return selected;
    for (std::size_t i = 0; i < names_.followers->size(); ++i) {
      if (!selected[names_.followers->vertex(i)]) continue;
      for (const Index v : names_.followers->leaders(i)) selected[v] = 1;
    }
    return selected;
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
    const std::string_view number = text_.substr(start, at_ - start);
    if (count == 0)
      fail(start, fmt::format("there is no vertex {}: the mesh has none", shown(number)));
    if (!names_.ids.empty()) {
      const auto [low, high] = std::minmax_element(names_.ids.begin(), names_.ids.end());
      if (error == std::errc() &&
          std::find(names_.ids.begin(), names_.ids.end(), value) != names_.ids.end()) {
        return value;
      }
      fail(start, fmt::format("there is no vertex {}: the numbers in this file, with gaps, are {} "
                              "to {}",
                              shown(number), *low, *high));
    }
    if (error == std::errc() && value >= names_.first_id && value - names_.first_id < count) {
      return value;
    }
    fail(start, fmt::format("there is no vertex {}: this mesh numbers its vertices {} to {}",
                            shown(number), names_.first_id, names_.first_id + (count - 1)));
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

  std::vector<char> group(std::size_t start) {
    skip_spaces();
    const std::size_t place = at_;
    std::string_view name = quoted();
    if (name.empty()) {
      name = longest_name();
      if (name.empty()) name = word_with_hyphens(place);
      at_ += name.size();
    }
    if (name.empty()) fail(start, "the name of a group is expected behind 'group:'");
    const std::vector<char> wanted = groups_of(place, name);
    const Cells& cells = mesh_.cells();
    std::vector<char> result(mesh_.point_count(), 0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (!wanted[cells.group(c)]) continue;
      for (const Index v : cells.vertices(c)) result[v] = 1;
    }
    return result;
  }

  std::vector<char> set(std::size_t start, std::string_view kind) {
    skip_spaces();
    const std::size_t place = at_;
    std::string_view name = quoted();
    if (name.empty()) {
      name = longest_set_name(kind);
      if (name.empty()) name = word_with_hyphens(place);
      at_ += name.size();
    }
    if (name.empty()) fail(start, fmt::format("a name is expected behind '{}:'", kind));
    std::vector<char> result(mesh_.point_count(), 0);
    bool found = false;
    for (const NamedSet& set : names_.sets) {
      if (set.kind != kind || !is_called(set, name)) continue;
      found = true;
      for (const Index v : set.vertices(mesh_.cells())) result[v] = 1;
    }
    if (!found) fail(place, no_such_set(kind, name));
    return with_corners(std::move(result));
  }

  std::string no_such_set(std::string_view kind, std::string_view name) const {
    std::vector<std::string_view> known;
    for (const NamedSet& set : names_.sets) {
      if (set.kind == kind) known.push_back(without_part(set.name));
    }
    return fmt::format("there is no {} '{}'", kind, shown(name)) + hint_or_list(name, known, known);
  }

  std::string_view longest_set_name(std::string_view kind) const {
    const std::string_view text = text_.substr(at_);
    std::size_t longest = 0;
    for (const NamedSet& set : names_.sets) {
      if (set.kind != kind) continue;
      for (const std::string_view called : {std::string_view(set.name), without_part(set.name)}) {
        const std::size_t size = called.size();
        if (size <= longest || !equal_but_for_case(text.substr(0, size), called)) continue;
        if (text.size() == size || is_space(text[size]) || is_operator(text[size])) longest = size;
      }
    }
    return text.substr(0, longest);
  }

  std::vector<char> array(std::size_t start) {
    skip_spaces();
    const std::size_t place = at_;
    std::string_view name = quoted();
    if (name.empty()) {
      while (!at_end() && std::string_view("=!<>").find(text_[at_]) == std::string_view::npos)
        ++at_;
      name = trimmed(text_.substr(place, at_ - place));
    }
    if (name.empty()) fail(start, "the name of an array is expected behind 'array:'");
    const DataArray& found = find_array(place, name);
    skip_spaces();
    const auto* const comparison =
        std::find_if(kComparisons.begin(), kComparisons.end(),
                     [this](const Comparison& c) { return text_.substr(at_).starts_with(c.sign); });
    if (comparison == kComparisons.end()) {
      fail(at_, fmt::format("a comparison is expected behind the array, as in array:{}==1",
                            shown(name)));
    }
    at_ += comparison->sign.size();
    skip_spaces();
    const double given = number(start);

    const std::vector<double> numbers = found.values();
    std::vector<char> result(mesh_.point_count(), 0);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!comparison->holds(numbers[i], given)) continue;
      if (!found.on_cells) {
        result[i] = 1;
      } else {
        for (const Index v : mesh_.cells().vertices(i)) result[v] = 1;
      }
    }
    return with_corners(std::move(result));
  }

  const DataArray& find_array(std::size_t place, std::string_view name) const {
    const DataArray* found = nullptr;
    std::vector<std::string_view> known;
    for (const DataArray& array : names_.arrays) {
      known.push_back(array.name);
      if (qualified(array) == name) return array;
      if (array.name != name) continue;
      if (found != nullptr) {
        fail(place, fmt::format("points and cells both have an array '{0}'; say 'point.{0}' or "
                                "'cell.{0}'",
                                shown(name)));
      }
      found = &array;
    }
    if (found != nullptr) return *found;
    fail(place,
         fmt::format("there is no array '{}' of one number per vertex or cell", shown(name)) +
             hint_or_list(name, known, known));
  }

  std::vector<char> groups_of(std::size_t place, std::string_view name) const {
    try {
      return find_groups(groups_, name);
    } catch (const InvalidOption& error) {
      fail(place, error.what());
    }
  }

  /// What stands between two quotation marks here, passed over; empty where there are none.
  std::string_view quoted() {
    if (at_end() || (text_[at_] != '"' && text_[at_] != '\'')) return {};
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == std::string_view::npos) fail(at_, "the closing quotation mark is missing");
    const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
    if (inside.empty()) fail(at_, "the name of a group is empty");
    at_ = end + 1;
    return inside;
  }

  /// Names may hold spaces and operators, so the longest that fits counts.
  std::string_view longest_name() const {
    const std::string_view text = text_.substr(at_);
    std::size_t longest = 0;
    for (std::size_t g = 1; g < groups_.size(); ++g) {
      for_each_name(groups_[g], [&](std::string_view name) {
        if (name.size() <= longest || !text.starts_with(name)) return;
        const bool ends = text.size() == name.size() || is_space(text[name.size()]) ||
                          is_operator(text[name.size()]);
        if (ends) longest = name.size();
      });
    }
    return text.substr(0, longest);
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
  const FileNames& names_;
  std::span<const std::string> groups_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<char> find_groups(std::span<const std::string> groups, std::string_view name) {
  std::vector<char> found(std::max<std::size_t>(groups.size(), 1), 0);
  std::vector<std::string_view> known;
  for (std::size_t g = 1; g < groups.size(); ++g) {
    for_each_name(groups[g], [&](std::string_view other) {
      found[g] = found[g] || other == name;
      known.push_back(other);
    });
  }
  if (std::find(found.begin(), found.end(), 1) != found.end()) return found;

  const std::vector<std::string_view> listed(groups.begin() + (groups.empty() ? 0 : 1),
                                             groups.end());
  throw InvalidOption(fmt::format("there is no group '{}'", shown(name)) +
                      hint_or_list(name, known, listed));
}

std::vector<char> select_vertices(std::string_view text, const Mesh& mesh, const Topology& topology,
                                  const FileNames& names) {
  return Parser(text, mesh, topology, names).parse();
}

}  // namespace evenmesh
