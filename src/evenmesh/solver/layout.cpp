// SPDX-License-Identifier: MIT
#include "evenmesh/solver/layout.h"

#include <algorithm>
#include <numeric>

namespace evenmesh {
Layout::Layout(const Cells& cells, std::size_t points, const Orientation* orientation)
    : orientation_(orientation) {
  sort_cells(cells, points);
  colour_chunks();
}

void Layout::sort_cells(const Cells& cells, std::size_t points) {
  // Counting sort by the least vertex, then by kind within each chunk.
  std::vector<Index> least(cells.size());
  std::vector<std::uint32_t> start(points + 1, 0);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    least[c] = std::ranges::min(cells.vertices(c));
    ++start[least[c] + 1];
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
  for (std::size_t v = 0; v < points; v += kChunkSize) {
    const auto first = numbers_.begin() + start[v];
    const auto last = numbers_.begin() + start[std::min(v + kChunkSize, points)];
    const auto by_key = [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); };
    if (!std::is_sorted(first, last, by_key)) std::stable_sort(first, last, by_key);
    for (auto c = first; c != last;) {
      const auto end = std::find_if(c, last, [&](std::uint32_t d) { return key(d) != key(*c); });
      runs_.push_back({cells.kind(*c), static_cast<int>(cells.vertices(*c).size()), corners_.size(),
                       static_cast<std::size_t>(c - numbers_.begin()),
                       static_cast<std::size_t>(end - c)});
      for (; c != end; ++c) {
        const auto vertices = cells.vertices(*c);
        corners_.insert(corners_.end(), vertices.begin(), vertices.end());
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
        body(chunk, {{run.kind, run.vertices_per_cell, corners,
                      std::span(numbers_).subspan(run.first_cell, run.cells), orientation_},
                     run.first_cell});
      }
    });
  }
}

std::vector<std::vector<std::uint32_t>> colour_items(
    std::span<const std::vector<std::uint32_t>> resources, std::size_t count) {
  std::vector<std::vector<std::uint32_t>> taken(count);  // colours of a resource's items so far
  std::vector<std::vector<std::uint32_t>> colours;
  std::vector<char> blocked;  // per colour
  for (std::size_t i = 0; i < resources.size(); ++i) {
    blocked.assign(colours.size() + 1, 0);
    for (const std::uint32_t r : resources[i]) {
      for (const std::uint32_t colour : taken[r]) blocked[colour] = 1;
    }
    const auto colour =
        static_cast<std::uint32_t>(std::find(blocked.begin(), blocked.end(), 0) - blocked.begin());
    if (colour == colours.size()) colours.emplace_back();
    colours[colour].push_back(static_cast<std::uint32_t>(i));
    for (const std::uint32_t r : resources[i]) taken[r].push_back(colour);
  }
  return colours;
}

}  // namespace evenmesh
