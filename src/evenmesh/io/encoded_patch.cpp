// SPDX-License-Identifier: MIT
#include "evenmesh/io/encoded_patch.h"

#include <algorithm>
#include <string>
#include <utility>

#include "evenmesh/io/byte_patcher.h"

namespace evenmesh {
namespace {

/// A stretch of the file and what is to be there instead.
struct Replacement {
  std::uint64_t begin, end;
  std::string text;
};

/// By how much what stands behind a place moves.
std::int64_t shift_at(std::uint64_t place, const std::vector<Replacement>& arrays) {
  std::int64_t shift = 0;
  for (const Replacement& array : arrays) {
    if (array.begin >= place) continue;
    shift += static_cast<std::int64_t>(array.text.size()) -
             static_cast<std::int64_t>(array.end - array.begin);
  }
  return shift;
}

}  // namespace

EncodedPatch::EncodedPatch(std::string_view format, std::shared_ptr<const InputFile> input,
                           CoordinateCode code, FileNumbers numbers, VtkEncoding encoding,
                           std::vector<EncodedPoints> points, std::uint64_t arrays,
                           std::vector<EncodedOffset> offsets)
    : PlacedPatch(format, input, code, {}, std::move(numbers)),
      input_(std::move(input)),
      code_(code),
      encoding_(encoding),
      points_(std::move(points)),
      arrays_(arrays),
      offsets_(std::move(offsets)) {}

void EncodedPatch::write(Points points, const std::function<void(std::string_view)>& sink) const {
  input_->check_unchanged();
  const std::string_view file = input_->bytes();
  const std::size_t each = 3 * code_.bytes_each();
  std::vector<Replacement> replacements;
  for (const EncodedPoints& piece : points_) {
    const VtkBytes decoded = decode(*input_, piece.begin, piece.end, encoding_, piece.count * each);
    const std::string_view before = decoded.bytes();
    std::string after;
    after.reserve(before.size());
    const auto append = [&after](std::string_view bytes) { after += bytes; };
    const BytePatcher::Sink append_to_after = append;
    BytePatcher out(before, append_to_after);
    for (std::size_t i = 0; i < piece.count && (i + 1) * each <= before.size(); ++i) {
      code_.patch(before.data() + i * each, before.data() + before.size(), points[piece.first + i],
                  out);
    }
    out.finish();
    if (after == before) continue;
    replacements.push_back(
        {piece.begin, piece.end, encode(after, *input_, piece.begin, piece.end, encoding_)});
  }

  std::vector<Replacement> all = replacements;
  for (const EncodedOffset& offset : offsets_) {
    const std::int64_t shift = shift_at(arrays_ + offset.offset, replacements);
    if (shift == 0) continue;
    all.push_back({offset.place, offset.place + offset.length,
                   std::to_string(static_cast<std::int64_t>(offset.offset) + shift)});
  }
  std::sort(all.begin(), all.end(),
            [](const Replacement& a, const Replacement& b) { return a.begin < b.begin; });
  BytePatcher out(file, sink);
  for (const Replacement& r : all) out.replace(file.data() + r.begin, file.data() + r.end, r.text);
  out.finish();
  input_->check_unchanged();
}

}  // namespace evenmesh
