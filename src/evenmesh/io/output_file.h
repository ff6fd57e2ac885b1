// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace evenmesh {

/// A file that appears under its name only when it is complete: written under another name in the
/// same folder, then renamed. Destroyed before commit(), it leaves nothing behind.
class OutputFile {
 public:
  /// A link at `path` is followed, so that it stays a link.
  /// @throws IoError  the folder is missing or not writable, or `path` is something else than a
  ///                  regular file or nothing, or write-protected
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// @throws IoError  the disk is full or otherwise unwilling
  void append(std::string_view bytes);

  /// Writes out what is buffered; afterwards the file at temporary_path() is complete.
  /// @throws IoError  as append()
  void close();

  /// Gives the file its name, in place of a file that had it before.
  /// @pre  close() was called
  /// @throws IoError  the system refuses
  void commit();

  const std::filesystem::path& temporary_path() const { return temporary_; }

 private:
  [[noreturn]] void fail(std::string_view what, int error) const;
  void write_out(std::string_view bytes);

  std::filesystem::path shown_as_;
  std::filesystem::path path_;       // shown_as_ with links followed
  std::filesystem::path temporary_;  // empty once renamed
  std::string buffer_;
  int descriptor_ = -1;
};

}  // namespace evenmesh
