// SPDX-License-Identifier: MIT
//
// A constraint of one's own: a formula of a few vertices' positions that must stay at a value. Here
// two neighbours in a grid shall be 1.25 apart while everything around them is made even.
#include <cmath>
#include <cstdio>

#include "evenmesh/constraint/function_of.h"
#include "evenmesh/solver/smooth.h"

namespace {

using namespace evenmesh;

constexpr int kSize = 6;

Index number(int i, int j) { return static_cast<Index>(j * (kSize + 1) + i); }

Mesh grid(std::vector<char>& fixed) {
  std::vector<Vec3> points;
  for (int j = 0; j <= kSize; ++j) {
    for (int i = 0; i <= kSize; ++i) {
      points.emplace_back(i, j, 0.0);
      fixed.push_back(i == 0 || j == 0 || i == kSize || j == kSize);
    }
  }
  Cells cells;
  for (int j = 0; j < kSize; ++j) {
    for (int i = 0; i < kSize; ++i) {
      cells.add(CellKind::quad, std::array<Index, 4>{number(i, j), number(i + 1, j),
                                                     number(i + 1, j + 1), number(i, j + 1)});
    }
  }
  return Mesh(std::move(points), std::move(cells));
}

}  // namespace

int main() {
  std::vector<char> fixed;
  Mesh mesh = grid(fixed);
  Problem problem = make_problem(mesh, find_orientation(mesh), fixed);

  const auto excess = function_of("excess", {number(2, 3), number(3, 3)},
                                  [](auto x) { return (x[1] - x[0]).norm() - 1.25; });
  problem.bounds.push_back({.function = excess, .lower = 0.0, .upper = 0.0});

  const double before = excess->at(mesh.points());
  // A perfect grid can only get worse by it, which has to be allowed.
  const Report report = smooth(mesh, problem, {.judge = Judge::inversion});
  const double after = excess->at(mesh.points());
  std::printf("excess %.6f -> %.6f, %s\n", before, after, name(report.stop).data());
  return std::abs(after) < 1e-6 ? 0 : 1;
}
