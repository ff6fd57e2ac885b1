// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

namespace evenmesh {

/// How one of several curves looks: different in colour, and without colour too.
struct LineStyle {
  const char* colour;
  const char* dashes;  // of stroke-dasharray; empty: a whole line
};

/// Colours that every kind of colour vision tells apart on white.
/// @see  Okabe and Ito, Color universal design, 2008
inline constexpr std::array<LineStyle, 7> kLineStyles = {{{"#0072B2", ""},
                                                          {"#D55E00", "7 3"},
                                                          {"#009E73", "2 2.5"},
                                                          {"#000000", "9 3 2 3"},
                                                          {"#CC79A7", ""},
                                                          {"#E69F00", "7 3"},
                                                          {"#56B4E9", "2 2.5"}}};

/// Of cells that are turned over, in every picture.
inline constexpr const char* kInvertedColour = "#e0202f";
inline constexpr const char* kInvertedEdge = "#6b0010";

/// The colour of a goodness in [0, 1], dark to light at an even pace.
/// @param light  in [0, 1]; less of it makes the colour darker
/// @return       "#rrggbb"
std::string quality_colour(double goodness, double light = 1.0);

}  // namespace evenmesh
