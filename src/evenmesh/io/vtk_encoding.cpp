// SPDX-License-Identifier: MIT
#include "evenmesh/io/vtk_encoding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include <fmt/core.h>
#include <zlib.h>

#include "evenmesh/base/base64.h"
#include "evenmesh/io/number_type.h"

namespace evenmesh {
namespace {

// ---- base64: four letters for three bytes ----
constexpr unsigned char kNoLetter = 64;

constexpr auto kValues = [] {
  std::array<unsigned char, 256> values{};
  values.fill(kNoLetter);
  for (std::size_t i = 0; i < kBase64Letters.size(); ++i) {
    values[static_cast<unsigned char>(kBase64Letters[i])] = static_cast<unsigned char>(i);
  }
  return values;
}();

// ---- arrays ----
/// The sizes of the blocks of a compressed array.
struct Blocks {
  std::string head = {};   // the bytes of their number and of the two sizes that follow
  std::uint64_t size = 0;  // unpacked, of each
  std::uint64_t last = 0;  // of the last
  std::vector<std::uint64_t> packed = {};
  std::uint64_t unpacked(std::size_t block) const {
    return block + 1 == packed.size() ? last : size;
  }
};

/// Takes an array apart from its beginning.
class Cursor {
 public:
  Cursor(const InputFile& input, std::uint64_t begin, std::uint64_t end,
         const VtkEncoding& encoding)
      : input_(input),
        text_(input.bytes().substr(begin, end - begin)),
        begin_(begin),
        encoding_(encoding) {}

  std::size_t length() const { return at_; }
  std::string_view text() const { return text_; }

  /// So many bytes, which in letters make groups of their own.
  std::string take(std::uint64_t count) {
    if (!encoding_.base64) {
      if (count > text_.size() - at_) fail("is cut off");
      at_ += count;
      return std::string(text_.substr(at_ - count, count));
    }
    if (count > text_.size() || base64_size(count) > text_.size() - at_) fail("is cut off");
    std::string bytes;
    bytes.reserve(count + 2);
    const std::size_t stop = at_ + base64_size(count);
    for (; at_ < stop; at_ += 4) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const char letter = text_[at_ + k];
        const unsigned char value = kValues[static_cast<unsigned char>(letter)];
        const bool pads = letter == '=' && at_ + 4 == stop && k >= 2;
        if (value == kNoLetter && !pads) fail("has a letter that is none of base64");
        bits = bits << 6U | (pads ? 0U : value);
      }
      for (const unsigned shift : {16U, 8U, 0U}) bytes += static_cast<char>(bits >> shift & 255U);
    }
    bytes.resize(count);
    return bytes;
  }

  /// The sizes in front of the array.
  std::vector<std::uint64_t> sizes(std::string_view bytes) const {
    std::vector<std::uint64_t> result;
    const NumberType type = encoding_.header_bytes == 8 ? NumberType::uint64 : NumberType::uint32;
    for_each_number(bytes, type, encoding_.swap, [&](auto value) {
      if constexpr (std::is_integral_v<decltype(value)>) {
        result.push_back(static_cast<std::uint64_t>(value));
      }
    });
    return result;
  }

  /// Some writers put the size of an array into groups of letters of its own.
  bool has_size_apart() const {
    const std::uint64_t letters = base64_size(encoding_.header_bytes);
    const std::size_t pads = encoding_.header_bytes == 8 ? 1 : 2;
    return encoding_.base64 && letters <= text_.size() &&
           text_.substr(letters - pads, pads) == std::string_view("==").substr(0, pads);
  }

  Blocks take_blocks() {
    const std::size_t header = encoding_.header_bytes;
    // Looked at first, and taken again with what follows it.
    const std::size_t start = at_;
    const std::uint64_t count = sizes(take(header))[0];
    at_ = start;
    if (count > text_.size() / header) fail("is cut off");
    constexpr std::size_t kBefore = 3;
    const std::string bytes = take((kBefore + count) * header);
    const std::vector<std::uint64_t> all = sizes(bytes);
    Blocks blocks{.head = bytes.substr(0, kBefore * header),
                  .size = all[1],
                  .last = all[2] == 0 ? all[1] : all[2]};
    blocks.packed.assign(all.begin() + kBefore, all.end());
    return blocks;
  }

  [[noreturn]] void fail(std::string_view what) const {
    input_.fail(fmt::format("byte {}: an array {}; copy or export the file again", begin_, what));
  }

 private:
  const InputFile& input_;
  std::string_view text_;
  std::uint64_t begin_;
  const VtkEncoding& encoding_;
  std::size_t at_ = 0;
};

