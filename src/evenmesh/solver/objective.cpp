// SPDX-License-Identifier: MIT
#include "evenmesh/solver/objective.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>

namespace evenmesh {
namespace {

bool moves(const Motion& motion, Index v) { return motion.freedom(v) != Motion::Freedom::fixed; }

// Sorts a row's entries by column and adds up those of the same column; returns how many remain.
std::size_t merge_row(std::span<SparseMatrix::Entry> row) {
  std::sort(row.begin(), row.end(),
            [](const auto& a, const auto& b) { return a.column < b.column; });
  std::size_t kept = 0;
  for (const SparseMatrix::Entry& entry : row) {
    if (kept > 0 && row[kept - 1].column == entry.column) {
      row[kept - 1].value += entry.value;
    } else {
      row[kept++] = entry;
    }
  }
  return kept;
}

// Merges every row in place and closes the gaps.
void merge_rows(Workers& workers, SparseMatrix& matrix) {
  std::vector<std::uint32_t> kept(matrix.rows());
  for_ranges(workers, matrix.rows(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      kept[i] = static_cast<std::uint32_t>(merge_row(
          {matrix.entries.data() + matrix.start[i], matrix.entries.data() + matrix.start[i + 1]}));
    }
  });
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto from = matrix.entries.begin() + static_cast<std::ptrdiff_t>(matrix.start[i]);
    std::copy(from, from + kept[i], matrix.entries.begin() + static_cast<std::ptrdiff_t>(end));
    matrix.start[i] = end;
    end += kept[i];
  }
  matrix.start.back() = end;
  matrix.entries.resize(end);
  matrix.entries.shrink_to_fit();
}

bool is_usable(double stiffness) { return stiffness > 0.0 && std::isfinite(stiffness); }

// Binary exponents of stiffnesses, added up: whole numbers have no rounding.
struct Exponents {
  std::int64_t sum = 0;
  std::int64_t count = 0;

  void add(double stiffness) {
    if (!is_usable(stiffness)) return;
    sum += std::ilogb(stiffness);
    ++count;
  }
};

// A typical stiffness, as a power of two so that scaling by it is exact.
double typical(std::span<const Exponents> parts) {
  Exponents all;
  for (const Exponents& part : parts) {
    all.sum += part.sum;
    all.count += part.count;
  }
  if (all.count == 0) return 1.0;
  return std::ldexp(1.0,
                    static_cast<int>(std::clamp<std::int64_t>(all.sum / all.count, -900, 900)));
}

// The stiffness in units of the typical one. What lies far off, at cells that have all but
// collapsed, must not leave the range of single precision.
float in_range(double stiffness, double unit) {
  if (!(stiffness > 0.0)) return 0.0f;
  return static_cast<float>(std::clamp(stiffness / unit, 1e-12, 1e12));
}

// Pulls back slightly every row of a piece that has no held row.
void hold_free_pieces(std::vector<char> held, SymmetricMatrix& matrix) {
  std::vector<Index> next;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) next.push_back(static_cast<Index>(i));
  }
  while (!next.empty()) {
    const Index i = next.back();
    next.pop_back();
    for (const auto& entry : matrix.off_diagonal.row(i)) {
      if (held[entry.column]) continue;
      held[entry.column] = 1;
      next.push_back(entry.column);
    }
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) matrix.diagonal[i] *= 1.001f;
  }
}

}  // namespace

Objective::Objective(const Mesh& mesh, const Problem& problem)
    : problem_(problem),
      layout_(mesh.cells(), mesh.point_count(), &problem.orientation),
      motion_(problem.motion) {}

void Objective::constrain(Workers& workers, const Mesh& mesh, Points origin) {
  lagrangian_.emplace(workers, mesh, origin, problem_, layout_);
}

double Objective::sum_over_blocks(Workers& workers, std::span<Vec3> gradient,
                                  const std::function<double(const Layout::Block&)>& part) const {
  assert(gradient.empty() || gradient.size() == size());
  for_ranges(workers, gradient.size(), [&](std::size_t first, std::size_t last) {
    std::fill(gradient.begin() + static_cast<std::ptrdiff_t>(first),
              gradient.begin() + static_cast<std::ptrdiff_t>(last), Vec3::Zero());
  });
  std::vector<double> partial(layout_.chunks(), 0.0);
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    partial[chunk] += part(block);
  });
  double sum = 0.0;
  for (const double value : partial) sum += value;
  return sum;
}

