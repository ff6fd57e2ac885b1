// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/core.h>

#include "evenmesh/io/input_file.h"
#include "evenmesh/io/number_type.h"

namespace evenmesh {

/// Goes through the numbers of a binary file. Functions that read throw IoError with the byte where
/// the file ends too soon.
class ByteScanner {
 public:
  /// @param swap  the byte order is not this machine's
  explicit ByteScanner(const InputFile& input, std::uint64_t offset = 0, bool swap = false)
      : input_(input), at_(offset), swap_(swap) {}

  /// The next number of this type, in the file's byte order.
  template <typename T>
  T take() {
    const std::string_view bytes = input_.bytes();
    if (at_ > bytes.size() || bytes.size() - at_ < sizeof(T)) fail_short();
    const T value = number_at<T>(bytes.data() + at_, swap_);
    at_ += sizeof(T);
    return value;
  }
  void skip(std::uint64_t bytes) {
    if (bytes > rest()) fail_short();
    at_ += bytes;
  }

  /// Fails where the rest of the file is too short for so many things of so many bytes.
  void check_room(std::uint64_t number, std::size_t bytes_each, std::string_view things) const {
    if (number <= rest() / bytes_each) return;
    fail(at_, fmt::format("promises {} {} but the rest of the file has room for {} at most; it was "
                          "cut off, or the number is wrong",
                          number, things, rest() / bytes_each));
  }

  /// @throws IoError  always
  [[noreturn]] void fail(std::uint64_t offset, std::string_view message) const {
    input_.fail(fmt::format("byte {}: {}", offset, message));
  }

  std::uint64_t offset() const { return at_; }
  void set_offset(std::uint64_t offset) { at_ = offset; }
  std::uint64_t rest() const {
    return at_ > input_.bytes().size() ? 0 : input_.bytes().size() - at_;
  }
  bool swaps() const { return swap_; }

 private:
  [[noreturn]] void fail_short() const {
    fail(at_, "the file ends here; it was cut off, copy or export it again");
  }

  const InputFile& input_;
  std::uint64_t at_;
  bool swap_;
};

}  // namespace evenmesh
