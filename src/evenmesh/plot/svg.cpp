// SPDX-License-Identifier: MIT
#include "evenmesh/plot/svg.h"

#include <cassert>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace evenmesh {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

struct Character {
  std::uint32_t code;
  std::size_t bytes;
  bool valid;
};

// How many bytes a character has whose first byte this is; 0 if none starts so.
std::size_t sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

bool is_allowed(std::uint32_t code, std::size_t bytes) {
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return code >= kLeast[bytes] && code <= 0x10FFFF && !control && !surrogate &&
         (code & 0xFFFE) != 0xFFFE;
}

// The character a text begins with. What is no UTF-8 counts as characters of one byte.
Character next_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = sequence_length(byte(0));
  if (length == 0 || length > text.size()) return {0, 1, false};
  std::uint32_t code = length == 1 ? byte(0) : byte(0) & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {0, 1, false};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  return {code, length, is_allowed(code, length)};
}

std::string point_list(std::span<const Pixel> places) {
  std::string list;
  for (const Pixel& p : places) {
    list += fmt::format("{}{},{}", list.empty() ? "" : " ", svg_number(p.x()), svg_number(p.y()));
  }
  return list;
}

}  // namespace

std::string svg_number(double value, int decimals) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string with_thousands(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ',');
  return text;
}

std::string svg_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = next_character(text);
    const std::string_view bytes = text.substr(0, character.bytes);
    if (bytes == "&") {
      result += "&amp;";
    } else if (bytes == "<") {
      result += "&lt;";
    } else if (bytes == ">") {
      result += "&gt;";
    } else if (bytes == "\"") {
      result += "&quot;";
    } else if (bytes == "'") {
      result += "&#39;";
    } else if (bytes == "\t" || bytes == "\n" || bytes == "\r") {
      result += ' ';
    } else {
      result += character.valid ? bytes : kReplacement;
    }
    text.remove_prefix(character.bytes);
  }
  return result;
}

std::string shortened(std::string_view text, std::size_t characters) {
  std::size_t bytes = 0;
  std::size_t before_last = 0;
  for (std::size_t n = 0; bytes < text.size(); ++n) {
    if (n == characters) return std::string(text.substr(0, before_last)) + "\u2026";
    before_last = bytes;
    bytes += next_character(text.substr(bytes)).bytes;
  }
  return std::string(text);
}

double text_width(std::string_view text, double size) {
  double ems = 0.0;
  while (!text.empty()) {
    const Character character = next_character(text);
    // Letters of scripts such as Chinese are square.
    ems += character.code >= 0x2E80                         ? 1.0
           : character.code >= 'A' && character.code <= 'Z' ? 0.7
                                                            : 0.58;
    text.remove_prefix(character.bytes);
  }
  return ems * size;
}

Svg::Svg(double width, double height)
    : text_(fmt::format(
          R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
          R"(font-family="Helvetica, Arial, sans-serif" fill="#222">)"
          "\n"
          R"(<rect width="{0}" height="{1}" rx="6" fill="#fff"/>)"
          "\n",
          svg_number(width), svg_number(height))) {}

void Svg::open(std::string_view attributes) {
  text_ += fmt::format("<g {}>\n", attributes);
  ++open_groups_;
}

void Svg::close() {
  assert(open_groups_ > 0);
  text_ += "</g>\n";
  --open_groups_;
}

void Svg::rectangle(const Pixel& corner, const Pixel& size, std::string_view attributes) {
  text_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n",
                       svg_number(corner.x()), svg_number(corner.y()), svg_number(size.x()),
                       svg_number(size.y()), attributes);
}

void Svg::line(const Pixel& from, const Pixel& to, std::string_view attributes) {
  text_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", svg_number(from.x()),
                       svg_number(from.y()), svg_number(to.x()), svg_number(to.y()), attributes);
}

void Svg::shape(std::string_view name, std::span<const Pixel> places, std::string_view attributes) {
  text_ += fmt::format("<{} points=\"{}\" {}/>\n", name, point_list(places), attributes);
}

void Svg::polyline(std::span<const Pixel> places, std::string_view attributes) {
  shape("polyline", places, attributes);
}

void Svg::polygon(std::span<const Pixel> places, std::string_view attributes) {
  shape("polygon", places, attributes);
}

void Svg::circle(const Pixel& middle, double radius, std::string_view attributes) {
  text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", svg_number(middle.x()),
                       svg_number(middle.y()), svg_number(radius), attributes);
}

void Svg::path(std::string_view data, std::string_view attributes) {
  text_ += fmt::format("<path d=\"{}\" {}/>\n", data, attributes);
}

void Svg::text(const Pixel& place, std::string_view text, std::string_view attributes,
               std::string_view raised) {
  text_ += fmt::format("<text x=\"{}\" y=\"{}\" {}>{}", svg_number(place.x()),
                       svg_number(place.y()), attributes, svg_escaped(text));
  if (!raised.empty()) {
    text_ += fmt::format(R"(<tspan dy="-5" font-size="10">{}</tspan>)", svg_escaped(raised));
  }
  text_ += "</text>\n";
}

std::string Svg::finish() && {
  assert(open_groups_ == 0);
  text_ += "</svg>\n";
  return std::move(text_);
}

}  // namespace evenmesh
