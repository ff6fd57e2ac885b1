// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/phrases.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"

namespace evenmesh {
namespace {

// What a figure is called and how many numbers give it.
struct Figure {
  SlideOn on;
  std::string_view name;
  std::size_t numbers;  // 0: it cannot be given
  std::string_view form;
};

constexpr std::array<Figure, 8> kFigures = {{
    {SlideOn::line, "line", 6, "line:px,py,pz,dx,dy,dz"},
    {SlideOn::plane, "plane", 6, "plane:x=0 or plane:px,py,pz,nx,ny,nz"},
    {SlideOn::circle, "circle", 7, "circle:cx,cy,cz,nx,ny,nz,r"},
    {SlideOn::cylinder, "cylinder", 7, "cylinder:px,py,pz,ax,ay,az,r"},
    {SlideOn::sphere, "sphere", 4, "sphere:cx,cy,cz,r"},
    {SlideOn::features, "features", 0, "features"},
    {SlideOn::boundary, "boundary", 0, "boundary"},
    {SlideOn::surface, "surface", 0, "surface or surface=FILE"},
}};

constexpr std::string_view kSlideForm =
    "write for example 'boundary on circle', 'group:wall on plane:x=0' or 'all on "
    "surface=scan.stl'";

[[noreturn]] void fail(std::string_view option, std::string_view text, std::string_view what) {
  throw InvalidOption(fmt::format("{} '{}': {}", option, shown(text), what));
}

// The whole text as a finite number.
std::optional<double> to_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);  // from_chars takes no plus
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0;;) {
    const std::size_t end = text.find(separator, at);
    parts.push_back(trimmed(text.substr(at, end - at)));
    if (end == std::string_view::npos) return parts;
    at = end + 1;
  }
}

std::optional<std::vector<double>> to_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> number = to_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

void check_figure(const Figure& figure, const std::vector<double>& numbers, std::string_view text) {
  const bool has_direction = figure.numbers >= 6;
  if (has_direction && !(vector_at(numbers, 3).stableNorm() > 0.0)) {
    fail("--slide", text, "the direction is zero");
  }
  const bool has_radius = figure.on != SlideOn::line && figure.on != SlideOn::plane;
  if (has_radius && !(numbers.back() > 0.0)) {
    fail("--slide", text, fmt::format("the radius must be positive, not {}", numbers.back()));
  }
}

std::vector<double> figure_numbers(const Figure& figure, std::string_view given,
                                   std::string_view text) {
  if (figure.on == SlideOn::plane) {
    if (const std::optional<Plane> plane = try_plane(given)) {
      const Vec3& p = plane->point;
      const Vec3& n = plane->normal;
      return {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()};
    }
  }
  const auto numbers = to_numbers(given);
  if (figure.numbers == 0 || !numbers || numbers->size() != figure.numbers) {
    fail("--slide", text, fmt::format("write {}", figure.form));
  }
  check_figure(figure, *numbers, text);
  return *numbers;
}

const Figure& find_figure(std::string_view word, std::string_view text) {
  std::vector<std::string_view> names;
  for (const Figure& figure : kFigures) {
    if (figure.name == word) return figure;
    names.push_back(figure.name);
  }
  std::string list;
  for (const std::string_view known : names) list += fmt::format(" {}", known);
  fail("--slide", text,
       fmt::format("there is no sliding on '{}'{}; known are{}", shown(word),
                   suggestion(word, names), list));
}

// Where the last " word " stands that is a word of its own.
std::size_t last_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.rfind(word); at != std::string_view::npos && at > 0;
       at = text.rfind(word, at - 1)) {
    const std::size_t end = at + word.size();
    if (is_space(text[at - 1]) && end < text.size() && is_space(text[end])) return at;
  }
  return std::string_view::npos;
}

// Without the quotation marks around it, if it has two.
std::string_view unquoted(std::string_view text) {
  const bool is_quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') &&
                         text.front() == text.back();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

bool ends_open(std::string_view text) {
  return text.empty() || std::string_view("+-&,:=").find(text.back()) != std::string_view::npos;
}

bool starts_open(std::string_view text) {
  return text.empty() || std::string_view("+-&,=").find(text.front()) != std::string_view::npos;
}

bool looks_like_file(std::string_view text) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string_view::npos || dot + 1 == text.size()) return false;
  const std::string_view suffix = text.substr(dot + 1);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return is_letter(suffix.front()) && std::all_of(suffix.begin(), suffix.end(), [&](char c) {
           return is_letter(c) || (c >= '0' && c <= '9');
         });
}

}  // namespace

std::string_view name(SlideOn on) { return kFigures[static_cast<std::size_t>(on)].name; }

SlidePhrase parse_slide(std::string_view text) {
  const std::size_t on = last_word(text, "on");
  if (on == std::string_view::npos) {
    fail("--slide", text, fmt::format("'on' is missing; {}", kSlideForm));
  }
  SlidePhrase phrase;
  phrase.selector = trimmed(text.substr(0, on));
  const std::string_view what = trimmed(text.substr(on + 2));
  const std::size_t mark = what.find_first_of(":=");
  const Figure& figure = find_figure(trimmed(what.substr(0, mark)), text);
  phrase.on = figure.on;
  if (mark == std::string_view::npos) return phrase;
  const std::string_view given = trimmed(what.substr(mark + 1));
  if (figure.on == SlideOn::surface && what[mark] == '=' && !given.empty()) {
    phrase.file = given;
  } else {
    phrase.numbers = figure_numbers(figure, given, text);
  }
  return phrase;
}

