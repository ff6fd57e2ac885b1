// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace evenmesh {

/// A place in a picture: pixels to the right and down.
using Pixel = Eigen::Vector2d;

/// The shortest decimal number within half a unit of the last of the decimals: "3", "-0.25". A
/// point in every locale, no exponent; what is not finite is "0", so that no picture is broken by
/// it.
std::string svg_number(double value, int decimals = 2);

/// "1,234,567".
std::string with_thousands(std::size_t number);

/// Text as it stands between tags or in an attribute: & < > and quotes as entities, bytes that are
/// not UTF-8 and characters that XML forbids as U+FFFD, white space as spaces.
std::string svg_escaped(std::string_view text);

/// The first characters of a text, with an ellipsis if that is not all. Never cuts a character.
std::string shortened(std::string_view text, std::size_t characters);

/// About how wide a text is in a sans-serif font, on the wide side.
/// @param size  of the font, pixels
double text_width(std::string_view text, double size);

/// Builds one SVG document from back to front.
///
/// Attributes are SVG as they stand (`fill="#fff"`); everything else is escaped.
class Svg {
 public:
  /// White, with a sans-serif font in dark grey.
  Svg(double width, double height);

  void open(std::string_view attributes);  // a group
  void close();
  void rectangle(const Pixel& corner, const Pixel& size, std::string_view attributes);
  void line(const Pixel& from, const Pixel& to, std::string_view attributes);
  void polyline(std::span<const Pixel> places, std::string_view attributes);
  void polygon(std::span<const Pixel> places, std::string_view attributes);
  void circle(const Pixel& middle, double radius, std::string_view attributes);
  void path(std::string_view data, std::string_view attributes);
  /// @param raised  in small letters above the line after the text, such as an exponent
  void text(const Pixel& place, std::string_view text, std::string_view attributes,
            std::string_view raised = {});
  /// Adds SVG as it stands.
  void raw(std::string_view markup) { text_ += markup; }

  /// The document, with a final newline.
  /// @pre  every group is closed
  std::string finish() &&;

 private:
  void shape(std::string_view name, std::span<const Pixel> places, std::string_view attributes);

  std::string text_;
  int open_groups_ = 0;
};

}  // namespace evenmesh
