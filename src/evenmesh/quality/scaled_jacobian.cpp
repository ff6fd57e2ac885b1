// SPDX-License-Identifier: MIT
#include "evenmesh/quality/scaled_jacobian.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

namespace evenmesh {
namespace {

constexpr double kTriangleScale = 2.0 / std::numbers::sqrt3;  // 1 / sin 60 degrees

/// 0 where the lengths are: a corner without a side is as bad as a flat one.
double ratio(double determinant, double lengths) {
  return lengths > 0.0 ? determinant / lengths : 0.0;
}

double clamped(double x) { return std::clamp(x, -1.0, 1.0); }

/// Every corner has the same determinant, so the longest edges decide.
double triangle_value(const SurfaceCell& cell) {
  double longest = 0.0;
  for (const auto& corner : cell.corners()) {
    longest = std::max(longest, corner.next * corner.previous);
  }
  return kTriangleScale * ratio(2.0 * cell.sign() * cell.area(), longest);
}

struct Lengths {
  double a, b, c;
  double product() const { return a * b * c; }
};

Lengths lengths(const VolumeCell::Corner& corner) {
  return {corner.a.norm(), corner.b.norm(), corner.c.norm()};
}

double tet_value(const VolumeCell& cell) {
  double longest = 0.0;
  for (const auto& corner : cell.corners()) {
    longest = std::max(longest, lengths(corner).product());
  }
  return std::numbers::sqrt2 * ratio(cell.corners()[0].determinant, longest);
}

double corner_value(const VolumeCell::Corner& corner) {
  return ratio(corner.determinant, lengths(corner).product());
}

double least_corner_value(const VolumeCell& cell) {
  double least = corner_value(cell.corners()[0]);
  for (const auto& corner : cell.corners().subspan(1)) {
    least = std::min(least, corner_value(corner));
  }
  return least;
}

/// The tet of three base vertices in a row and the apex has one determinant and, in the ideal
/// cell, edges of length 1 at its middle base vertex and at its apex alike; the longer of the two
/// triples of edges decides, so that both flat and pointed pyramids are seen.
double pyramid_value(const VolumeCell& cell) {
  std::array<Lengths, 4> base;
  for (std::size_t i = 0; i < 4; ++i) base[i] = lengths(cell.corners()[i]);
  double least = 1.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double at_apex = base[(i + 3) % 4].c * base[i].c * base[(i + 1) % 4].c;
    const double longest = std::max(base[i].product(), at_apex);
    least = std::min(least, std::numbers::sqrt2 * ratio(cell.corners()[i].determinant, longest));
  }
  return least;
}

}  // namespace

double scaled_jacobian(const SurfaceCell& cell) {
  if (cell.corners().size() == 3) return clamped(triangle_value(cell));
  double least = 1.0;
  for (const auto& corner : cell.corners()) {
    const double lengths = cell.regular().sine * corner.next * corner.previous;
    least = std::min(least, ratio(cell.sign() * corner.signed_area, lengths));
  }
  return clamped(least);
}

double scaled_jacobian(const VolumeCell& cell) {
  switch (cell.kind()) {
    case CellKind::tet:
      return clamped(tet_value(cell));
    case CellKind::wedge:
      return clamped(kTriangleScale * least_corner_value(cell));
    case CellKind::pyramid:
      return clamped(pyramid_value(cell));
    default:
      return clamped(std::min(corner_value(cell.axes()), least_corner_value(cell)));
  }
}

}  // namespace evenmesh