std::optional<Plane> try_plane(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] >= 'x' && text[0] <= 'z') {
    const std::string_view rest = trimmed(text.substr(1));
    const auto value = rest.starts_with('=') ? to_number(rest.substr(1)) : std::nullopt;
    if (!value) return std::nullopt;
    const Vec3 axis = Vec3::Unit(text[0] - 'x');
    return Plane{*value * axis, axis};
  }
  const auto numbers = to_numbers(text);
  if (!numbers || numbers->size() != 6) return std::nullopt;
  const Vec3 normal = vector_at(*numbers, 3);
  const double length = normal.stableNorm();
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return Plane{vector_at(*numbers, 0), normal / length};
}

Plane parse_plane(std::string_view text) {
  if (const std::optional<Plane> plane = try_plane(text)) return *plane;
  throw InvalidOption(
      fmt::format("'{}' is no plane; write x=0, y=-1.5 or px,py,pz,nx,ny,nz (a point and a normal "
                  "that is not zero)",
                  shown(text)));
}

Length parse_length(std::string_view text, std::string_view what, Length::Unit allowed) {
  std::string_view digits = trimmed(text);
  Length length;
  double factor = 1.0;
  std::string example = "0.1";
  const auto take = [&](char sign, double times) {
    example += fmt::format(" or 0.2{}", sign);
    if (!digits.ends_with(sign)) return;
    digits.remove_suffix(1);
    length.unit = allowed;
    factor = times;
  };
  if (allowed == Length::Unit::of_edges) take('h', 1.0);
  if (allowed == Length::Unit::of_diagonal) take('%', 0.01);
  if (allowed == Length::Unit::of_mean_size) take('m', 1.0);
  const std::optional<double> value = to_number(digits);
  if (!value || !(*value > 0.0)) {
    fail(what, text, fmt::format("a positive number is expected, such as {}", example));
  }
  length.value = *value * factor;
  return length;
}

LimitPhrase parse_limit(std::string_view text) {
  const std::size_t word = last_word(text, "max-move");
  if (word == std::string_view::npos) {
    fail("--limit", text, "write SEL max-move D, for example 'boundary max-move 0.2h'");
  }
  LimitPhrase phrase;
  phrase.selector = trimmed(text.substr(0, word));
  phrase.distance = parse_length(text.substr(word + std::string_view("max-move").size()), "--limit",
                                 Length::Unit::of_edges);
  return phrase;
}

PeriodicPhrase parse_periodic(std::string_view text) {
  std::optional<PeriodicPhrase> found;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_space(text[at])) continue;
    const std::string_view first = trimmed(text.substr(0, at));
    const std::string_view second = trimmed(text.substr(at));
    if (ends_open(first) || starts_open(second)) continue;
    if (found && found->first == first) continue;  // more spaces at the same place
    if (found) {
      fail("--periodic", text,
           "it is not clear where the first side ends; write no spaces within a side");
    }
    found = PeriodicPhrase{std::string(first), std::string(second)};
  }
  if (!found) {
    fail("--periodic", text,
         "two sides are expected, for example 'x=0 x=1' or 'group:left group:right'");
  }
  return *found;
}

KeepPhrase parse_keep(std::string_view text) {
  const std::string_view whole = trimmed(text);
  std::size_t end = 0;
  while (end < whole.size() && !is_space(whole[end])) ++end;
  const std::string_view what = whole.substr(0, end);
  std::string_view rest = trimmed(whole.substr(end));
  KeepPhrase phrase;
  phrase.what = what == "volume" ? KeepPhrase::What::volume : KeepPhrase::What::area;
  const bool names_group =
      rest.starts_with("of") && rest.size() > 2 && is_space(rest[2]) && rest.size() > 3;
  if ((what != "area" && what != "volume") || (!rest.empty() && !names_group)) {
    fail("--keep", text, "write area, volume, 'area of GROUP' or 'volume of GROUP'");
  }
  if (rest.empty()) return phrase;
  std::string_view group = trimmed(rest.substr(3));
  if (group.starts_with("group:")) group = trimmed(group.substr(6));
  phrase.group = unquoted(group);
  if (phrase.group.empty()) fail("--keep", text, "which group? Write 'area of GROUP'");
  return phrase;
}

PrescribePhrase parse_prescribe(std::string_view text) {
  PrescribePhrase phrase;
  const std::size_t equals = text.find('=');
  std::string_view value = trimmed(text);
  if (equals != std::string_view::npos) {
    phrase.selector = trimmed(text.substr(0, equals));
    value = trimmed(text.substr(equals + 1));
    if (phrase.selector.empty()) fail("--prescribe", text, "which vertices? Write SEL = dx,dy,dz");
  }
  // A comma within brackets separates arguments of a function, not components.
  int depth = 0;
  std::size_t commas = 0;
  for (const char c : value) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    commas += c == ',' && depth == 0;
  }
  if (commas == 2 && equals != std::string_view::npos) {
    phrase.formulas = value;
    return phrase;
  }
  if (commas != 0 || !looks_like_file(value)) {
    fail("--prescribe", text,
         "write 'SEL = dx,dy,dz' (numbers or formulas in x, y and z), 'SEL = file.csv' or "
         "other_mesh.obj");
  }
  phrase.file = value;
  return phrase;
}

}  // namespace evenmesh
