// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {

/// The measures of a cell. Names and formulas are those of Verdict and VTK where they have the
/// measure; docs/quality.md has them all.
enum class Metric : std::uint8_t {
  shape,            // inverse mean ratio, [0, 1], 1 ideal, 0 degenerate or inverted
  scaled_jacobian,  // least corner determinant over its edge lengths, [-1, 1], 1 ideal
  min_angle,        // smallest angle in degrees: between sides, in volume cells between faces
  max_angle,        // largest of the same
  aspect_ratio,     // >= 1, 1 ideal, infinite when degenerate
  edge_ratio        // longest over shortest edge, >= 1, infinite when degenerate
};

inline constexpr int kMetricCount = 6;
inline constexpr std::array<Metric, kMetricCount> kMetrics = {
    Metric::shape,     Metric::scaled_jacobian, Metric::min_angle,
    Metric::max_angle, Metric::aspect_ratio,    Metric::edge_ratio};

std::string_view name(Metric metric);  // the key in reports: "scaled_jacobian"
bool larger_is_better(Metric metric);
bool applies(Metric metric, CellKind kind);  // true: all of the above apply to every kind

/// True when a is a worse value of the metric than b. Never true for equal values; NaN is worse
/// than every number.
bool worse(Metric metric, double a, double b);

/// One measure of one cell.
/// @param corners  the cell's vertices in the order of its kind, mesh length unit
/// @param up       surface cells: the direction that counts as positive (any length), or zero to
///                 use the cell's own normal (which makes triangles positive always). Up only
///                 chooses the side: corners of a warped quad are judged by its own mean normal.
///                 Volume cells: ignored.
/// @param sign     volume cells: -1 if the cell is wound the other way on purpose, else 1
/// @return         never NaN; a cell with a coordinate that is not finite counts as collapsed
/// @pre  applies(metric, kind)
double measure(Metric metric, CellKind kind, std::span<const Vec3> corners, const Vec3& up,
               double sign = 1.0);

/// True when the cell is flat or turned over somewhere: its Jacobian determinant with respect to
/// up (or sign) is <= 0 at a corner or, in a hex or wedge, anywhere in it
/// (is_positive_everywhere()). False proves that a linear triangle, a planar quad and every volume
/// cell is valid as a whole, to rounding. A polygon is inverted when its signed area is <= 0: a
/// concave one is not.
bool is_inverted(CellKind kind, std::span<const Vec3> corners, const Vec3& up, double sign = 1.0);

}  // namespace evenmesh
