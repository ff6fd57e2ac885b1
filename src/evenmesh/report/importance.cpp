// SPDX-License-Identifier: MIT
#include "evenmesh/report/importance.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "evenmesh/mesh/sides.h"
#include "evenmesh/report/run_record.h"

namespace evenmesh {
namespace {

class Ranking {
 public:
  explicit Ranking(const ShownMesh& shown)
      : shown_(shown), cells_(shown.before.cells()), taken_(cells_.size(), 0) {}

  Importance rank() && {
    const std::vector<std::size_t> worst = worst_cells(shown_.quality(), important(cells_.size()));
    for (const std::size_t c : worst) take(c);
    take_around(vertices_of(worst));
    take_around(farthest_moved());
    if (shown_.orientation.type == MeshType::volume) {
      take_evenly(on_boundary());
      result_.outer = result_.cells.size();
    }
    take_evenly(std::vector<char>(cells_.size(), 1));
    if (shown_.orientation.type != MeshType::volume) result_.outer = result_.cells.size();
    return std::move(result_);
  }

 private:
  void take(std::size_t cell) {
    if (taken_[cell] != 0) return;
    taken_[cell] = 1;
    result_.cells.push_back(static_cast<std::uint32_t>(cell));
  }

  std::vector<char> vertices_of(const std::vector<std::size_t>& cells) const {
    std::vector<char> marked(shown_.before.point_count(), 0);
    for (const std::size_t c : cells) {
      for (const Index v : cells_.vertices(c)) marked[v] = 1;
    }
    return marked;
  }

  std::vector<char> farthest_moved() const {
    const Points before = shown_.before.points();
    std::vector<char> marked(before.size(), 0);
    if (!shown_.has_after()) return marked;
    std::vector<Index> vertices(before.size());
    std::iota(vertices.begin(), vertices.end(), Index{0});
    const auto move = [&](Index v) { return (shown_.after[v] - before[v]).squaredNorm(); };
    const std::size_t count = std::min(important(cells_.size()), vertices.size());
    std::partial_sort(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(count),
                      vertices.end(), [&](Index a, Index b) {
                        const double p = move(a);
                        const double q = move(b);
                        return p != q ? p > q : a < b;
                      });
    for (std::size_t i = 0; i < count; ++i) marked[vertices[i]] = move(vertices[i]) > 0.0;
    return marked;
  }

  void take_around(const std::vector<char>& marked) {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto vertices = cells_.vertices(c);
      if (std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return marked[v] != 0; })) {
        take(c);
      }
    }
  }

  // Surface cells in a volume mesh are shown as its skin is.
  std::vector<char> on_boundary() const {
    std::vector<char> marked(cells_.size(), 0);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      marked[c] = traits(cells_.kind(c)).dimension == 2;
    }
    for_each_side(cells_, shown_.before.point_count(), 3, [&](const Side& side) {
      if (side.uses.size() == 1) marked[side.uses.front().cell] = 1;
    });
    return marked;
  }

  // By the bits of their place in the list, the last first: halves, then quarters, and so on.
  void take_evenly(const std::vector<char>& marked) {
    std::vector<std::uint32_t> rest;
    for (std::size_t c = 0; c < marked.size(); ++c) {
      if (marked[c] != 0 && taken_[c] == 0) rest.push_back(static_cast<std::uint32_t>(c));
    }
    const auto bits = static_cast<int>(std::bit_width(rest.size()));
    for (std::uint64_t i = 0; i < std::uint64_t{1} << bits; ++i) {
      std::uint64_t place = 0;
      for (int b = 0; b < bits; ++b) place |= (i >> b & 1U) << (bits - 1 - b);
      if (place < rest.size()) take(rest[place]);
    }
  }

  const ShownMesh& shown_;
  const Cells& cells_;
  std::vector<char> taken_;
  Importance result_;
};

}  // namespace

Importance rank_cells(const ShownMesh& shown) { return Ranking(shown).rank(); }

}  // namespace evenmesh
