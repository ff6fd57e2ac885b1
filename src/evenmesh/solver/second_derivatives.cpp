// SPDX-License-Identifier: MIT
#include "evenmesh/solver/second_derivatives.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <Eigen/Eigenvalues>

namespace evenmesh {
namespace {

// The cube root of the spacing of doubles balances rounding and truncation.
constexpr double kRelativeStep = 6e-6;
// Cells that are differentiated at a time, so that calls of costs have something to do.
constexpr std::size_t kCornersAtATime = 256;

// Cells, side by side and with vertices of their own, so that each can be moved by itself.
class Bench {
 public:
  Bench(const ReducedMatrix& unknowns, std::size_t corners)
      : unknowns_(unknowns), corners_(corners), stride_(unknowns.most()) {}

  void lay_out(std::span<const Index> vertices, Points x, double unit) {
    vertices_ = vertices;
    own_.clear();
    for (const Index v : vertices) own_.push_back(x[v]);
    steps_.clear();
    const auto size = static_cast<Eigen::Index>(corners_) * stride_;
    blocks_.assign(cells(), Eigen::MatrixXd::Zero(size, size));
    for (std::size_t e = 0; e < cells(); ++e) {
      double extent = 0.0;
      for (std::size_t k = 1; k < corners_; ++k) {
        extent = std::max(extent, (own_[e * corners_ + k] - own_[e * corners_]).norm());
      }
      steps_.push_back(kRelativeStep * (extent > 0.0 ? extent : unit));
    }
    plus_.resize(own_.size());
    minus_.resize(own_.size());
  }

  // One column of every cell's block at a time.
  template <typename Gradient>
  void differentiate(const Gradient& gradient) {
    for (std::size_t k = 0; k < corners_; ++k) {
      for (int c = 0; c < stride_; ++c) {
        if (!move(k, c, 1.0)) continue;
        const std::vector<Vec3> ahead = own_;
        gradient(own_, plus_);
        move(k, c, -2.0);
        gradient(own_, minus_);
        for (std::size_t e = 0; e < cells(); ++e) set_column(e, k, c, ahead);
        put_back(k);
      }
    }
  }

  void hand_out(const TakeBlock& take) {
    for (std::size_t e = 0; e < cells(); ++e) {
      blocks_[e] = 0.5 * (blocks_[e] + blocks_[e].transpose()).eval();
      take(vertices_.subspan(e * corners_, corners_), blocks_[e]);
    }
  }

 private:
  std::size_t cells() const { return own_.size() / corners_; }

  // Along the c-th axis of the k-th vertex of every cell; false if none has one.
  bool move(std::size_t k, int c, double factor) {
    bool any = false;
    if (factor > 0.0) before_ = own_;
    for (std::size_t e = 0; e < cells(); ++e) {
      const Vec3 along = axis(e, k, c);
      if (along.isZero()) continue;
      any = true;
      own_[e * corners_ + k] += factor * steps_[e] * along;
    }
    return any;
  }
  void put_back(std::size_t k) {
    for (std::size_t e = 0; e < cells(); ++e) own_[e * corners_ + k] = before_[e * corners_ + k];
  }

  Vec3 axis(std::size_t e, std::size_t k, int c) const {
    const Index v = vertices_[e * corners_ + k];
    if (c >= unknowns_.count(v)) return Vec3::Zero();
    return unknowns_.axis(unknowns_.first(v) + static_cast<std::uint32_t>(c));
  }

  void set_column(std::size_t e, std::size_t k, int c, Points ahead) {
    const std::size_t i = e * corners_ + k;
    const double length = axis(e, k, c).dot(ahead[i] - own_[i]);  // as rounded
    if (length == 0.0) return;
    const auto column = static_cast<Eigen::Index>(k) * stride_ + c;
    for (std::size_t l = 0; l < corners_; ++l) {
      const Vec3 change = (plus_[e * corners_ + l] - minus_[e * corners_ + l]) / length;
      for (int d = 0; d < stride_; ++d) {
        blocks_[e](static_cast<Eigen::Index>(l) * stride_ + d, column) = axis(e, l, d).dot(change);
      }
    }
  }

  const ReducedMatrix& unknowns_;
  std::size_t corners_;
  int stride_;
  std::span<const Index> vertices_;
  std::vector<Vec3> own_, before_, plus_, minus_;
  std::vector<double> steps_;
  std::vector<Eigen::MatrixXd> blocks_;
};

}  // namespace

void differentiate_cells(const Objective& objective, const Layout::Block& block, Points x,
                         const ReducedMatrix& unknowns, double unit, const TakeBlock& take) {
  const auto corners = static_cast<std::size_t>(block.cells.vertices_per_cell);
  const std::size_t at_a_time = std::max<std::size_t>(1, kCornersAtATime / corners);
  Bench bench(unknowns, corners);
  std::vector<Index> own(at_a_time * corners);
  std::iota(own.begin(), own.end(), Index{0});
  for (std::size_t i = 0; i < block.cells.size(); i += at_a_time) {
    const std::size_t count = std::min(at_a_time, block.cells.size() - i);
    bench.lay_out(block.cells.vertices.subspan(i * corners, count * corners), x, unit);
    Layout::Block local = block;
    local.cells.vertices = std::span(own).first(count * corners);
    local.cells.numbers = block.cells.numbers.subspan(i, count);
    local.first = block.first + i;
    bench.differentiate([&](Points at, std::span<Vec3> gradient) {
      std::fill(gradient.begin(), gradient.end(), Vec3::Zero());
      objective.evaluate(local, at, gradient);
    });
    bench.hand_out(take);
  }
}

void differentiate_function(std::span<const Index> vertices, Points x,
                            const ReducedMatrix& unknowns, double unit,
                            const std::function<void(Points own, std::span<Vec3> g)>& gradient,
                            const TakeBlock& take) {
  Bench bench(unknowns, vertices.size());
  bench.lay_out(vertices, x, unit);
  bench.differentiate(gradient);
  bench.hand_out(take);
}

void clamp_eigenvalues(Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  if (solver.eigenvalues().size() == 0 || !(solver.eigenvalues()[0] < 0.0)) return;
  matrix = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
           solver.eigenvectors().transpose();
}

}  // namespace evenmesh
