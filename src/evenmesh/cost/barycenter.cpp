// SPDX-License-Identifier: MIT
#include "evenmesh/cost/barycenter.h"

#include <algorithm>
#include <array>

#include "evenmesh/cost/spread.h"

namespace evenmesh {
namespace {

// A radius shorter than this has no direction worth the name.
constexpr double kShortest = 1e-150;

double spread_of(Scaling scaling, std::span<const double> values, std::span<double> slopes) {
  return scaling == Scaling::absolute ? spread(values, slopes) : relative_spread(values, slopes);
}

// (d_1 - d_2)^2 is twice the spread of the two, and likewise relative to their mean.
double evaluate_quads(const CellBlock& cells, Points x, double weight, std::span<Vec3> gradient,
                      Scaling scaling) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto q = cells.cell(i);
    const Vec3 first = x[q[2]] - x[q[0]];
    const Vec3 second = x[q[3]] - x[q[1]];
    const std::array<double, 2> length{first.norm(), second.norm()};
    std::array<double, 2> slope;
    sum += 2.0 * spread_of(scaling, length, slope);

    if (gradient.empty()) continue;
    const Vec3 pull_first = (2.0 * weight * slope[0] / std::max(length[0], kShortest)) * first;
    const Vec3 pull_second = (2.0 * weight * slope[1] / std::max(length[1], kShortest)) * second;
    gradient[q[0]] -= pull_first;
    gradient[q[2]] += pull_first;
    gradient[q[1]] -= pull_second;
    gradient[q[3]] += pull_second;
  }
  return weight * sum;
}

double evaluate_others(const CellBlock& cells, Points x, double weight, std::span<Vec3> gradient,
                       Scaling scaling) {
  const auto count = static_cast<std::size_t>(cells.vertices_per_cell);
  std::vector<Vec3> radius(count);
  std::vector<double> length(count);
  std::vector<double> slope(count);
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    Vec3 centroid = Vec3::Zero();
    for (const Index v : cell) centroid += x[v];
    centroid /= static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      radius[k] = x[cell[k]] - centroid;
      length[k] = radius[k].norm();
    }
    sum += spread_of(scaling, length, slope);

    if (gradient.empty()) continue;
    // Moving a vertex moves the centroid by 1/count of that, and with it every radius.
    Vec3 mean_pull = Vec3::Zero();
    for (std::size_t k = 0; k < count; ++k) {
      radius[k] *= weight * slope[k] / std::max(length[k], kShortest);
      mean_pull += radius[k];
    }
    mean_pull /= static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) gradient[cell[k]] += radius[k] - mean_pull;
  }
  return weight * sum;
}

double relative_weight(Scaling scaling, std::span<const double> lengths) {
  if (scaling == Scaling::absolute) return 1.0;
  double mean = 0.0;
  for (const double l : lengths) mean += l;
  mean /= static_cast<double>(lengths.size());
  return mean > 0.0 ? 1.0 / (mean * mean) : 0.0;
}

}  // namespace

double Barycenter::evaluate(const CellBlock& cells, Points x, double weight,
                            std::span<Vec3> gradient) const {
  if (cells.kind == CellKind::triangle) return 0.0;
  if (cells.kind == CellKind::quad) return evaluate_quads(cells, x, weight, gradient, scaling_);
  return evaluate_others(cells, x, weight, gradient, scaling_);
}

// With r_k and directions d_k held, sum_k |r_k - m d_k|^2 bounds the spread of the radii from
// above and curves like sum_k 2 |x_k - centroid|^2, which is a spring of stiffness 2 / count
// between every two vertices.
void Barycenter::add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const {
  if (cells.kind == CellKind::triangle) return;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto cell = cells.cell(i);
    if (cells.kind == CellKind::quad) {
      const std::array<double, 2> length{(x[cell[2]] - x[cell[0]]).norm(),
                                         (x[cell[3]] - x[cell[1]]).norm()};
      const double stiffness = 4.0 * relative_weight(scaling_, length);
      springs.push_back({cell[0], cell[2], stiffness});
      springs.push_back({cell[1], cell[3], stiffness});
      continue;
    }
    Vec3 centroid = Vec3::Zero();
    for (const Index v : cell) centroid += x[v];
    centroid /= static_cast<double>(cell.size());
    std::vector<double> radius;
    for (const Index v : cell) radius.push_back((x[v] - centroid).norm());
    const double stiffness =
        2.0 * relative_weight(scaling_, radius) / static_cast<double>(cell.size());
    for (std::size_t a = 0; a < cell.size(); ++a) {
      // Huge polygons would need too many; a few stand in for all there.
      const std::size_t last =
          cell.size() <= 64 ? cell.size() - 1 : std::min(a + 1, cell.size() - 1);
      for (std::size_t b = a + 1; b <= last; ++b) {
        springs.push_back({cell[a], cell[b], stiffness});
      }
    }
  }
}

}  // namespace evenmesh
