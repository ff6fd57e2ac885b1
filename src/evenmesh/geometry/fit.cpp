// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "evenmesh/geometry/perpendicular.h"

namespace evenmesh {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kGreatestRadius = 1e6;  // in units of the points' extent

/// The points moved to their mean and brought to a size of 1.
struct Centred {
  std::vector<Vec3> points;
  Vec3 mean = Vec3::Zero();
  double size = 0.0;      // what 1 is in the unit of the input; 0 if all points coincide
  double rounding = 0.0;  // of the input's coordinates, in the new unit

  Vec3 back(const Vec3& p) const { return mean + size * p; }
};

Centred centred(Points points) {
  Centred result;
  // Halves, because differences may overflow.
  const Vec3 first = points[0] / 2.0;
  for (const Vec3& p : points)
    result.mean += (p / 2.0 - first) / static_cast<double>(points.size());
  result.mean = points[0] + 2.0 * result.mean;
  double half = 0.0;
  double largest = 0.0;
  for (const Vec3& p : points) {
    half = std::max(half, (p / 2.0 - result.mean / 2.0).lpNorm<Eigen::Infinity>());
    largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  }
  if (!(half > 4.0 * kEpsilon * largest)) return result;
  result.size = 2.0 * half;
  result.rounding = kEpsilon * (largest / result.size);
  result.points.reserve(points.size());
  for (const Vec3& p : points) {
    result.points.push_back((p / 2.0 - result.mean / 2.0) / half);
  }
  return result;
}

/// Directions in which the points extend, most first, and how far: root of the sum of squares.
struct Axes {
  Eigen::Matrix3d direction;  // columns
  Vec3 extent;

  /// Do the points extend in that many directions, up to rounding?
  bool has_rank(int rank, const Centred& x) const {
    constexpr double kLeastRatio = 1e-12;
    const double n = std::sqrt(static_cast<double>(x.points.size()));
    return extent[rank - 1] > kLeastRatio * extent[0] + 4.0 * n * x.rounding;
  }
};

/// By singular values and not those of the covariance, of which half of the digits are lost.
Axes axes_of(std::span<const Vec3> vectors) {
  Eigen::MatrixXd rows(std::max<Eigen::Index>(3, static_cast<Eigen::Index>(vectors.size())), 3);
  rows.setZero();
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = vectors[i].transpose();
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
  const Eigen::Matrix3d upper = qr.matrixQR().topRows<3>().triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(upper, Eigen::ComputeFullV);
  return {svd.matrixV(), svd.singularValues()};
}

template <class FittedTrack>
Fit<FittedTrack> with_distance(const FittedTrack& track, Points points) {
  double greatest = 0.0;
  for (const Vec3& p : points) {
    greatest = std::max(greatest, (track.nearest(p, {}).position - p).stableNorm());
  }
  return {track, greatest};
}

/// A sphere to be improved: unknowns are the centre and the radius.
struct SphereModel {
  static constexpr int kUnknowns = 4;
  Vec3 centre = Vec3::Zero();
  double radius = 1.0;

  void begin_step() {}
  double residual(const Vec3& p, Eigen::Vector4d& gradient) const {
    const Vec3 d = p - centre;
    const double distance = d.norm();
    gradient << -(distance > 0.0 ? Vec3(d / distance) : Vec3(Vec3::Zero())), -1.0;
    return distance - radius;
  }
  SphereModel moved(const Eigen::Vector4d& step) const {
    return {centre + step.head<3>(), radius + step[3]};
  }
};

/// A cylinder: unknowns are where the axis is across itself (2), the radius and, if its direction
/// is sought too, by how much it tilts (2).
template <bool Tilts>
struct CylinderModel {
  static constexpr int kUnknowns = Tilts ? 5 : 3;
  using Row = Eigen::Matrix<double, kUnknowns, 1>;
  Vec3 point = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius = 1.0;
  Vec3 u = Vec3::UnitX();  // across the axis
  Vec3 v = Vec3::UnitY();