/// All compressed blocks, one behind the other.
std::string take_packed(Cursor& cursor, const Blocks& blocks) {
  std::uint64_t total = 0;
  for (const std::uint64_t size : blocks.packed) {
    if (size > cursor.text().size()) cursor.fail("is cut off");
    total += size;
  }
  return cursor.take(total);
}

std::string unpack(Cursor& cursor, std::uint64_t most) {
  constexpr std::uint64_t kBestRatio = 1100;  // zlib does not reach it
  const Blocks blocks = cursor.take_blocks();
  const std::string packed = take_packed(cursor, blocks);
  std::string bytes;
  std::size_t from = 0;
  for (std::size_t block = 0; block < blocks.packed.size(); ++block) {
    const std::uint64_t size = blocks.unpacked(block);
    if (size > most || bytes.size() > most - size) {
      cursor.fail(fmt::format("unpacks to more than {} bytes", most));
    }
    if (size > kBestRatio * blocks.packed[block] + kBestRatio) cursor.fail("cannot be unpacked");
    const std::size_t start = bytes.size();
    bytes.resize(start + size);
    uLongf unpacked = size;
    const int result =
        uncompress(reinterpret_cast<Bytef*>(bytes.data() + start), &unpacked,
                   reinterpret_cast<const Bytef*>(packed.data() + from), blocks.packed[block]);
    if (result != Z_OK || unpacked != size) cursor.fail("cannot be unpacked");
    from += blocks.packed[block];
  }
  return bytes;
}

std::string pack(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  packed.resize(size);
  return packed;
}

std::string size_bytes(std::uint64_t size, const VtkEncoding& encoding) {
  static_assert(std::endian::native == std::endian::little, "the low bytes come first");
  std::string bytes(reinterpret_cast<const char*>(&size), encoding.header_bytes);
  if (encoding.swap) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string encode_blocks(std::string_view bytes, Cursor cursor, const VtkEncoding& encoding) {
  const Blocks blocks = cursor.take_blocks();
  const std::string before = take_packed(cursor, blocks);
  std::string header = blocks.head;
  std::string packed;
  std::size_t from = 0;
  std::string old;
  for (std::size_t block = 0; block < blocks.packed.size(); ++block) {
    const std::string_view piece = bytes.substr(0, blocks.unpacked(block));
    bytes.remove_prefix(piece.size());
    const std::string_view packed_before =
        std::string_view(before).substr(from, blocks.packed[block]);
    from += packed_before.size();
    old.resize(piece.size());
    uLongf size = old.size();
    uncompress(reinterpret_cast<Bytef*>(old.data()), &size,
               reinterpret_cast<const Bytef*>(packed_before.data()), packed_before.size());
    const std::string now = old == piece ? std::string(packed_before) : pack(piece);
    header += size_bytes(now.size(), encoding);
    packed += now;
  }
  return encoding.base64 ? to_base64(header) + to_base64(packed) : header + packed;
}

}  // namespace

VtkBytes decode(const InputFile& input, std::uint64_t begin, std::uint64_t end,
                const VtkEncoding& encoding, std::uint64_t most) {
  Cursor cursor(input, begin, end, encoding);
  if (encoding.compressed) {
    std::string bytes = unpack(cursor, most);
    return {.decoded = std::move(bytes), .length = cursor.length()};
  }
  Cursor header(input, begin, end, encoding);
  const std::size_t header_bytes = encoding.header_bytes;
  const std::uint64_t size = header.sizes(header.take(header_bytes))[0];
  if (size > most || size > cursor.text().size()) cursor.fail("is cut off");
  if (cursor.has_size_apart()) {
    std::string bytes = header.take(size);
    return {.decoded = std::move(bytes), .length = header.length()};
  }
  if (!encoding.base64) {
    if (size > cursor.text().size() - header_bytes) cursor.fail("is cut off");
    return {.raw = cursor.text().substr(header_bytes, size), .length = header_bytes + size};
  }
  std::string bytes = cursor.take(header_bytes + size);
  bytes.erase(0, header_bytes);
  return {.decoded = std::move(bytes), .length = cursor.length()};
}

std::string encode(std::string_view bytes, const InputFile& input, std::uint64_t begin,
                   std::uint64_t end, const VtkEncoding& encoding) {
  const Cursor cursor(input, begin, end, encoding);
  if (encoding.compressed) return encode_blocks(bytes, cursor, encoding);
  const std::string size = size_bytes(bytes.size(), encoding);
  if (cursor.has_size_apart()) return to_base64(size) + to_base64(bytes);
  const std::string all = size + std::string(bytes);
  return encoding.base64 ? to_base64(all) : all;
}

}  // namespace evenmesh
