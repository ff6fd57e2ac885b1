// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace evenmesh {

/// Whether the bytes begin as gzip does.
bool is_gzip(std::string_view bytes);

/// What gzip has packed; several members one behind the other are one text.
/// @param name  of the file, for messages
/// @throws IoError  broken or cut off, or more than a hundred times the packed size plus 16 MB:
///                  no mesh packs so well
std::string gunzip(std::string_view bytes, std::string_view name);

/// Packs a stream of bytes as gzip does.
class GzipWriter {
 public:
  using Sink = std::function<void(std::string_view)>;
  explicit GzipWriter(Sink sink);
  ~GzipWriter();
  GzipWriter(const GzipWriter&) = delete;
  GzipWriter& operator=(const GzipWriter&) = delete;

  void append(std::string_view bytes);
  /// Hands over what is left. To be called once, at the end.
  void finish();

 private:
  struct State;
  void run(std::string_view bytes, int flush);

  Sink sink_;
  std::unique_ptr<State> state_;
};

}  // namespace evenmesh
