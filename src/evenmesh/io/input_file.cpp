// SPDX-License-Identifier: MIT
#include "evenmesh/io/input_file.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "evenmesh/base/error.h"
#include "evenmesh/io/gzip.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

std::string system_message(int error) { return std::generic_category().message(error); }

}  // namespace

std::shared_ptr<const InputFile> InputFile::open(const std::filesystem::path& path,
                                                 std::string shown_as) {
  const std::shared_ptr<InputFile> file(new InputFile);
  file->name_ = shown_as.empty() ? path.string() : std::move(shown_as);

  // Asked before opening, because opening a named pipe waits for somebody to write to it.
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    file->fail(fmt::format("cannot be opened: {}", system_message(errno)));
  }
  if (S_ISDIR(status.st_mode)) file->fail("is a folder; give a mesh file in it");
  if (!S_ISREG(status.st_mode)) file->fail("is not a regular file; copy its content to one");

  file->descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file->descriptor_ < 0 || ::fstat(file->descriptor_, &status) != 0) {
    file->fail(fmt::format("cannot be opened: {}", system_message(errno)));
  }
  if (status.st_size == 0) file->fail("is empty");

  const auto size = static_cast<std::size_t>(status.st_size);
  void* const memory = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file->descriptor_, 0);
  if (memory == MAP_FAILED) file->fail(fmt::format("cannot be read: {}", system_message(errno)));
  ::madvise(memory, size, MADV_SEQUENTIAL);
  file->take({static_cast<const char*>(memory), size});
  file->changed_seconds_ = status.st_mtim.tv_sec;
  file->changed_nanoseconds_ = status.st_mtim.tv_nsec;
  return file;
}

std::shared_ptr<const InputFile> InputFile::borrow(std::string_view bytes, std::string name) {
  const std::shared_ptr<InputFile> file(new InputFile);
  file->name_ = std::move(name);
  if (bytes.empty()) file->fail("is empty");
  file->take(bytes);
  return file;
}

void InputFile::take(std::string_view bytes) {
  mapped_ = bytes;
  bytes_ = bytes;
  if (!is_gzip(bytes)) return;
  unpacked_ = gunzip(bytes, name_);
  bytes_ = unpacked_;
  if (bytes_.empty()) fail("is empty when unpacked");
}

InputFile::~InputFile() {
  if (descriptor_ < 0) return;
  if (!mapped_.empty()) ::munmap(const_cast<char*>(mapped_.data()), mapped_.size());
  ::close(descriptor_);
}

std::size_t InputFile::line_of(std::size_t offset) const {
  // In blocks whose count fits a byte, which is what the compiler can vectorise: it takes a
  // hundredth of a second for 100 MB, and a report names many cells.
  constexpr std::size_t kBlock = 128;
  const char* const bytes = bytes_.data();
  const std::size_t safe = std::min(offset, bytes_.size() - 1);  // bytes with one after them
  std::size_t line = 1;
  std::size_t i = 0;
  for (; i + kBlock <= safe; i += kBlock) {
    unsigned char ends = 0;
    for (std::size_t k = i; k < i + kBlock; ++k) {
      const int end = (bytes[k] == '\n') | ((bytes[k] == '\r') & (bytes[k + 1] != '\n'));
      ends = static_cast<unsigned char>(ends + end);
    }
    line += ends;
  }
  for (; i < safe; ++i) {
    line +=
        static_cast<std::size_t>(bytes[i] == '\n' || (bytes[i] == '\r' && bytes[i + 1] != '\n'));
  }
  return offset > safe && is_eol(bytes[safe]) ? line + 1 : line;
}

void InputFile::fail_at(std::size_t offset, std::string_view message) const {
  throw IoError(fmt::format("{}:{}: {}", name_, line_of(offset), message));
}

void InputFile::fail(std::string_view message) const {
  throw IoError(fmt::format("{}: {}", name_, message));
}

void InputFile::check_unchanged() const {
  if (descriptor_ < 0) return;
  struct stat now {};
  if (::fstat(descriptor_, &now) == 0 && static_cast<std::size_t>(now.st_size) == mapped_.size() &&
      now.st_mtim.tv_sec == changed_seconds_ && now.st_mtim.tv_nsec == changed_nanoseconds_) {
    return;
  }
  fail("was changed by somebody else since it was read; run again to use its new content");
}

}  // namespace evenmesh
