// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstddef>
#include <functional>
#include <string_view>

namespace evenmesh {

/// Hands a text to a sink with some stretches of it replaced.
class BytePatcher {
 public:
  using Sink = std::function<void(std::string_view)>;

  BytePatcher(std::string_view input, const Sink& sink) : input_(input), sink_(sink) {}

  /// Replaces the stretch [first, last) of the input.
  /// @pre  stretches come in order and do not overlap
  void replace(const char* first, const char* last, std::string_view text) {
    const auto begin = static_cast<std::size_t>(first - input_.data());
    assert(begin >= done_ && last >= first);
    if (begin > done_) sink_(input_.substr(done_, begin - done_));
    if (!text.empty()) sink_(text);
    done_ = static_cast<std::size_t>(last - input_.data());
  }

  /// Hands over what is left of the input. To be called once, at the end.
  void finish() {
    if (done_ < input_.size()) sink_(input_.substr(done_));
    done_ = input_.size();
  }

 private:
  std::string_view input_;
  const Sink& sink_;
  std::size_t done_ = 0;  // bytes of the input that have been handed over or replaced
};

}  // namespace evenmesh