  void begin_step() {
    u = perpendicular(axis);
    v = axis.cross(u);
  }
  double residual(const Vec3& p, Row& gradient) const {
    const Vec3 d = p - point;
    const double along = d.dot(axis);
    const Vec3 across = d - along * axis;
    const double distance = across.norm();
    const Vec3 out = distance > 0.0 ? Vec3(across / distance) : Vec3(Vec3::Zero());
    gradient[0] = -out.dot(u);
    gradient[1] = -out.dot(v);
    gradient[2] = -1.0;
    if constexpr (Tilts) {
      gradient[3] = -along * out.dot(u);
      gradient[4] = -along * out.dot(v);
    }
    return distance - radius;
  }
  CylinderModel moved(const Row& step) const {
    CylinderModel result = *this;
    result.point += step[0] * u + step[1] * v;
    result.radius += step[2];
    if constexpr (Tilts) result.axis = (axis + step[3] * u + step[4] * v).normalized();
    return result;
  }
};

template <class Model>
struct Fitted {
  Model model;
  double sum_of_squares;
};

template <class Model>
double sum_of_squares(const Model& model, Points points) {
  Eigen::Matrix<double, Model::kUnknowns, 1> gradient;
  double sum = 0.0;
  for (const Vec3& p : points) {
    const double r = model.residual(p, gradient);
    sum += r * r;
  }
  return sum;
}

/// Gauss-Newton steps, damped as far as needed for the sum of squares to fall (Levenberg,
/// Marquardt), until it falls no more.
template <class Model>
Fitted<Model> improved(const Model& start, Points points) {
  constexpr int kMostSteps = 100;
  constexpr double kMostDamping = 1e12;
  constexpr double kConverged = 1e-3 * kEpsilon;  // the size of a step, where the points' is 1
  constexpr int kSize = Model::kUnknowns;
  Fitted<Model> best{start, sum_of_squares(start, points)};
  double damping = 1e-4;
  for (int step = 0; step < kMostSteps && damping < kMostDamping; ++step) {
    best.model.begin_step();
    Eigen::Matrix<double, kSize, kSize> normal = Eigen::Matrix<double, kSize, kSize>::Zero();
    Eigen::Matrix<double, kSize, 1> right = Eigen::Matrix<double, kSize, 1>::Zero();
    Eigen::Matrix<double, kSize, 1> gradient;
    for (const Vec3& p : points) {
      const double r = best.model.residual(p, gradient);
      normal += gradient * gradient.transpose();
      right -= r * gradient;
    }
    bool fell = false;
    for (; !fell && damping < kMostDamping; damping *= 10.0) {
      Eigen::Matrix<double, kSize, kSize> damped = normal;
      damped.diagonal() += damping * (normal.diagonal().array() + kEpsilon).matrix();
      const Eigen::Matrix<double, kSize, 1> move = damped.ldlt().solve(right);
      if (!move.allFinite()) continue;
      if (move.norm() <= kConverged) return best;
      const Model moved = best.model.moved(move);
      const double sum = sum_of_squares(moved, points);
      fell = sum < best.sum_of_squares;
      if (fell) best = {moved, sum};
    }
    if (!fell) break;
    damping *= 1e-3;  // the loop above has just multiplied it by ten
  }
  return best;
}

/// Where |p|^2 = 2 c . p + k in the least-squares sense; columns of axes are the directions of c.
struct AlgebraicRound {
  Vec3 centre;
  double radius;
};

AlgebraicRound algebraic_round(Points points,
                               const Eigen::Matrix<double, 3, Eigen::Dynamic>& axes) {
  const Eigen::Index unknowns = axes.cols() + 1;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  Eigen::VectorXd row(unknowns);
  for (const Vec3& p : points) {
    const Eigen::VectorXd q = axes.transpose() * p;
    row << 2.0 * q, 1.0;
    normal += row * row.transpose();
    right += q.squaredNorm() * row;
  }
  const Eigen::VectorXd solution = normal.colPivHouseholderQr().solve(right);
  const Eigen::VectorXd centre = solution.head(axes.cols());
  const double squared = solution[axes.cols()] + centre.squaredNorm();
  return {axes * centre, std::sqrt(std::max(squared, kEpsilon))};
}

bool is_reasonable(double radius) { return radius > 0.0 && radius <= kGreatestRadius; }

/// The cylinder about an axis of that direction.
template <class Model>
Model start_about(const Vec3& axis, Points points) {
  Model model;
  model.axis = axis;
  model.begin_step();
  Eigen::Matrix<double, 3, Eigen::Dynamic> across(3, 2);
  across << model.u, model.v;
  const AlgebraicRound round = algebraic_round(points, across);
  model.point = round.centre;
  model.radius = round.radius;
  return model;
}

/// Half of the directions to the faces, edges and corners of a cube.
std::vector<Vec3> starting_axes(const Eigen::Matrix3d& frame) {
  std::vector<Vec3> result;
  for (int x = 0; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const bool is_half = x > 0 || y > 0 || (y == 0 && z > 0);
        if (is_half) result.push_back((frame * Vec3(x, y, z)).normalized());
      }
    }
  }
  return result;
}

}  // namespace

