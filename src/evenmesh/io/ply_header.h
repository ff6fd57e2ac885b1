// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/number_type.h"

namespace evenmesh {

struct PlyProperty {
  std::string_view name;
  NumberType type = NumberType::float32;
  bool is_list = false;
  NumberType count_type = NumberType::uint8;  // of a list
  const char* place = nullptr;
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties = {};
  const char* place = nullptr;

  /// @return  null if it has none of this name
  const PlyProperty* find(std::string_view property) const;
};

struct PlyHeader {
  enum class Code : std::uint8_t { text, little_endian, big_endian };
  Code code = Code::text;
  std::vector<PlyElement> elements = {};
  std::uint64_t data = 0;  // where it begins
};

/// @throws IoError  a line that no PLY has, or no end
PlyHeader read_ply_header(const InputFile& input);

}  // namespace evenmesh
