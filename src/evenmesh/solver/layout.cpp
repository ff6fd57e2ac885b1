// SPDX-License-Identifier: MIT
#include "evenmesh/solver/layout.h"

#include <algorithm>
#include <numeric>

#include "evenmesh/mesh/ordering.h"

namespace evenmesh {
namespace {

constexpr Index kUnused = ~Index{0};

// The vertices that cells use, in the order they are to be numbered.
std::vector<Index> choose_order(const Cells& cells, std::size_t points) {
  std::vector<char> used(points, 0);
  for (const Index v : cells.corners()) used[v] = 1;
  std::vector<Index> order;
  if (has_good_order(cells)) {
    order.resize(points);
    std::iota(order.begin(), order.end(), Index{0});
  } else {
    order = breadth_first_order(cells, points);
  }
  std::erase_if(order, [&](Index v) { return !used[v]; });
  return order;
}

}  // namespace

Layout::Layout(const Cells& cells, std::size_t points) : order_(choose_order(cells, points)) {
  std::vector<Index> number(points, kUnused);
  for (std::size_t k = 0; k < order_.size(); ++k) number[order_[k]] = static_cast<Index>(k);
  sort_cells(cells, number);
  colour_chunks();
}

void Layout::sort_cells(const Cells& cells, std::span<const Index> number) {
  // Counting sort by the least vertex, then by kind within each chunk.
  std::vector<Index> least(cells.size());
  std::vector<std::uint32_t> start(order_.size() + 1, 0);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Index low = kUnused;
    for (const Index v : cells.vertices(c)) low = std::min(low, number[v]);
    least[c] = low;
    ++start[low + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  numbers_.resize(cells.size());
  {
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      numbers_[next[least[c]]++] = static_cast<std::uint32_t>(c);
    }
  }
  const auto key = [&](std::uint32_t c) {
    return std::pair(cells.kind(c), cells.vertices(c).size());
  };
  corners_.reserve(cells.corners().size());
  chunk_start_ = {0};
  for (std::size_t v = 0; v < order_.size(); v += kChunkSize) {
    const auto first = numbers_.begin() + start[v];
    const auto last = numbers_.begin() + start[std::min(v + kChunkSize, order_.size())];
    const auto by_key = [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); };
    if (!std::is_sorted(first, last, by_key)) std::stable_sort(first, last, by_key);
    for (auto c = first; c != last;) {
      const auto end = std::find_if(c, last, [&](std::uint32_t d) { return key(d) != key(*c); });
      runs_.push_back({cells.kind(*c), static_cast<int>(cells.vertices(*c).size()), corners_.size(),
                       static_cast<std::size_t>(c - numbers_.begin()),
                       static_cast<std::size_t>(end - c)});
      for (; c != end; ++c) {
        for (const Index w : cells.vertices(*c)) corners_.push_back(number[w]);
      }
    }
    chunk_start_.push_back(runs_.size());
  }
}

void Layout::colour_chunks() {
  std::vector<std::vector<std::uint32_t>> reached(chunks());
  for (std::size_t c = 0; c < chunks(); ++c) {
    for (std::size_t r = chunk_start_[c]; r < chunk_start_[c + 1]; ++r) {
      const std::size_t last =
          runs_[r].first_corner +
          runs_[r].cells * static_cast<std::size_t>(runs_[r].vertices_per_cell);
      for (std::size_t i = runs_[r].first_corner; i < last; ++i) {
        const auto chunk = static_cast<std::uint32_t>(corners_[i] / kChunkSize);
        if (std::find(reached[c].begin(), reached[c].end(), chunk) == reached[c].end()) {
          reached[c].push_back(chunk);
        }
      }
    }
  }
  colours_ = colour_items(reached, chunks());
}

void Layout::for_blocks(
    Workers& workers,
    const std::function<void(std::size_t chunk, const Block& block)>& body) const {
  for (const std::vector<std::uint32_t>& colour : colours_) {
    workers.run(colour.size(), [&](std::size_t i) {
      const std::size_t chunk = colour[i];
      for (std::size_t r = chunk_start_[chunk]; r < chunk_start_[chunk + 1]; ++r) {
        const Run& run = runs_[r];
        const auto corners = std::span(corners_).subspan(
            run.first_corner, run.cells * static_cast<std::size_t>(run.vertices_per_cell));
        body(chunk, {{run.kind, run.vertices_per_cell, corners},
                     std::span(numbers_).subspan(run.first_cell, run.cells),
                     run.first_cell});
      }
    });
  }
}

std::vector<std::vector<std::uint32_t>> colour_items(
    std::span<const std::vector<std::uint32_t>> resources, std::size_t count) {
  std::vector<std::vector<std::uint32_t>> taken(count);  // colours of a resource's items so far
  std::vector<std::vector<std::uint32_t>> colours;
  std::vector<std::uint32_t> blocked;
  for (std::size_t i = 0; i < resources.size(); ++i) {
    blocked.clear();
    for (const std::uint32_t r : resources[i]) {
      blocked.insert(blocked.end(), taken[r].begin(), taken[r].end());
    }
    std::uint32_t colour = 0;
    while (std::find(blocked.begin(), blocked.end(), colour) != blocked.end()) ++colour;
    if (colour == colours.size()) colours.emplace_back();
    colours[colour].push_back(static_cast<std::uint32_t>(i));
    for (const std::uint32_t r : resources[i]) taken[r].push_back(colour);
  }
  return colours;
}

}  // namespace evenmesh