double Objective::evaluate(Workers& workers, Points x, std::span<Vec3> gradient) const {
  assert(x.size() == size());
  const double cells = sum_over_blocks(
      workers, gradient, [&](const Layout::Block& block) { return evaluate(block, x, gradient); });
  return lagrangian_ ? cells + lagrangian_->evaluate_others(x, gradient) : cells;
}

double Objective::evaluate(const Layout::Block& block, Points x, std::span<Vec3> gradient) const {
  const double costs = cost(block, x, gradient);
  return lagrangian_ ? costs + lagrangian_->evaluate(block, x, gradient) : costs;
}

double Objective::cost(const Layout::Block& block, Points x, std::span<Vec3> gradient) const {
  double sum = 0.0;
  for (const Term& term : problem_.terms) {
    sum += term.cost->evaluate(block.cells, x, term.weight, gradient);
  }
  return sum;
}

double Objective::cost(Workers& workers, Points x, std::span<Vec3> gradient) const {
  return sum_over_blocks(workers, gradient,
                         [&](const Layout::Block& block) { return cost(block, x, gradient); });
}

double Objective::typical_stiffness(Points x) const {
  std::vector<Exponents> exponents(1);
  Workers alone;
  layout_.for_blocks(alone, [&](std::size_t, const Layout::Block& block) {
    std::vector<Spring> springs;
    for (const Term& term : problem_.terms) {
      springs.clear();
      term.cost->add_springs(block.cells, x, springs);
      for (const Spring& spring : springs) exponents[0].add(term.weight * spring.stiffness);
    }
  });
  return typical(exponents);
}

SymmetricMatrix Objective::majoriser(Workers& all_workers, Points x) const {
  // Springs of one chunk may add to rows of any other through tied vertices.
  Workers alone;
  Workers& workers = motion_.has_ties() ? alone : all_workers;
  const auto for_springs = [&](const std::function<void(std::size_t, const Spring&)>& body) {
    layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
      std::vector<Spring> springs;
      for (const Term& term : problem_.terms) {
        springs.clear();
        term.cost->add_springs(block.cells, x, springs);
        for (Spring& spring : springs) {
          spring.a = motion_.leader(spring.a);
          spring.b = motion_.leader(spring.b);
          if (spring.a == spring.b) continue;
          spring.stiffness *= term.weight;
          body(chunk, spring);
        }
      }
    });
  };

  SymmetricMatrix matrix;
  matrix.diagonal.assign(size(), 0.0f);
  SparseMatrix& off = matrix.off_diagonal;
  off.start.assign(size() + 1, 0);
  std::vector<Exponents> exponents(layout_.chunks());
  for_springs([&](std::size_t chunk, const Spring& spring) {
    exponents[chunk].add(spring.stiffness);
    if (!moves(motion_, spring.a) || !moves(motion_, spring.b)) return;
    ++off.start[spring.a + 1];
    ++off.start[spring.b + 1];
  });
  for (std::size_t i = 0; i < size(); ++i) off.start[i + 1] += off.start[i];
  off.entries.resize(off.start.back());
  std::vector<std::uint64_t> next(off.start.begin(), off.start.end() - 1);
  matrix.scale = typical(exponents);
  std::vector<char> held(size(), 0);  // per row: coupled to a fixed vertex
  for_springs([&](std::size_t, const Spring& spring) {
    const float stiffness = in_range(spring.stiffness, matrix.scale);
    const auto add = [&](Index row, Index column) {
      if (!moves(motion_, row)) return;
      matrix.diagonal[row] += stiffness;
      if (moves(motion_, column)) {
        off.entries[next[row]++] = {column, -stiffness};
      } else {
        held[row] = 1;
      }
    };
    add(spring.a, spring.b);
    add(spring.b, spring.a);
  });
  merge_rows(workers, off);
  // Where a vertex has a direction of its own, its piece cannot move as a whole.
  for (const Index v : motion_.slots()) held[v] = 1;
  hold_free_pieces(std::move(held), matrix);
  return matrix;
}

std::vector<Projector> Objective::projectors(const Motion::Places& places) const {
  std::vector<Projector> result;
  for (const Index v : motion_.slots()) {
    if (!moves(motion_, v) || motion_.leader(v) != v) continue;
    Eigen::Matrix3d matrix;
    for (int axis = 0; axis < 3; ++axis) {
      matrix.col(axis) = motion_.project(places, v, Vec3::Unit(axis));
    }
    result.push_back({v, matrix.cast<float>()});
  }
  std::sort(result.begin(), result.end(),
            [](const Projector& a, const Projector& b) { return a.row < b.row; });
  return result;
}

}  // namespace evenmesh
