// SPDX-License-Identifier: MIT
#include "evenmesh/io/meshb.h"

#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/io/byte_scanner.h"
#include "evenmesh/io/medit_content.h"
#include "evenmesh/io/placed_patch.h"

namespace evenmesh {
namespace {

class Reader {
 public:
  Reader(std::shared_ptr<const InputFile> input, bool swap)
      : input_(std::move(input)), scanner_(*input_, 4, swap) {}

  MeshFile read() {
    version_ = scanner_.take<std::int32_t>();
    if (version_ < 1 || version_ > 4) {
      scanner_.fail(4, fmt::format("version {}; 1 to 4 are read", version_));
    }
    std::uint64_t next = scanner_.offset();
    while (next != 0 && next < input_->bytes().size()) {
      if (next < scanner_.offset()) scanner_.fail(next, "sections run in a circle");
      scanner_.set_offset(next);
      const int code = scanner_.take<std::int32_t>();
      const std::uint64_t place = scanner_.offset();
      next = take_position();
      if (code == kMeditEnd) break;
      if (next != 0 && next <= place) scanner_.fail(place, "sections run in a circle");
      read_section(code, place);
    }
    if (content_.vertices() == 0) input_->fail("has no vertices; export the mesh again");
    return take_file();
  }

 private:
  std::uint64_t take_position() {
    return version_ >= 3 ? static_cast<std::uint64_t>(scanner_.take<std::int64_t>())
                         : scanner_.take<std::uint32_t>();
  }
  std::int64_t take_integer() {
    return version_ >= 4 ? scanner_.take<std::int64_t>() : scanner_.take<std::int32_t>();
  }
  std::size_t integer_bytes() const { return version_ >= 4 ? 8 : 4; }

  void read_section(int code, std::uint64_t place) {
    if (code == kMeditDimension) {
      if (dimension_ != 0) scanner_.fail(place, "a second dimension; export the mesh again");
      dimension_ = scanner_.take<std::int32_t>();
      if (dimension_ != 2 && dimension_ != 3) {
        scanner_.fail(place, fmt::format("the dimension is {}; 2 and 3 are read", dimension_));
      }
    } else if (code == kMeditVertices) {
      read_vertices(place);
    } else if (const MeditSection* section = medit_section(code)) {
      read_list(*section, place);
    }
  }

  void read_vertices(std::uint64_t place) {
    if (dimension_ == 0) scanner_.fail(place, "vertices come before the dimension");
    if (content_.vertices() > 0) scanner_.fail(place, "a second list of vertices; join them");
    code_ = {.kind = version_ == 1 ? CoordinateCode::Kind::float32 : CoordinateCode::Kind::float64,
             .dimension = dimension_,
             .swap = scanner_.swaps()};
    const std::uint64_t count =
        take_count("vertices", code_.bytes_each() * static_cast<std::size_t>(dimension_));
    places_.reserve(count);
    content_.reserve_vertices(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      places_.push_back(scanner_.offset());
      const Vec3 position = code_.position_at(input_->bytes().data() + scanner_.offset());
      scanner_.skip(code_.bytes_each() * static_cast<std::size_t>(dimension_));
      if (!position.allFinite()) {
        scanner_.fail(places_.back(), fmt::format("vertex {} has a coordinate that is no finite "
                                                  "number; repair the file or write it again",
                                                  i + 1));
      }
      content_.add_vertex(position, take_integer());
    }
  }

  std::uint64_t take_count(std::string_view things, std::size_t bytes) {
    const std::uint64_t place = scanner_.offset();
    const std::int64_t count = take_integer();
    if (count < 0) scanner_.fail(place, fmt::format("the number of {} is {}", things, count));
    scanner_.check_room(static_cast<std::uint64_t>(count), bytes + integer_bytes(), things);
    return static_cast<std::uint64_t>(count);
  }

  void read_list(const MeditSection& section, std::uint64_t place) {
    if (section.role == MeditRole::too_high) {
      scanner_.fail(place, fmt::format("{} are cells of second order, which are not read in this "
                                       "format; save the mesh with straight cells",
                                       section.name));
    }
    const std::uint64_t count = take_count(section.name, section.corners * integer_bytes());
    content_.reserve_entries(section, count);
    for (std::uint64_t i = 0; i < count; ++i) {
      content_.add_entry(
          section, [this](std::string_view what, std::size_t of) { return number(what, of); },
          [this] { return take_integer(); });
    }
  }

  std::size_t number(std::string_view what, std::size_t count) {
    const std::uint64_t place = scanner_.offset();
    const std::int64_t value = take_integer();
    if (value < 1 || static_cast<std::uint64_t>(value) > count) {
      scanner_.fail(place, fmt::format("{} with number {}; there are {} of them before this", what,
                                       value, count));
    }
    return static_cast<std::size_t>(value - 1);
  }

  MeshFile take_file() {
    MeshFile file = content_.take_file();
    file.patch = std::make_unique<PlacedPatch>("meshb", input_, code_, std::move(places_),
                                               FileNumbers{.first_vertex = 1, .first_cell = 1});
    return file;
  }

  std::shared_ptr<const InputFile> input_;
  ByteScanner scanner_;
  std::int32_t version_ = 0;
  int dimension_ = 0;
  CoordinateCode code_;
  MeditContent content_;
  std::vector<std::uint64_t> places_;
};

std::uint32_t first_number(std::string_view begin) {
  std::uint32_t number = 0;
  if (begin.size() >= 8) std::memcpy(&number, begin.data(), sizeof(number));
  return number;
}

}  // namespace

bool looks_like_meshb(std::string_view begin) {
  const std::uint32_t number = first_number(begin);
  return number == 1 || number == __builtin_bswap32(1);
}

MeshFile read_meshb(std::shared_ptr<const InputFile> input) {
  const bool swap = first_number(input->bytes()) != 1;
  return Reader(std::move(input), swap).read();
}

}  // namespace evenmesh
