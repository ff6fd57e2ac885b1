// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/sides.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

/// Sides are sorted block by block of smallest vertices, so that a block's stay in the cache.
constexpr std::size_t kBlockBits = 12;
constexpr std::size_t kBlockSize = std::size_t{1} << kBlockBits;

constexpr std::size_t kUsesAhead = 64;  // as long as it takes memory to answer

constexpr Index kNone = std::numeric_limits<Index>::max();  // no mesh has that vertex

/// What tells a face from every other: its distinct vertices in increasing order.
struct FaceKey {
  std::array<Index, 4> vertices{kNone, kNone, kNone, kNone};
  bool forward = false;
};

/// @return all kNone for a face without extent
FaceKey face_key(const Cells& cells, std::uint32_t cell, std::uint8_t number) {
  const FaceVertices face = face_vertices(cells, cell, number);
  FaceKey key;
  if (face.count == 0) return key;
  std::copy_n(face.vertices.begin(), face.count, key.vertices.begin());
  const auto smallest = static_cast<std::size_t>(
      std::min_element(face.vertices.begin(), face.vertices.begin() + face.count) -
      face.vertices.begin());
  key.forward = face.vertices[(smallest + 1) % face.count] <
                face.vertices[(smallest + face.count - 1) % face.count];
  std::sort(key.vertices.begin(), key.vertices.end());
  return key;
}

std::uint16_t place_in_block(Index v) { return static_cast<std::uint16_t>(v % kBlockSize); }

/// Calls body(block, use) for every use of a side.
template <class Body>
void for_each_use(const Cells& cells, int dimension, Body body) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellTraits& kind = traits(cells.kind(i));
    if (kind.dimension != dimension) continue;
    const auto cell = static_cast<std::uint32_t>(i);
    if (dimension == 3) {
      for (std::uint8_t face = 0; face < kind.faces.size(); ++face) {
        const FaceKey key = face_key(cells, cell, face);
        if (key.vertices[0] == kNone) continue;
        const Index first = key.vertices[0];
        body(first >> kBlockBits,
             SideUse{key.vertices[1], cell, place_in_block(first), face, key.forward});
      }
    } else {
      const auto v = cells.vertices(i);  // edge j runs from vertex j to the next in every kind
      for (std::size_t j = 0; j < v.size(); ++j) {
        const Index a = v[j];
        const Index b = v[j + 1 == v.size() ? 0 : j + 1];
        if (a == b) continue;
        const Index first = std::min(a, b);
        body(first >> kBlockBits, SideUse{std::max(a, b), cell, place_in_block(first), 0, a < b});
      }
    }
  }
}

bool comes_before(const SideUse& a, const SideUse& b) {
  return std::tie(a.second, a.cell, a.face) < std::tie(b.second, b.cell, b.face);
}

void visit_side(Index first, std::span<const SideUse> uses,
                const std::function<void(const Side&)>& visit) {
  std::size_t count = 1;
  for (std::size_t i = 1; i < uses.size(); ++i) count += uses[i].cell != uses[i - 1].cell;
  visit({first, uses, count});
}

/// Puts the uses of equal faces next to each other. All have the same two smallest vertices.
class FaceSorter {
 public:
  explicit FaceSorter(const Cells& cells) : cells_(cells) {}

  void sort(std::span<SideUse> uses) {
    keyed_.clear();
    for (const SideUse& use : uses) {
      const FaceKey key = face_key(cells_, use.cell, use.face);
      keyed_.push_back({key.vertices[2], key.vertices[3], use});
    }
    std::sort(keyed_.begin(), keyed_.end(), [](const Keyed& a, const Keyed& b) {
      if (!is_same(a, b)) return std::tie(a.third, a.fourth) < std::tie(b.third, b.fourth);
      return comes_before(a.use, b.use);
    });
    for (std::size_t i = 0; i < uses.size(); ++i) uses[i] = keyed_[i].use;
  }
  /// After sort(): where the uses of the face at i end.
  std::size_t end_of(std::size_t i) const {
    std::size_t end = i + 1;
    while (end < keyed_.size() && is_same(keyed_[i], keyed_[end])) ++end;
    return end;
  }

