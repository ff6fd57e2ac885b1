// SPDX-License-Identifier: MIT
#include "evenmesh/solver/reduced_matrix.h"

#include <algorithm>
#include <cassert>

#include <Eigen/OrderingMethods>

namespace evenmesh {
namespace {

int columns_of(Motion::Freedom freedom) {
  switch (freedom) {
    case Motion::Freedom::line:
      return 1;
    case Motion::Freedom::plane:
      return 2;
    case Motion::Freedom::free:
      return 3;
    default:
      return 0;
  }
}

// Numbers of rows in an order in which eliminating them fills in little.
std::vector<std::uint32_t> elimination_order(const std::vector<std::vector<std::uint32_t>>& graph) {
  Eigen::SparseMatrix<double> pattern(static_cast<int>(graph.size()),
                                      static_cast<int>(graph.size()));
  Eigen::VectorXi sizes(static_cast<int>(graph.size()));
  for (std::size_t k = 0; k < graph.size(); ++k) {
    sizes[static_cast<int>(k)] = static_cast<int>(graph[k].size()) + 1;
  }
  pattern.reserve(sizes);
  for (std::size_t k = 0; k < graph.size(); ++k) {
    const auto column = static_cast<int>(k);
    pattern.insert(column, column) = 1.0;
    for (const std::uint32_t other : graph[k])
      pattern.insert(static_cast<int>(other), column) = 1.0;
  }
  pattern.makeCompressed();
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

}  // namespace

ReducedMatrix::ReducedMatrix(const Motion& motion, const Cliques& cliques)
    : first_(motion.size(), kNone), count_(motion.size(), 0) {
  for (Index v = 0; v < motion.size(); ++v) {
    count_[v] = static_cast<std::uint8_t>(columns_of(motion.freedom(motion.leader(v))));
    most_ = std::max(most_, static_cast<int>(count_[v]));
    if (count_[v] > 0 && motion.leader(v) == v) leaders_.push_back(v);
  }
  std::vector<std::vector<Index>> coupled(motion.size());  // per leader: the others, both ways
  cliques([&](std::span<const Index> vertices) {
    for (const Index a : vertices) {
      for (const Index b : vertices) {
        const Index row = motion.leader(a);
        const Index column = motion.leader(b);
        if (row != column && count_[a] > 0 && count_[b] > 0) coupled[row].push_back(column);
      }
    }
  });
  for (std::vector<Index>& others : coupled) {
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
  }
  number(motion, coupled);
  set_up_pattern(coupled);
}

void ReducedMatrix::number(const Motion& motion, const std::vector<std::vector<Index>>& coupled) {
  std::vector<std::uint32_t> place(motion.size(), 0);
  for (std::size_t k = 0; k < leaders_.size(); ++k) {
    place[leaders_[k]] = static_cast<std::uint32_t>(k);
  }
  std::vector<std::vector<std::uint32_t>> graph(leaders_.size());
  for (std::size_t k = 0; k < leaders_.size(); ++k) {
    for (const Index other : coupled[leaders_[k]]) graph[k].push_back(place[other]);
  }
  std::vector<Index> ordered;
  ordered.reserve(leaders_.size());
  for (const std::uint32_t k : elimination_order(graph)) ordered.push_back(leaders_[k]);
  leaders_ = std::move(ordered);
  for (const Index v : leaders_) {
    first_[v] = static_cast<std::uint32_t>(vertex_.size());
    vertex_.insert(vertex_.end(), count_[v], v);
  }
  for (Index v = 0; v < motion.size(); ++v) first_[v] = first_[motion.leader(v)];
  axis_.assign(vertex_.size(), Vec3::Zero());
}

void ReducedMatrix::set_up_pattern(const std::vector<std::vector<Index>>& coupled) {
  neighbour_.assign(first_.size() + 1, 0);
  for (std::size_t v = 0; v < first_.size(); ++v) {
    std::uint32_t place = 0;
    const std::size_t begin = neighbours_.size();
    for (const Index other : coupled[v]) {
      if (first_[other] < first_[v]) neighbours_.push_back({first_[other], 0});
    }
    std::sort(neighbours_.begin() + static_cast<std::ptrdiff_t>(begin), neighbours_.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.first < b.first; });
    for (std::size_t n = begin; n < neighbours_.size(); ++n) {
      neighbours_[n].place = place;
      place += count_[vertex_[neighbours_[n].first]];
    }
    neighbour_[v + 1] = static_cast<std::uint32_t>(neighbours_.size());
  }

