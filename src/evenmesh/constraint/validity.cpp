// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/validity.h"

#include <algorithm>
#include <cmath>

#include "evenmesh/mesh/measure.h"

namespace evenmesh {
namespace {

constexpr int kRings = 2;
constexpr double kLeastPart = 0.05;  // of the mean size: what a cell counts as at least

bool counts(const Mesh& mesh, const Orientation& orientation, std::size_t cell) {
  const int dimension = orientation.type == MeshType::volume ? 3 : 2;
  return traits(mesh.cells().kind(cell)).dimension == dimension;
}

// Replaces each cell's value by the mean over its vertices of the mean over their cells.
void average(const Mesh& mesh, const std::vector<char>& counted, std::vector<double>& values) {
  std::vector<double> sum(mesh.point_count(), 0.0);
  std::vector<std::uint32_t> number(mesh.point_count(), 0);
  const Cells& cells = mesh.cells();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!counted[c]) continue;
    for (const Index v : cells.vertices(c)) {
      sum[v] += values[c];
      ++number[v];
    }
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!counted[c]) continue;
    double mean = 0.0;
    for (const Index v : cells.vertices(c)) mean += sum[v] / number[v];
    values[c] = mean / static_cast<double>(cells.vertices(c).size());
  }
}

}  // namespace

double mean_size(const Mesh& mesh, const Orientation& orientation) {
  double sum = 0.0;
  std::size_t number = 0;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    if (!counts(mesh, orientation, c)) continue;
    sum += oriented_size(mesh, orientation, c);
    ++number;
  }
  return number > 0 ? sum / static_cast<double>(number) : 0.0;
}

std::vector<double> reference_sizes(const Mesh& mesh, const Orientation& orientation) {
  const std::size_t n = mesh.cells().size();
  std::vector<double> sizes(n, 0.0);
  std::vector<char> counted(n, 0);
  double total = 0.0;
  std::size_t number = 0;
  for (std::size_t c = 0; c < n; ++c) {
    if (!counts(mesh, orientation, c)) continue;
    counted[c] = 1;
    sizes[c] = oriented_size(mesh, orientation, c);
    total += std::abs(sizes[c]);
    ++number;
  }
  for (int ring = 0; ring < kRings; ++ring) average(mesh, counted, sizes);
  const double mean = number > 0 ? total / static_cast<double>(number) : 0.0;
  for (std::size_t c = 0; c < n; ++c) {
    if (counted[c]) sizes[c] = std::max(sizes[c], kLeastPart * mean);
  }
  return sizes;
}

double ideal_determinant(CellKind kind) {
  if (kind == CellKind::polygon) return 2.0;
  const CellTraits& table = traits(kind);
  const auto at = [&](int i) {
    const auto& p = table.ideal[static_cast<std::size_t>(i)];
    return Vec3(p[0], p[1], p[2]);
  };
  return least_corner(kind, table.vertices, at, Vec3::UnitZ(), 1.0) /
         ideal_measure(kind, table.vertices);
}

}  // namespace evenmesh
