// SPDX-License-Identifier: MIT
#include "evenmesh/solver/reduced_matrix.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

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

// The couplings of rows, each with all others that it is coupled to.
using Graph = std::vector<std::vector<std::uint32_t>>;
using Order = std::vector<std::uint32_t>;

Order minimum_degree_order(const Graph& graph) {
  if (graph.empty()) return {};  // for which Eigen reads beyond its arrays
  const auto size = static_cast<int>(graph.size());
  Eigen::SparseMatrix<double> pattern(size, size);
  Eigen::VectorXi sizes(size);
  for (int k = 0; k < size; ++k) {
    sizes[k] = static_cast<int>(graph[static_cast<std::size_t>(k)].size()) + 1;
  }
  pattern.reserve(sizes);
  for (int k = 0; k < size; ++k) {
    pattern.insert(k, k) = 1.0;
    for (const std::uint32_t other : graph[static_cast<std::size_t>(k)]) {
      pattern.insert(static_cast<int>(other), k) = 1.0;
    }
  }
  pattern.makeCompressed();
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

// Cuts rows in two halves by where they are, takes those of one half that are coupled to the other
// last, and goes on with what is left of the halves. (George 1973)
class Dissection {
 public:
  Dissection(const Graph& graph, Points x) : graph_(graph), x_(x), part_(graph.size(), 0) {
    Order all(graph.size());
    std::iota(all.begin(), all.end(), 0u);
    order_.reserve(all.size());
    cut(all);
  }
  const Order& order() const { return order_; }

 private:
  static constexpr std::size_t kSmall = 24;

  void cut(std::span<std::uint32_t> rows) {
    if (rows.size() <= kSmall) {
      std::sort(rows.begin(), rows.end());
      order_.insert(order_.end(), rows.begin(), rows.end());
      return;
    }
    const int axis = longest_axis(rows);
    const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
    std::nth_element(rows.begin(), middle, rows.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(x_[a][axis], a) < std::pair(x_[b][axis], b);
    });
    const std::uint32_t other = ++parts_;
    for (auto row = middle; row != rows.end(); ++row) part_[*row] = other;
    const auto border = std::partition(rows.begin(), middle, [&](std::uint32_t row) {
      return std::none_of(graph_[row].begin(), graph_[row].end(),
                          [&](std::uint32_t neighbour) { return part_[neighbour] == other; });
    });
    const Order between(border, middle);
    cut({rows.begin(), border});
    cut({middle, rows.end()});
    order_.insert(order_.end(), between.begin(), between.end());
  }

  int longest_axis(std::span<const std::uint32_t> rows) const {
    Vec3 low = x_[rows[0]];
    Vec3 high = low;
    for (const std::uint32_t row : rows) {
      low = low.cwiseMin(x_[row]);
      high = high.cwiseMax(x_[row]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  const Graph& graph_;
  Points x_;
  std::vector<std::uint32_t> part_;  // per row: the last second half that it was in
  std::uint32_t parts_ = 0;
  Order order_;
};

struct FactorSize {
  double entries = 0.0;
  double operations = 0.0;
};

// Follows the columns of the factor up the elimination tree. (Davis 2006, section 4.4)
FactorSize size_of_factor(const Graph& graph, const Order& order,
                          std::span<const std::uint8_t> unknowns) {
  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> place(graph.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  std::vector<std::uint32_t> parent(graph.size(), kNone);
  std::vector<std::uint32_t> mark(graph.size(), kNone);
  std::vector<double> below(graph.size(), 0.0);
  for (const std::uint32_t row : order) {
    mark[row] = row;
    for (std::uint32_t column : graph[row]) {
      if (place[column] > place[row]) continue;
      for (; mark[column] != row; column = parent[column]) {
        if (parent[column] == kNone) parent[column] = row;
        below[column] += unknowns[row];
        mark[column] = row;
      }
    }
  }
  FactorSize size;
  for (std::size_t k = 0; k < graph.size(); ++k) {
    const double column = below[k] + 0.5 * (unknowns[k] + 1);
    size.entries += unknowns[k] * column;
    size.operations += unknowns[k] * column * column;
  }
  return size;
}

}  // namespace

ReducedMatrix::ReducedMatrix(const Motion& motion, Points x, const Cliques& cliques)
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
  number(motion, x, coupled);
  set_up_pattern(coupled);
}

void ReducedMatrix::number(const Motion& motion, Points x,
                           const std::vector<std::vector<Index>>& coupled) {
  std::vector<std::uint32_t> place(motion.size(), 0);
  std::vector<Vec3> at;
  std::vector<std::uint8_t> unknowns;
  for (std::size_t k = 0; k < leaders_.size(); ++k) {
    place[leaders_[k]] = static_cast<std::uint32_t>(k);
    at.push_back(x[leaders_[k]]);
    unknowns.push_back(count_[leaders_[k]]);
  }
  Graph graph(leaders_.size());
  for (std::size_t k = 0; k < leaders_.size(); ++k) {
    for (const Index other : coupled[leaders_[k]]) graph[k].push_back(place[other]);
  }
  Order order = minimum_degree_order(graph);
  FactorSize size = size_of_factor(graph, order, unknowns);
  const Dissection dissection(graph, at);
  const FactorSize other = size_of_factor(graph, dissection.order(), unknowns);
  if (other.operations < size.operations) {
    order = dissection.order();
    size = other;
  }
  factor_entries_ = size.entries;
  factor_operations_ = size.operations;
  std::vector<Index> ordered;
  ordered.reserve(leaders_.size());
  for (const std::uint32_t k : order) ordered.push_back(leaders_[k]);
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
  for (const Index v : leaders_) {
    std::uint32_t above = 0;
    for (std::uint32_t n = neighbour_[v]; n < neighbour_[v + 1]; ++n) {
      above += count_[vertex_[neighbours_[n].first]];
    }
    for (std::uint32_t c = 0; c < count_[v]; ++c) {
      start[first_[v] + c + 1] = start[first_[v] + c] + static_cast<int>(above + c + 1);
    }
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