  const auto size = static_cast<int>(unknowns());
  matrix_.resize(size, size);
  int* const start = matrix_.outerIndexPtr();
  // Columns of the elimination tree, a vertex at a time. (Davis 2006, section 4.4)
  std::vector<std::uint32_t> parent(first_.size(), kNone);
  std::vector<std::uint32_t> mark(first_.size(), kNone);
  std::vector<double> entries(first_.size(), 0.0);
  for (const Index v : leaders_) {
    mark[v] = v;
    std::uint32_t above = 0;
    for (std::uint32_t n = neighbour_[v]; n < neighbour_[v + 1]; ++n) {
      Index other = vertex_[neighbours_[n].first];
      above += count_[other];
      for (; mark[other] != v; other = parent[other]) {
        if (parent[other] == kNone) parent[other] = v;
        entries[other] += count_[v];
        mark[other] = v;
      }
    }
    for (std::uint32_t c = 0; c < count_[v]; ++c) {
      start[first_[v] + c + 1] = start[first_[v] + c] + static_cast<int>(above + c + 1);
    }
  }
  for (const Index v : leaders_) {
    const double column = entries[v] + 0.5 * (count_[v] + 1);
    factor_entries_ += count_[v] * column;
    factor_operations_ += count_[v] * column * column;
  }
  matrix_.resizeNonZeros(start[size]);
  int* row = matrix_.innerIndexPtr();
  for (const Index v : leaders_) {
    for (std::uint32_t c = 0; c < count_[v]; ++c) {
      for (std::uint32_t n = neighbour_[v]; n < neighbour_[v + 1]; ++n) {
        const std::uint32_t first = neighbours_[n].first;
        for (std::uint32_t d = 0; d < count_[vertex_[first]]; ++d) {
          *row++ = static_cast<int>(first + d);
        }
      }
      for (std::uint32_t d = 0; d <= c; ++d) *row++ = static_cast<int>(first_[v] + d);
    }
  }
}

void ReducedMatrix::set_axes(const Motion& motion, const Motion::Places& places) {
  for (const Index v : leaders_) {
    Vec3* const axes = axis_.data() + first_[v];
    std::fill(axes, axes + count_[v], Vec3::Zero());
    switch (motion.freedom(v)) {
      case Motion::Freedom::line:
        axes[0] = places[motion.slot(v)].direction;
        break;
      case Motion::Freedom::plane: {
        const std::uint32_t slot = motion.slot(v);
        const Vec3 normal = slot == Motion::kNone ? motion.normal(v) : places[slot].direction;
        axes[0] = normal.unitOrthogonal();
        axes[1] = normal.cross(axes[0]);
        break;
      }
      case Motion::Freedom::free:
        for (int c = 0; c < 3; ++c) axes[c] = Vec3::Unit(c);
        break;
      case Motion::Freedom::fixed:
        break;
    }
  }
}

Eigen::VectorXd ReducedMatrix::reduced(Points g) const {
  Eigen::VectorXd y(static_cast<Eigen::Index>(unknowns()));
  for (std::size_t u = 0; u < unknowns(); ++u) {
    y[static_cast<Eigen::Index>(u)] = axis_[u].dot(g[vertex_[u]]);
  }
  return y;
}

void ReducedMatrix::expand(const Eigen::VectorXd& y, std::span<Vec3> step) const {
  std::fill(step.begin(), step.end(), Vec3::Zero());
  for (std::size_t u = 0; u < unknowns(); ++u) {
    step[vertex_[u]] += y[static_cast<Eigen::Index>(u)] * axis_[u];
  }
}

void ReducedMatrix::set_zero() {
  std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
}

// The entries of a vertex's rows, by its first unknown, in a column of the same or a later vertex.
double* ReducedMatrix::entries(std::uint32_t row_first, Index column_vertex, std::uint32_t column) {
  const Index leader = vertex_[first_[column_vertex]];
  double* const values = matrix_.valuePtr() + matrix_.outerIndexPtr()[column];
  const auto begin = neighbours_.begin() + neighbour_[leader];
  const auto end = neighbours_.begin() + neighbour_[leader + 1];
  if (row_first == first_[leader]) {
    return end == begin ? values : values + (end - 1)->place + count_[vertex_[(end - 1)->first]];
  }
  const auto found =
      std::lower_bound(begin, end, row_first,
                       [](const Neighbour& n, std::uint32_t first) { return n.first < first; });
  assert(found != end && found->first == row_first);
  return values + found->place;
}

void ReducedMatrix::add(std::span<const Index> vertices, const Eigen::MatrixXd& block) {
  const std::size_t stride = static_cast<std::size_t>(block.rows()) / vertices.size();
  for (std::size_t l = 0; l < vertices.size(); ++l) {
    const std::uint32_t column = first_[vertices[l]];
    if (column == kNone) continue;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const std::uint32_t row = first_[vertices[k]];
      if (row == kNone || row > column) continue;
      for (std::uint32_t d = 0; d < count_[vertices[l]]; ++d) {
        double* const values = entries(row, vertices[l], column + d);
        const std::uint32_t rows = row == column ? d + 1 : count_[vertices[k]];
        for (std::uint32_t c = 0; c < rows; ++c) {
          values[c] += block(static_cast<Eigen::Index>(stride * k + c),
                             static_cast<Eigen::Index>(stride * l + d));
        }
      }
    }
  }
}

void ReducedMatrix::lift_diagonal(double relative) {
  double* const values = matrix_.valuePtr();
  const int* const start = matrix_.outerIndexPtr();
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t u = 0; u < unknowns(); ++u) {
    const double diagonal = values[start[u + 1] - 1];
    sum += std::abs(diagonal);
    if (diagonal != 0.0) ++count;
  }
  const double mean = count > 0 ? sum / static_cast<double>(count) : 1.0;
  for (std::size_t u = 0; u < unknowns(); ++u) {
    double& diagonal = values[start[u + 1] - 1];
    if (axis_[u].isZero() || diagonal == 0.0) {
      diagonal = mean;
    } else {
      diagonal += relative * mean;
    }
  }
}

}  // namespace evenmesh