std::optional<Fit<LineTrack>> fit_line(Points points) {
  if (points.size() < 2) return std::nullopt;
  const Centred x = centred(points);
  if (x.size == 0.0) return std::nullopt;
  const Axes axes = axes_of(x.points);
  if (!(axes.extent[0] - axes.extent[1] > 1e-6 * axes.extent[0])) return std::nullopt;
  return with_distance(LineTrack(x.mean, axes.direction.col(0)), points);
}

std::optional<Fit<PlaneTrack>> fit_plane(Points points) {
  if (points.size() < 3) return std::nullopt;
  const Centred x = centred(points);
  if (x.size == 0.0) return std::nullopt;
  const Axes axes = axes_of(x.points);
  if (!axes.has_rank(2, x)) return std::nullopt;
  if (!(axes.extent[1] - axes.extent[2] > 1e-6 * axes.extent[1])) return std::nullopt;
  return with_distance(PlaneTrack(x.mean, axes.direction.col(2)), points);
}

std::optional<Fit<CircleTrack>> fit_circle(Points points) {
  if (points.size() < 3) return std::nullopt;
  const Centred x = centred(points);
  if (x.size == 0.0) return std::nullopt;
  const Axes axes = axes_of(x.points);
  if (!axes.has_rank(2, x)) return std::nullopt;
  const Vec3 normal = axes.direction.col(2);
  const auto found = improved(start_about<CylinderModel<false>>(normal, x.points), x.points).model;
  if (!is_reasonable(found.radius)) return std::nullopt;
  return with_distance(CircleTrack(x.back(found.point), normal, x.size * found.radius), points);
}

std::optional<Fit<SphereTrack>> fit_sphere(Points points) {
  if (points.size() < 4) return std::nullopt;
  const Centred x = centred(points);
  if (x.size == 0.0) return std::nullopt;
  if (!axes_of(x.points).has_rank(3, x)) return std::nullopt;
  const AlgebraicRound start = algebraic_round(x.points, Eigen::Matrix3d::Identity());
  const SphereModel found = improved(SphereModel{start.centre, start.radius}, x.points).model;
  if (!is_reasonable(found.radius)) return std::nullopt;
  return with_distance(SphereTrack(x.back(found.centre), x.size * found.radius), points);
}

std::optional<Fit<CylinderTrack>> fit_cylinder(Points points, std::span<const Vec3> normals) {
  if (points.size() < 6) return std::nullopt;
  const Centred x = centred(points);
  if (x.size == 0.0) return std::nullopt;
  const Axes axes = axes_of(x.points);
  if (!axes.has_rank(3, x)) return std::nullopt;
  std::vector<Vec3> starts;
  if (!normals.empty()) starts.push_back(axes_of(normals).direction.col(2));
  const std::vector<Vec3> others = starting_axes(axes.direction);
  starts.insert(starts.end(), others.begin(), others.end());
  std::optional<Fitted<CylinderModel<true>>> best;
  for (const Vec3& axis : starts) {
    const auto found = improved(start_about<CylinderModel<true>>(axis, x.points), x.points);
    if (!is_reasonable(found.model.radius)) continue;
    if (!best || found.sum_of_squares < best->sum_of_squares) best = found;
  }
  if (!best) return std::nullopt;
  const CylinderModel<true>& found = best->model;
  // The point of the axis nearest to the middle of the points.
  const Vec3 point = found.point - found.axis.dot(found.point) * found.axis;
  return with_distance(CylinderTrack(x.back(point), found.axis, x.size * found.radius), points);
}

}  // namespace evenmesh
