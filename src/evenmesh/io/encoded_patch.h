// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/vtk_encoding.h"

namespace evenmesh {

/// The points of one piece of a VTK file, and where the array stands that holds them.
struct EncodedPoints {
  std::uint64_t begin, end;
  std::size_t first, count;  // vertices
};

/// An attribute that says how far an array is behind the place where arrays begin.
struct EncodedOffset {
  std::uint64_t place;   // of its digits in the file
  std::size_t length;    // of its digits
  std::uint64_t offset;  // what it says
};

/// The patch of a VTK file in XML whose points are not text: arrays in which vertices moved are
/// encoded anew.
class EncodedPatch : public PlacedPatch {
 public:
  /// @param arrays   where they begin that attributes point to
  /// @param offsets  ascending by place
  EncodedPatch(std::string_view format, std::shared_ptr<const InputFile> input, CoordinateCode code,
               FileNumbers numbers, VtkEncoding encoding, std::vector<EncodedPoints> points,
               std::uint64_t arrays, std::vector<EncodedOffset> offsets);

  void write(Points points, const std::function<void(std::string_view)>& sink) const override;

 private:
  std::shared_ptr<const InputFile> input_;
  CoordinateCode code_;
  VtkEncoding encoding_;
  std::vector<EncodedPoints> points_;
  std::uint64_t arrays_;
  std::vector<EncodedOffset> offsets_;
};

}  // namespace evenmesh
