// SPDX-License-Identifier: MIT
//
// A cost of one's own: a name and a loop over cells. This one pulls the vertices of every cell to
// its centre; with a fixed boundary the result is a Laplacian-like mesh.
#include <cstdio>

#include "evenmesh/solver/smooth.h"

namespace {

using namespace evenmesh;

/// sum over cells, vertices of |x_v - centre|^2
class Pull final : public Cost {
 public:
  std::string_view name() const override { return "pull"; }

  double evaluate(const CellBlock& cells, Points x, double weight,
                  std::span<Vec3> gradient) const override {
    double sum = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto cell = cells.cell(i);
      Vec3 centre = Vec3::Zero();
      for (const Index v : cell) centre += x[v];
      centre /= static_cast<double>(cell.size());
      for (const Index v : cell) {
        const Vec3 arm = x[v] - centre;
        sum += arm.squaredNorm();
        if (!gradient.empty()) gradient[v] += weight * 2.0 * arm;
      }
    }
    return weight * sum;
  }
};

Mesh disturbed_grid(int n, std::vector<char>& fixed) {
  std::vector<Vec3> points;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const bool edge = i == 0 || j == 0 || i == n || j == n;
      const double shift = edge ? 0.0 : 0.3;
      points.emplace_back(i + shift * std::sin(7.0 * i + 3.0 * j),
                          j + shift * std::cos(5.0 * i + 2.0 * j), 0.0);
      fixed.push_back(edge);
    }
  }
  Cells cells;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<Index>(j * (n + 1) + i);
      const auto up = static_cast<Index>(n + 1);
      cells.add(CellKind::quad, std::array<Index, 4>{a, a + 1, a + 1 + up, a + up});
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

}  // namespace

int main() {
  std::vector<char> fixed;
  Mesh mesh = disturbed_grid(20, fixed);
  Problem problem = make_problem(mesh, find_orientation(mesh), fixed);
  problem.terms = {{1.0, std::make_shared<Pull>()}};

  const Report report = smooth(mesh, problem);
  const auto& before = report.quality_before.of(Metric::shape);
  const auto& after = report.quality_after.of(Metric::shape);
  std::printf("worst shape %.3f -> %.3f in %zu iterations\n", before.worst, after.worst,
              report.history.size() - 1);
  return after.worst > 0.999 ? 0 : 1;
}
