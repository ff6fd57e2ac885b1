// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/whole_cell.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "evenmesh/mesh/measure.h"

namespace evenmesh {
namespace {

constexpr std::size_t kMostParts = 1000;   // that a hex is cut into
constexpr double kLeastTolerance = 1e-12;  // of the greatest coefficient
constexpr double kShare[3] = {1, 0.5, 1};  // of each product of two linear functions
constexpr std::size_t kStride[3] = {1, 3, 9};

double corners_alone(CellKind kind, std::span<const Vec3> points, double sign) {
  return least_corner(
      kind, static_cast<int>(points.size()),
      [&](int i) -> const Vec3& { return points[static_cast<std::size_t>(i)]; }, Vec3::Zero(),
      sign);
}

// ---- wedge -------------------------------------------------------------------------------------

/// The Bernstein coefficients of a quadratic on [0, 1].
struct Quadratic {
  double start, middle, end;

  bool is_positive() const {
    if (!(start > 0.0 && end > 0.0)) return false;
    return middle >= 0.0 || middle > -std::sqrt(start) * std::sqrt(end);
  }
  double least() const {
    const double ends = std::min(start, end);
    const double curvature = (start - middle) + (end - middle);
    if (!(middle < ends) || !(curvature > 0.0)) return ends;
    const double at = (start - middle) / curvature;
    return std::min(ends, (1.0 - at) * start + at * middle);  // the derivative there is zero
  }
};

/// det J along the edges between the triangles of a wedge. With r and s the sides of the triangle
/// at height t, both linear in t, and h the edge, linear in the triangle, it is (r x s) . h.
std::array<Quadratic, 3> along_edges(std::span<const Vec3> p, double sign) {
  const Vec3 r0 = p[1] - p[0];
  const Vec3 s0 = p[2] - p[0];
  const Vec3 r1 = p[4] - p[3];
  const Vec3 s1 = p[5] - p[3];
  const Vec3 start = sign * r0.cross(s0);
  const Vec3 middle = (0.5 * sign) * (r0.cross(s1) + r1.cross(s0));
  const Vec3 end = sign * r1.cross(s1);
  std::array<Quadratic, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 h = p[i + 3] - p[i];
    result[i] = {start.dot(h), middle.dot(h), end.dot(h)};
  }
  return result;
}

// ---- hex ---------------------------------------------------------------------------------------

/// det J on a part of a hex: coefficient (i, j, k) in u, v, w is at i + 3 j + 9 k.
using Part = std::array<double, 27>;

/// With a, b, c the derivatives in u, v, w, each without the variable of its own and linear in the
/// other two, det J is a . (b x c). Their Bernstein coefficients are the edges of the hex.
Part whole_hex(std::span<const Vec3> p, double sign) {
  const Vec3 a[2][2] = {{p[1] - p[0], p[5] - p[4]}, {p[2] - p[3], p[6] - p[7]}};  // [v][w]
  const Vec3 b[2][2] = {{p[3] - p[0], p[7] - p[4]}, {p[2] - p[1], p[6] - p[5]}};  // [u][w]
  const Vec3 c[2][2] = {{p[4] - p[0], p[7] - p[3]}, {p[5] - p[1], p[6] - p[2]}};  // [u][v]
  Part part{};
  for (std::size_t vc = 0; vc < 2; ++vc) {
    for (std::size_t wb = 0; wb < 2; ++wb) {
      const Vec3 normals[3] = {sign * b[0][wb].cross(c[0][vc]),
                               (0.5 * sign) * (b[0][wb].cross(c[1][vc]) + b[1][wb].cross(c[0][vc])),
                               sign * b[1][wb].cross(c[1][vc])};
      for (std::size_t va = 0; va < 2; ++va) {
        for (std::size_t wa = 0; wa < 2; ++wa) {
          const double share = kShare[va + vc] * kShare[wa + wb];
          double* row = &part[3 * (va + vc) + 9 * (wa + wb)];
          for (std::size_t u = 0; u < 3; ++u) row[u] += share * a[va][wa].dot(normals[u]);
        }
      }
    }
  }
  return part;
}

double least_coefficient(const Part& part) { return *std::min_element(part.begin(), part.end()); }

/// The least value at a corner.
double least_value(const Part& part) {
  return std::min({part[0], part[2], part[6], part[8], part[18], part[20], part[24], part[26]});
}

/// Calls visit(first, stride) for the nine rows of three coefficients along an axis.
template <typename Visit>
void for_rows(std::size_t axis, const Visit& visit) {
  const std::size_t one = kStride[(axis + 1) % 3];
  const std::size_t other = kStride[(axis + 2) % 3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) visit(i * one + j * other, kStride[axis]);
  }
}

