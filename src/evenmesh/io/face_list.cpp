// SPDX-License-Identifier: MIT
#include "evenmesh/io/face_list.h"

#include <utility>

#include <fmt/core.h>

namespace evenmesh {

void FaceList::add(std::span<const Index> vertices, std::uint64_t place, std::uint32_t group) {
  const std::size_t face = count_++;
  if (vertices.size() < 3) {
    if (numbers_.size() == face) first_skipped_ = face;
    return;
  }
  const CellKind kind = vertices.size() == 3   ? CellKind::triangle
                        : vertices.size() == 4 ? CellKind::quad
                                               : CellKind::polygon;
  cells_.add(kind, vertices, group);
  numbers_.push_back(face);
  places_.push_back(place);
}

std::vector<std::uint64_t> FaceList::take_numbers() {
  if (numbers_.size() == count_) return {};
  return std::move(numbers_);
}

void FaceList::append_notes(std::vector<std::string>& notes) const {
  if (cells_.empty()) notes.push_back("The file has vertices but no faces.");
  if (numbers_.size() == count_) return;
  notes.push_back(fmt::format(
      "{} of {} faces have fewer than three vertices (the first is face {}); they stay in the file "
      "but are no cells.",
      count_ - numbers_.size(), count_, first_skipped_));
}

}  // namespace evenmesh
