// SPDX-License-Identifier: MIT
#include "evenmesh/report/packed_array.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <new>
#include <vector>

#include <zlib.h>

namespace evenmesh {
namespace {

std::uint32_t zigzag(std::int64_t value) {
  assert(value >= std::numeric_limits<std::int32_t>::min() &&
         value <= std::numeric_limits<std::int32_t>::max());
  const auto wide = static_cast<std::uint64_t>(value);
  return static_cast<std::uint32_t>(value < 0 ? ~(wide << 1U) : wide << 1U);
}

std::vector<std::uint32_t> made_small(std::span<const std::int64_t> values, std::size_t components,
                                      Rule rule) {
  std::vector<std::uint32_t> result(values.size());
  std::int64_t high = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int64_t value = values[i];
    switch (rule) {
      case Rule::as_is:
        assert(value >= 0 && value <= std::numeric_limits<std::uint32_t>::max());
        result[i] = static_cast<std::uint32_t>(value);
        break;
      case Rule::zigzag:
        result[i] = zigzag(value);
        break;
      case Rule::delta:
        result[i] = zigzag(value - (i < components ? 0 : values[i - components]));
        break;
      case Rule::highwater:
        assert(value >= 0 && value <= high);
        result[i] = static_cast<std::uint32_t>(high - value);
        if (value == high) ++high;
        break;
    }
  }
  return result;
}

std::string planes_of(std::span<const std::uint32_t> values, int planes) {
  std::string bytes;
  bytes.reserve(values.size() * static_cast<std::size_t>(planes));
  for (int p = 0; p < planes; ++p) {
    for (const std::uint32_t value : values) bytes += static_cast<char>(value >> (8 * p) & 0xFFU);
  }
  return bytes;
}

std::string deflated(std::string_view bytes, int strategy) {
  constexpr int kLevel = 6;
  constexpr int kWindowBits = 15;
  constexpr int kMemoryLevel = 9;
  z_stream stream{};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kWindowBits, kMemoryLevel, strategy) != Z_OK) {
    throw std::bad_alloc();
  }
  std::string result;
  std::string piece(std::size_t{1} << 16U, '\0');
  // zlib counts input in 32 bits.
  constexpr std::size_t kMost = std::size_t{1} << 30U;
  int state = Z_OK;
  do {
    if (stream.avail_in == 0 && !bytes.empty()) {
      const std::size_t taken = std::min(kMost, bytes.size());
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      stream.avail_in = static_cast<uInt>(taken);
      bytes.remove_prefix(taken);
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    result.append(piece.data(), piece.size() - stream.avail_out);
  } while (state != Z_STREAM_END);
  deflateEnd(&stream);
  return result;
}

// Looking for repetitions in what has none makes it longer.
std::string shortest(std::string_view bytes) {
  std::string one = deflated(bytes, Z_DEFAULT_STRATEGY);
  std::string other = deflated(bytes, Z_HUFFMAN_ONLY);
  return other.size() < one.size() ? other : one;
}

}  // namespace

std::string_view name(Rule rule) {
  constexpr std::string_view kNames[] = {"unsigned", "signed", "delta", "highwater"};
  return kNames[static_cast<int>(rule)];
}

PackedArray pack(std::span<const std::int64_t> values, std::size_t components, Rule rule) {
  assert(components > 0 && values.size() % components == 0);
  const std::vector<std::uint32_t> small = made_small(values, components, rule);
  const std::uint32_t greatest = small.empty() ? 0 : *std::max_element(small.begin(), small.end());
  int planes = 1;
  while (planes < 4 && greatest >> (8 * planes) != 0) ++planes;
  return {shortest(planes_of(small, planes)), values.size(), components, planes, rule};
}

PackedArray pack_signed(std::span<const std::int64_t> values, std::size_t components) {
  PackedArray one = pack(values, components, Rule::zigzag);
  PackedArray other = pack(values, components, Rule::delta);
  return other.bytes.size() < one.bytes.size() ? other : one;
}

}  // namespace evenmesh
