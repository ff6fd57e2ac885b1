// SPDX-License-Identifier: MIT
#include "evenmesh/io/output_file.h"

#include <cassert>
#include <cerrno>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferSize = std::size_t{1} << 20;

/// Hidden, with the suffix kept, in the same folder because a rename cannot cross file systems.
fs::path temporary_name(const fs::path& path) {
  std::random_device random;
  return path.parent_path() / fmt::format(".{}.{:08x}{:08x}{}", path.stem().string(), random(),
                                          random(), path.extension().string());
}

}  // namespace

OutputFile::OutputFile(const fs::path& path) : shown_as_(path), path_(path) {
  std::error_code error;
  if (fs::is_symlink(path, error)) {
    const fs::path target = fs::canonical(path, error);
    if (error) throw IoError(fmt::format("{}: is a link to nowhere; remove it", path.string()));
    path_ = target;
  }
  if (path_.filename().empty() || fs::is_directory(path_, error)) {
    throw IoError(fmt::format("{}: is a folder; give the name of a file in it", path.string()));
  }
  if (fs::exists(path_, error)) {
    if (!fs::is_regular_file(path_, error)) {
      throw IoError(fmt::format("{}: is not a regular file; write to one", path.string()));
    }
    if (::access(path_.c_str(), W_OK) != 0) fail("cannot be replaced", errno);
  }

  constexpr int kAttempts = 100;  // two names alike are unlikely already
  for (int i = 0; i < kAttempts && descriptor_ < 0; ++i) {
    temporary_ = temporary_name(path_);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) {
    const int reason = errno;
    temporary_.clear();
    fail("cannot be written", reason);
  }
  buffer_.reserve(kBufferSize);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::append(std::string_view bytes) {
  if (buffer_.size() + bytes.size() > kBufferSize) {
    write_out(buffer_);
    buffer_.clear();
  }
  if (bytes.size() >= kBufferSize) {
    write_out(bytes);
  } else {
    buffer_.append(bytes);
  }
}

void OutputFile::close() {
  write_out(buffer_);
  buffer_.clear();
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail("cannot be written", errno);
}

void OutputFile::commit() {
  assert(descriptor_ < 0);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be replaced", errno);
  temporary_.clear();
}

void OutputFile::fail(std::string_view what, int error) const {
  throw IoError(
      fmt::format("{}: {}: {}", shown_as_.string(), what, std::generic_category().message(error)));
}

void OutputFile::write_out(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace evenmesh