/// The axis along which the coefficients are farthest from linear. Halving makes that a quarter;
/// where they are linear along an axis they are as near to the values as they get.
std::size_t most_curved_axis(const Part& part) {
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double curvature = 0.0;
    for_rows(axis, [&](std::size_t at, std::size_t step) {
      const double bend = part[at] - 2.0 * part[at + step] + part[at + 2 * step];
      curvature = std::max(curvature, std::abs(bend));
    });
    if (curvature > most) {
      most = curvature;
      best = axis;
    }
  }
  return best;
}

/// Makes a part its first half and returns the second (de Casteljau).
Part halve(Part& part, std::size_t axis) {
  Part second;
  for_rows(axis, [&](std::size_t at, std::size_t step) {
    const double before = 0.5 * (part[at] + part[at + step]);
    const double behind = 0.5 * (part[at + step] + part[at + 2 * step]);
    const double middle = 0.5 * (before + behind);
    second[at] = middle;
    second[at + step] = behind;
    second[at + 2 * step] = part[at + 2 * step];
    part[at + step] = before;
    part[at + 2 * step] = middle;
  });
  return second;
}

/// The least value over a hex lies between these.
struct Range {
  double least;  // coefficient of a part
  double value;  // at a corner of a part

  bool is_positive() const { return least >= 0.0 && value > 0.0; }
};

Range range_of(const Part& part) { return {least_coefficient(part), least_value(part)}; }

/// Halves a hex, always the part with the least coefficient, until is_enough(range) or there are
/// too many parts.
template <typename IsEnough>
Range narrowed(const Part& whole, const IsEnough& is_enough) {
  std::vector<Part> parts{whole};
  using Entry = std::pair<double, std::size_t>;  // least coefficient, which part
  std::vector<Entry> heap{{least_coefficient(whole), 0}};
  Range range = range_of(whole);
  while (!is_enough(range) && parts.size() < kMostParts) {
    const std::size_t first = heap.front().second;
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    heap.pop_back();
    parts.push_back(halve(parts[first], most_curved_axis(parts[first])));
    for (const std::size_t i : {first, parts.size() - 1}) {
      const Range half = range_of(parts[i]);
      range.value = std::min(range.value, half.value);
      heap.emplace_back(half.least, i);
      std::push_heap(heap.begin(), heap.end(), std::greater<>());
    }
    range.least = heap.front().first;
  }
  return range;
}

bool is_hex_positive(std::span<const Vec3> points, double sign) {
  const Part whole = whole_hex(points, sign);
  if (!(least_value(whole) > 0.0)) return false;
  if (least_coefficient(whole) >= 0.0) return true;
  const auto is_enough = [](const Range& r) { return r.least >= 0.0 || !(r.value > 0.0); };
  return narrowed(whole, is_enough).is_positive();
}

double least_of_hex(std::span<const Vec3> points, double sign) {
  const Part whole = whole_hex(points, sign);
  double greatest = 0.0;
  for (const double coefficient : whole) greatest = std::max(greatest, std::abs(coefficient));
  const auto is_enough = [&](const Range& r) {
    return r.least >= r.value - kLeastTolerance * greatest;
  };
  return narrowed(whole, is_enough).value;
}

}  // namespace

bool is_positive_everywhere(CellKind kind, std::span<const Vec3> points, double sign) {
  assert(traits(kind).dimension == 3);
  assert(points.size() == static_cast<std::size_t>(traits(kind).vertices));
  if (kind == CellKind::hex) return is_hex_positive(points, sign);
  if (kind != CellKind::wedge) return corners_alone(kind, points, sign) > 0.0;
  const auto edges = along_edges(points, sign);
  return std::all_of(edges.begin(), edges.end(),
                     [](const Quadratic& q) { return q.is_positive(); });
}

double least_determinant(CellKind kind, std::span<const Vec3> points, double sign) {
  assert(traits(kind).dimension == 3);
  assert(points.size() == static_cast<std::size_t>(traits(kind).vertices));
  if (kind == CellKind::hex) return least_of_hex(points, sign);
  if (kind != CellKind::wedge) return corners_alone(kind, points, sign);
  const auto edges = along_edges(points, sign);
  return std::min({edges[0].least(), edges[1].least(), edges[2].least()});
}

}  // namespace evenmesh
