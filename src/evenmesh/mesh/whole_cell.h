// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"

// The Jacobian determinant of a linear cell over the whole of it. A hex or wedge can have a
// positive one at every corner and a negative one in between.

namespace evenmesh {

/// Whether the Jacobian determinant is above zero everywhere in a volume cell, corners included.
///
/// - tet, pyramid: it is where it is at the corners of CellTraits.
/// - wedge: along each of the three edges between the triangles it is a quadratic, with Bernstein
///   coefficients d_0, d_1, d_2, and linear between them. It is above zero if and only if d_0 and
///   d_2 are and d_1 > -sqrt(d_0 d_2), on all three.
/// - hex: it has degree 2 in each variable and so 27 Bernstein coefficients, of which the eight at
///   the corners are values. It is above zero if these are and none is negative, and it is not if
///   one of the eight is not. Else the cell is halved until one or the other is so of the parts.
///
/// A hex whose determinant comes so near to zero that a thousand parts do not tell counts as not
/// positive. A map whose determinant is positive is one to one near every point of the cell.
///
/// Time: 0.2 microseconds for a hex that need not be halved; others allocate.
/// @param points  the vertices in the order of the kind, of a size whose sixth power is a double
/// @param sign    -1 if the cell is wound the other way on purpose, else 1
/// @pre  traits(kind).dimension == 3
/// @see  Johnen, Weill, Remacle, Robust and efficient validation of the linear hexahedral element,
///       Procedia Engineering 203 (2017) 271-283
bool is_positive_everywhere(CellKind kind, std::span<const Vec3> points, double sign);

/// The least Jacobian determinant: over the whole of a hex or wedge, over the corners of a tet or
/// pyramid. In the units of least_corner() (six times a tet's volume), and but for rounding never
/// greater than that.
///
/// A value that the determinant has, not more than 1e-12 of the greatest coefficient above the
/// least one, or as near to it as a thousand parts of a hex show. Parameters as above.
double least_determinant(CellKind kind, std::span<const Vec3> points, double sign);

}  // namespace evenmesh
