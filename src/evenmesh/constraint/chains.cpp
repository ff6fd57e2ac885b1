// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/chains.h"

#include <algorithm>
#include <utility>

namespace evenmesh {
namespace {

class Cutter {
 public:
  Cutter(const EdgeNet& net, std::span<const char> ends)
      : net_(net), ends_(ends), seen_(net.vertex_count(), 0) {}

  std::vector<Chain> cut() {
    std::vector<Chain> chains;
    for (Index v = 0; v < seen_.size(); ++v) {
      if (!is_end(v)) continue;
      for (const Index next : net_.around(v)) {
        Chain chain{walk(v, next)};
        if (is_first_visit(chain.vertices)) chains.push_back(std::move(chain));
      }
    }
    for (Index v = 0; v < seen_.size(); ++v) {
      if (is_end(v) || seen_[v]) continue;
      Chain chain{walk(v, net_.around(v)[0]), true};
      chain.vertices.pop_back();
      is_first_visit(chain.vertices);
      chains.push_back(std::move(chain));
    }
    return chains;
  }

 private:
  bool is_end(Index v) const { return ends_[v] != 0 || net_.degree(v) != 2; }

  /// To the next end, or back to where it started.
  std::vector<Index> walk(Index start, Index next) const {
    std::vector<Index> path{start, next};
    while (!is_end(path.back()) && path.back() != start) {
      const auto around = net_.around(path.back());
      const Index before = path[path.size() - 2];
      path.push_back(around[0] == before ? around[1] : around[0]);
    }
    return path;
  }

  /// Every path between ends is met twice, once from each.
  bool is_first_visit(std::span<const Index> path) {
    const bool has_inner = path.size() > 2;
    if (!has_inner) return path.front() < path.back();
    if (seen_[path[1]]) return false;
    for (const Index v : path) seen_[v] = 1;
    return true;
  }

  const EdgeNet& net_;
  std::span<const char> ends_;
  std::vector<char> seen_;
};

}  // namespace

EdgeNet::EdgeNet(std::size_t vertex_count, std::span<const VertexPair> edges)
    : begins_(vertex_count + 1, 0), neighbours_(2 * edges.size()) {
  for (const auto& [a, b] : edges) {
    ++begins_[a + 1];
    ++begins_[b + 1];
  }
  for (std::size_t v = 1; v < begins_.size(); ++v) begins_[v] += begins_[v - 1];
  std::vector<Offset> next = begins_;
  for (const auto& [a, b] : edges) {
    neighbours_[next[a]++] = b;
    neighbours_[next[b]++] = a;
  }
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::sort(neighbours_.begin() + static_cast<std::ptrdiff_t>(begins_[v]),
              neighbours_.begin() + static_cast<std::ptrdiff_t>(begins_[v + 1]));
  }
}

bool EdgeNet::has(Index a, Index b) const {
  const auto list = around(a);
  return std::binary_search(list.begin(), list.end(), b);
}

std::vector<Chain> cut_into_chains(const EdgeNet& net, std::span<const char> ends) {
  return Cutter(net, ends).cut();
}

}  // namespace evenmesh
