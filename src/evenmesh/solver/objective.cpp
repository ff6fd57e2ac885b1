// SPDX-License-Identifier: MIT
#include "evenmesh/solver/objective.h"

#include <algorithm>
#include <cassert>
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

}  // namespace

Objective::Objective(const Mesh& mesh, const Problem& problem)
    : problem_(problem),
      layout_(mesh.cells(), mesh.point_count()),
      motion_(problem.motion.renumbered(layout_.order())) {}

std::vector<Vec3> Objective::gather(Points of_mesh) const {
  std::vector<Vec3> x(size());
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = of_mesh[layout_.order()[k]];
  return x;
}

void Objective::scatter(Points of_layout, std::span<Vec3> of_mesh) const {
  for (std::size_t k = 0; k < of_layout.size(); ++k) {
    if (moves(motion_, static_cast<Index>(k))) of_mesh[layout_.order()[k]] = of_layout[k];
  }
}

double Objective::evaluate(Workers& workers, Points x, std::span<Vec3> gradient) const {
  assert(x.size() == size() && (gradient.empty() || gradient.size() == size()));
  for_ranges(workers, gradient.size(), [&](std::size_t first, std::size_t last) {
    std::fill(gradient.begin() + static_cast<std::ptrdiff_t>(first),
              gradient.begin() + static_cast<std::ptrdiff_t>(last), Vec3::Zero());
  });
  std::vector<double> partial(layout_.chunks(), 0.0);
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    for (const Term& term : problem_.terms) {
      partial[chunk] += term.cost->evaluate(block.cells, x, term.weight, gradient);
    }
  });
  for_ranges(workers, gradient.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      gradient[v] = motion_.project(static_cast<Index>(v), gradient[v]);
    }
  });
  double sum = 0.0;
  for (const double value : partial) sum += value;
  return sum;
}

SymmetricMatrix Objective::majoriser(Workers& workers, Points x) const {
  const auto for_springs = [&](const std::function<void(const Spring&)>& body) {
    layout_.for_blocks(workers, [&](std::size_t, const Layout::Block& block) {
      std::vector<Spring> springs;
      for (const Term& term : problem_.terms) {
        springs.clear();
        term.cost->add_springs(block.cells, x, springs);
        for (Spring& spring : springs) {
          if (spring.a == spring.b) continue;
          spring.stiffness *= term.weight;
          body(spring);
        }
      }
    });
  };

  SymmetricMatrix matrix;
  matrix.diagonal.assign(size(), 0.0f);
  SparseMatrix& off = matrix.off_diagonal;
  off.start.assign(size() + 1, 0);
  for_springs([&](const Spring& spring) {
    if (!moves(motion_, spring.a) || !moves(motion_, spring.b)) return;
    ++off.start[spring.a + 1];
    ++off.start[spring.b + 1];
  });
  for (std::size_t i = 0; i < size(); ++i) off.start[i + 1] += off.start[i];
  off.entries.resize(off.start.back());
  std::vector<std::uint64_t> next(off.start.begin(), off.start.end() - 1);
  for_springs([&](const Spring& spring) {
    const auto stiffness = static_cast<float>(spring.stiffness);
    const auto add = [&](Index row, Index column) {
      if (!moves(motion_, row)) return;
      // Two tangent planes at an angle: a step that is equal in both cannot be tangent to both.
      // What turning it costs is an anchor, without which a closed surface has none.
      const double bend = 1.0 - std::abs(motion_.normal(row).dot(motion_.normal(column)));
      const bool bends = !motion_.normal(row).isZero() && !motion_.normal(column).isZero();
      matrix.diagonal[row] += stiffness * (bends ? 1.0f + static_cast<float>(bend) : 1.0f);
      if (moves(motion_, column)) off.entries[next[row]++] = {column, -stiffness};
    };
    add(spring.a, spring.b);
    add(spring.b, spring.a);
  });
  merge_rows(workers, off);

  if (motion_.moving() == size()) {
    // Nothing holds the mesh in place; a slight pull everywhere makes the matrix definite.
    for (float& d : matrix.diagonal) d *= 1.001f;
  }
  return matrix;
}

}  // namespace evenmesh
