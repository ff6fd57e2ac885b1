// SPDX-License-Identifier: MIT
#include "evenmesh/io/face_list.h"

#include <numeric>
#include <utility>

#include <fmt/core.h>

namespace evenmesh {

void FaceList::reserve(std::size_t faces) {
  cells_.reserve(faces, 3 * faces);
  places_.reserve(faces);
}

void FaceList::add(std::span<const Index> vertices, std::uint64_t place, std::uint32_t group) {
  const std::size_t face = count_++;
  if (vertices.size() < 3) {
    if (places_.size() == face) {
      first_skipped_ = face;
      numbers_.resize(face);
      std::iota(numbers_.begin(), numbers_.end(), std::uint64_t{0});
    }
    return;
  }
  const CellKind kind = vertices.size() == 3   ? CellKind::triangle
                        : vertices.size() == 4 ? CellKind::quad
                                               : CellKind::polygon;
  cells_.add(kind, vertices, group);
  if (places_.size() < face) numbers_.push_back(face);
  places_.push_back(place);
}

std::vector<std::uint64_t> FaceList::take_numbers() { return std::move(numbers_); }

void FaceList::append_notes(std::vector<std::string>& notes) const {
  if (cells_.empty()) notes.push_back("The file has vertices but no faces.");
  if (cells_.size() == count_) return;
  notes.push_back(fmt::format(
      "{} of {} faces have fewer than three vertices (the first is face {}); they stay in the file "
      "but are no cells.",
      count_ - cells_.size(), count_, first_skipped_));
}

}  // namespace evenmesh
