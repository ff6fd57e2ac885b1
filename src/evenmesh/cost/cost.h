// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/cell_kind.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// Cells of one kind with the same number of vertices, their vertex numbers one after the other.
struct CellBlock {
  CellKind kind = CellKind::triangle;
  int vertices_per_cell = 3;
  std::span<const Index> vertices;
  std::span<const std::uint32_t> numbers = {};  // the mesh's numbers of these cells
  const Orientation* orientation = nullptr;     // of the mesh; null: unknown

  std::size_t size() const { return vertices.size() / static_cast<std::size_t>(vertices_per_cell); }
  std::span<const Index> cell(std::size_t i) const {
    const auto n = static_cast<std::size_t>(vertices_per_cell);
    return vertices.subspan(i * n, n);
  }
  /// The direction about which a surface cell is positive; zero: its own normal.
  Vec3 up(std::size_t i) const { return orientation ? orientation->up(numbers[i]) : Vec3::Zero(); }
  /// -1 for a volume cell that is wound the other way on purpose, else 1.
  double sign(std::size_t i) const { return orientation ? orientation->sign(numbers[i]) : 1.0; }
  bool in_volume() const { return orientation && orientation->type == MeshType::volume; }
};

/// Two vertices that a cost pulls together: the term (stiffness / 2) |x_a - x_b|^2.
struct Spring {
  Index a, b;
  double stiffness;
};

/// Something that is low where cells are good: a sum over cells of a function of each cell's
/// vertices. Smoothing minimises a weighted sum of costs.
///
/// To add one, write evaluate() as a plain loop over the cells it is given. It need not think of
/// threads: no two blocks that share a vertex are evaluated at the same time, and blocks are
/// always added up in the same order. Implementations are const and hold no scratch data.
class Cost {
 public:
  virtual ~Cost() = default;

  /// The word for it everywhere: command line, reports, messages.
  virtual std::string_view name() const = 0;

  /// The weight times the sum of the cost over a block of cells.
  /// @param x         positions of all vertices, mesh length unit
  /// @param weight    factor of value and derivative alike
  /// @param gradient  one vector per vertex, to which the derivative of the returned value with
  ///                  respect to that vertex is added; empty: only the value is wanted
  /// @return          finite wherever all x are (short of overflow)
  virtual double evaluate(const CellBlock& cells, Points x, double weight,
                          std::span<Vec3> gradient) const = 0;

  /// Appends springs whose energy curves at least as strongly as the cost does near good cells:
  /// the quadratic model the solver preconditions with. It decides how fast, never where to, the
  /// solver goes. The default puts a spring of stiffness 2 on every edge of every cell, which
  /// suits costs that compare edge lengths.
  virtual void add_springs(const CellBlock& cells, Points x, std::vector<Spring>& springs) const;

  /// True if scaling the whole mesh towards a point can bring the cost to 0, so that it needs
  /// other costs or fixed vertices to hold against.
  virtual bool can_collapse() const { return false; }

  /// True if it pulls inverted cells this way and that: they are untangled with other costs first.
  virtual bool wants_valid_cells() const { return false; }
};

/// Whether a cost counts lengths as they are or relative to the cell's own size, so that weights
/// mean the same for fine and coarse meshes and large cells do not outvote small ones.
enum class Scaling { absolute, scale_free };

}  // namespace evenmesh
