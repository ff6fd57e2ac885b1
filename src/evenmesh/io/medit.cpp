// SPDX-License-Identifier: MIT
#include "evenmesh/io/medit.h"

#include <limits>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/io/medit_content.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/text_scanner.h"

namespace evenmesh {
namespace {

bool is_word_of_letters(std::string_view word) {
  return !word.empty() &&
         ((word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z'));
}

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), scanner_(*input_, '#') {}

  MeshFile read() {
    for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      if (word == "End" || word == "END") break;
      read_section(word);
    }
    if (content_.vertices() == 0) input_->fail("has no vertices; export the mesh again");
    MeshFile file = content_.take_file();
    file.patch = std::make_unique<PlacedPatch>(
        "medit", input_, CoordinateCode{.dimension = dimension_}, std::move(places_),
        FileNumbers{.first_vertex = 1, .first_cell = 1, .cell_places = std::move(cell_places_)});
    return file;
  }

 private:
  void read_section(std::string_view name) {
    const char* const place = name.data();
    if (name == "MeshVersionFormatted") {
      // Version 1 says that the numbers are floats, but many programs write doubles under it.
      scanner_.count("the version");
    } else if (name == "Dimension") {
      const std::uint64_t dimension = scanner_.count("the dimension");
      if (dimension != 2 && dimension != 3) {
        scanner_.fail(place, fmt::format("the dimension is {}; 2 and 3 are read", dimension));
      }
      if (dimension_ != 0) scanner_.fail(place, "a second Dimension; keep the right one");
      dimension_ = static_cast<int>(dimension);
    } else if (name == "Vertices") {
      read_vertices(place);
    } else if (const MeditSection* section = medit_section(name)) {
      read_list(*section, place);
    } else if (is_word_of_letters(name)) {
      while (!scanner_.peek().empty() && !is_word_of_letters(scanner_.peek())) scanner_.word();
    } else {
      scanner_.fail(place, fmt::format("{} where the name of a section is expected",
                                       quoted_word(place, scanner_.end())));
    }
  }

  void read_vertices(const char* place) {
    if (dimension_ == 0) scanner_.fail(place, "Vertices come before Dimension; put it first");
    if (content_.vertices() > 0) scanner_.fail(place, "a second list of vertices; join them");
    const std::uint64_t count = scanner_.count("the number of vertices");
    constexpr std::size_t kLeast = 6;  // "0 0 0" and a blank
    scanner_.check_room(count, kLeast, "vertices");
    places_.reserve(count);
    content_.reserve_vertices(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      std::uint64_t offset = 0;
      const Vec3 position = scanner_.position(dimension_, i + 1, offset);
      places_.push_back(offset);
      content_.add_vertex(position, scanner_.integer("the reference of a vertex"));
    }
  }

  void read_list(const MeditSection& section, const char* place) {
    if (section.role == MeditRole::too_high) {
      scanner_.fail(place, fmt::format("{} are cells of second order, which are not read in this "
                                       "format; save the mesh with straight cells",
                                       section.name));
    }
    if (content_.vertices() == 0) {
      scanner_.fail(place, fmt::format("{} come before the vertices", section.name));
    }
    const std::uint64_t count = scanner_.count("the size of a section");
    scanner_.check_room(count, 2 * std::max<std::size_t>(1, section.corners), section.name);
    content_.reserve_entries(section, count);
    if (section.role == MeditRole::cells) cell_places_.reserve(cell_places_.size() + count);
    for (std::uint64_t i = 0; i < count; ++i) {
      scanner_.next();
      if (section.role == MeditRole::cells) cell_places_.push_back(scanner_.offset());
      content_.add_entry(
          section, [this](std::string_view what, std::size_t of) { return number(what, of); },
          [this] { return scanner_.integer("a reference"); });
    }
  }

  /// A number counted from 1. @return  from 0
  std::size_t number(std::string_view what, std::size_t count) {
    scanner_.next();
    const char* const place = scanner_.place();
    const std::int64_t value = scanner_.integer(what);
    if (value < 1 || static_cast<std::uint64_t>(value) > count) {
      scanner_.fail(place, fmt::format("{} with number {}; there are {} of them before this line",
                                       what, value, count));
    }
    return static_cast<std::size_t>(value - 1);
  }

  std::shared_ptr<const InputFile> input_;
  TextScanner scanner_;
  int dimension_ = 0;
  MeditContent content_;
  std::vector<std::uint64_t> places_;
  std::vector<std::uint64_t> cell_places_;
};

}  // namespace

MeshFile read_medit(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
