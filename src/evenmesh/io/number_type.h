// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

namespace evenmesh {

/// The types of number that a file may hold as bytes.
enum class NumberType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

/// Bytes of one number.
constexpr std::size_t size_of(NumberType type) {
  switch (type) {
    case NumberType::int8:
    case NumberType::uint8:
      return 1;
    case NumberType::int16:
    case NumberType::uint16:
      return 2;
    case NumberType::int32:
    case NumberType::uint32:
    case NumberType::float32:
      return 4;
    default:
      return 8;
  }
}

constexpr bool is_real(NumberType type) {
  return type == NumberType::float32 || type == NumberType::float64;
}

/// A number from its bytes.
/// @param swap  the byte order is not this machine's
template <typename T>
T number_at(const char* bytes, bool swap) {
  char raw[sizeof(T)];
  std::memcpy(raw, bytes, sizeof(T));
  if (swap) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Calls take with each number of an array, in the type that it has there.
template <typename Take>
void for_each_number(std::string_view bytes, NumberType type, bool swap, const Take& take) {
  const auto each = [&]<typename T>(T) {
    for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
      take(number_at<T>(bytes.data() + at, swap));
    }
  };
  switch (type) {
    case NumberType::int8:
      return each(std::int8_t{});
    case NumberType::uint8:
      return each(std::uint8_t{});
    case NumberType::int16:
      return each(std::int16_t{});
    case NumberType::uint16:
      return each(std::uint16_t{});
    case NumberType::int32:
      return each(std::int32_t{});
    case NumberType::uint32:
      return each(std::uint32_t{});
    case NumberType::int64:
      return each(std::int64_t{});
    case NumberType::uint64:
      return each(std::uint64_t{});
    case NumberType::float32:
      return each(float{});
    case NumberType::float64:
      return each(double{});
  }
}

}  // namespace evenmesh
