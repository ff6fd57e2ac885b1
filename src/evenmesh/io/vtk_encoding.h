// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "evenmesh/io/input_file.h"

namespace evenmesh {

/// How VTK's XML files put arrays into bytes, or into letters for bytes.
struct VtkEncoding {
  bool base64 = false;
  bool compressed = false;       // with zlib, in blocks
  bool swap = false;             // sizes, and the numbers themselves, are not in our byte order
  std::size_t header_bytes = 4;  // of one size
};

/// An array taken out of a file.
struct VtkBytes {
  std::string_view raw = {};  // in the file, if they stand there as they are
  std::string decoded = {};   // else
  std::size_t length = 0;     // of what it was taken from

  std::string_view bytes() const { return decoded.empty() ? raw : std::string_view(decoded); }
};

/// The array at a place of the file; what is behind it does not matter.
/// @param end   where it must end at the latest
/// @param most  no more bytes than this are unpacked
/// @throws IoError  with the byte: cut off, broken, or larger than `most`
VtkBytes decode(const InputFile& input, std::uint64_t begin, std::uint64_t end,
                const VtkEncoding& encoding, std::uint64_t most);

/// The array at a place of the file as it is to be written with other bytes, of the same number.
/// Blocks that are as before keep their compressed bytes.
/// @pre  decode() read it
std::string encode(std::string_view bytes, const InputFile& input, std::uint64_t begin,
                   std::uint64_t end, const VtkEncoding& encoding);

}  // namespace evenmesh