 private:
  struct Keyed {
    Index third, fourth;
    SideUse use;
  };
  static bool is_same(const Keyed& a, const Keyed& b) {
    return a.third == b.third && a.fourth == b.fourth;
  }

  const Cells& cells_;
  std::vector<Keyed> keyed_;
};

/// Visits the sides that have one and the same smallest vertex.
/// @param uses  all of theirs, in any order
void visit_sides_of_vertex(Index first, int dimension, std::span<SideUse> uses, FaceSorter& faces,
                           const std::function<void(const Side&)>& visit) {
  std::sort(uses.begin(), uses.end(), comes_before);
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].second == uses[i].second) ++end;
    const auto run = uses.subspan(i, end - i);
    i = end;
    if (dimension == 2) {
      visit_side(first, run, visit);
      continue;
    }
    faces.sort(run);
    for (std::size_t from = 0; from < run.size();) {
      const std::size_t to = faces.end_of(from);
      visit_side(first, run.subspan(from, to - from), visit);
      from = to;
    }
  }
}

/// A counting sort of a block's uses by smallest vertex.
/// @param[out] ends  where the uses of each of the block's vertices end in sorted
void sort_block(std::span<const SideUse> uses, std::vector<SideUse>& sorted,
                std::array<std::size_t, kBlockSize>& ends) {
  ends.fill(0);
  for (const SideUse& use : uses) ++ends[use.place];
  std::size_t begin = 0;
  for (std::size_t& place : ends) begin += std::exchange(place, begin);
  sorted.resize(uses.size());
  for (const SideUse& use : uses) sorted[ends[use.place]++] = use;
}

}  // namespace

FaceVertices face_vertices(const Cells& cells, std::size_t cell, std::size_t number) {
  const CellTraits::Face& face = traits(cells.kind(cell)).faces[number];
  const auto vertices = cells.vertices(cell);
  FaceVertices result;
  for (std::size_t i = 0; i < face.count; ++i) {
    const Index v = vertices[face.vertices[i]];
    if (result.count == 0 || result.vertices[result.count - 1] != v) {
      result.vertices[result.count++] = v;
    }
  }
  while (result.count > 1 && result.vertices[0] == result.vertices[result.count - 1]) {
    --result.count;
  }
  // A quad a b a c is folded flat onto its diagonal: it bounds nothing.
  const bool folded = result.count == 4 && (result.vertices[0] == result.vertices[2] ||
                                            result.vertices[1] == result.vertices[3]);
  if (folded || result.count < 3) result.count = 0;
  return result;
}

void for_each_side(const Cells& cells, std::size_t vertex_count, int dimension,
                   const std::function<void(const Side&)>& visit,
                   const std::function<void(std::uint32_t cell)>& expect) {
  assert(dimension == 2 || dimension == 3);
  if (cells.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw InvalidMesh(fmt::format("{} cells are more than 32-bit numbers can count", cells.size()));
  }
  const std::size_t blocks = (vertex_count >> kBlockBits) + 1;
  std::vector<Offset> ends(blocks + 1, 0);
  for_each_use(cells, dimension, [&](Index block, const SideUse&) { ++ends[block + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<SideUse> uses(ends[blocks]);
  for_each_use(cells, dimension,
               [&](Index block, const SideUse& use) { uses[ends[block]++] = use; });

  FaceSorter faces(cells);
  std::vector<SideUse> sorted;
  std::array<std::size_t, kBlockSize> place_ends{};
  Offset block_begin = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    sort_block(std::span(uses).subspan(block_begin, ends[block] - block_begin), sorted, place_ends);
    block_begin = ends[block];
    std::size_t expected = 0;
    std::size_t begin = 0;
    for (std::size_t place = 0; place < kBlockSize; ++place) {
      const auto first = static_cast<Index>((block << kBlockBits) + place);
      const std::size_t ahead = std::min(place_ends[place] + kUsesAhead, sorted.size());
      for (; expect && expected < ahead; ++expected) expect(sorted[expected].cell);
      visit_sides_of_vertex(first, dimension,
                            std::span(sorted).subspan(begin, place_ends[place] - begin), faces,
                            visit);
      begin = place_ends[place];
    }
  }
}

}  // namespace evenmesh
