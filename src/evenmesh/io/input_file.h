// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace evenmesh {

/// The bytes of a file as they lie on disk, and how messages speak of places in them.
class InputFile {
 public:
  /// Maps a regular file into memory, and unpacks it there if it is compressed with gzip.
  /// @param shown_as  the name used in messages; empty: path itself
  /// @throws IoError  missing, unreadable, not a regular file, empty, or broken gzip
  static std::shared_ptr<const InputFile> open(const std::filesystem::path& path,
                                               std::string shown_as = {});

  /// Bytes that somebody else keeps alive: for tests, fuzzing and meshes that are in memory.
  static std::shared_ptr<const InputFile> borrow(std::string_view bytes, std::string name);

  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// The content, unpacked.
  std::string_view bytes() const { return bytes_; }
  bool is_compressed() const { return !unpacked_.empty(); }
  /// @pre  is_compressed()
  std::string_view compressed_bytes() const { return mapped_; }
  /// The size of the file on disk, bytes.
  std::size_t size_on_disk() const { return mapped_.size(); }
  const std::string& name() const { return name_; }

  /// Physical line of a byte, counted from 1. LF, CR LF and CR alone each end a line.
  std::size_t line_of(std::size_t offset) const;

  /// @throws IoError  always: "name:line: message"
  [[noreturn]] void fail_at(std::size_t offset, std::string_view message) const;
  [[noreturn]] void fail_at(const char* place, std::string_view message) const {
    fail_at(static_cast<std::size_t>(place - bytes_.data()), message);
  }
  /// @throws IoError  always: "name: message"
  [[noreturn]] void fail(std::string_view message) const;

  /// The mapping shows what the file holds now, not what it held when it was read.
  /// @throws IoError  size or time of change differ from when the file was opened
  void check_unchanged() const;

 private:
  InputFile() = default;

  void take(std::string_view bytes);

  std::string_view mapped_;  // as on disk, or borrowed
  std::string unpacked_;     // empty unless compressed
  std::string_view bytes_;   // one of the two
  std::string name_;
  int descriptor_ = -1;  // -1: borrowed
  std::int64_t changed_seconds_ = 0;
  std::int64_t changed_nanoseconds_ = 0;
};

}  // namespace evenmesh
