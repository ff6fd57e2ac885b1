// SPDX-License-Identifier: MIT
#include "evenmesh/io/gzip.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <zlib.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

constexpr std::size_t kBuffer = 1 << 18;
constexpr int kGzip = 16 + MAX_WBITS;

Bytef* as_input(std::string_view bytes) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
}

/// Unpacks one member after the other.
class Unpacker {
 public:
  Unpacker(std::string_view bytes, std::string_view name) : left_(bytes), name_(name) {
    constexpr std::size_t kRatio = 100;
    most_ = kRatio * bytes.size() + (std::size_t{16} << 20);
    inflateInit2(&stream_, kGzip);
  }
  ~Unpacker() { inflateEnd(&stream_); }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  std::string unpack() {
    while (is_gzip(left_)) unpack_member();
    return std::move(text_);
  }

 private:
  void unpack_member() {
    inflateReset(&stream_);
    for (int result = Z_OK; result != Z_STREAM_END;) {
      constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
      const auto given = static_cast<uInt>(std::min(left_.size(), kMost));
      stream_.next_in = as_input(left_);
      stream_.avail_in = given;
      stream_.next_out = reinterpret_cast<Bytef*>(buffer_.data());
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      result = inflate(&stream_, Z_NO_FLUSH);
      left_.remove_prefix(given - stream_.avail_in);
      text_.append(buffer_.data(), buffer_.size() - stream_.avail_out);
      if (text_.size() > most_) {
        throw IoError(
            fmt::format("{}: unpacks to more than a hundred times its size, which no "
                        "mesh does; it is broken",
                        name_));
      }
      if (result == Z_OK) continue;
      if (result == Z_BUF_ERROR || left_.empty()) {
        if (result == Z_STREAM_END) return;
        throw IoError(fmt::format("{}: the compressed file was cut off; copy it again", name_));
      }
      if (result != Z_STREAM_END) {
        throw IoError(fmt::format("{}: the compressed file is broken ({}); copy it again", name_,
                                  stream_.msg == nullptr ? "bad data" : stream_.msg));
      }
    }
  }

  std::string_view left_;
  std::string_view name_;
  std::size_t most_ = 0;
  z_stream stream_{};
  std::vector<char> buffer_ = std::vector<char>(kBuffer);
  std::string text_;
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b\x08"); }

std::string gunzip(std::string_view bytes, std::string_view name) {
  return Unpacker(bytes, name).unpack();
}

struct GzipWriter::State {
  z_stream stream{};
  std::vector<char> buffer = std::vector<char>(kBuffer);
};

GzipWriter::GzipWriter(Sink sink) : sink_(std::move(sink)), state_(std::make_unique<State>()) {
  constexpr int kMemory = 8;
  deflateInit2(&state_->stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory,
               Z_DEFAULT_STRATEGY);
}

GzipWriter::~GzipWriter() { deflateEnd(&state_->stream); }

void GzipWriter::append(std::string_view bytes) {
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kMost))) {
    run(bytes.substr(0, kMost), Z_NO_FLUSH);
  }
}

void GzipWriter::finish() { run({}, Z_FINISH); }

void GzipWriter::run(std::string_view bytes, int flush) {
  z_stream& stream = state_->stream;
  stream.next_in = as_input(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  do {
    stream.next_out = reinterpret_cast<Bytef*>(state_->buffer.data());
    stream.avail_out = static_cast<uInt>(state_->buffer.size());
    deflate(&stream, flush);
    const std::size_t made = state_->buffer.size() - stream.avail_out;
    if (made > 0) sink_({state_->buffer.data(), made});
  } while (stream.avail_out == 0);
}

}  // namespace evenmesh
