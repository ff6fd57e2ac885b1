// SPDX-License-Identifier: MIT
#include "evenmesh/io/off.h"

#include <limits>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/io/face_list.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/text_scanner.h"

namespace evenmesh {
namespace {

constexpr std::size_t kLeastVertex = 6;  // "0 0 0" and the end of its line
constexpr std::size_t kLeastFace = 2;

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), scanner_(*input_, '#') {}

  MeshFile read() {
    MeshFile file;
    const bool has_normals = read_keyword();
    read_counts();
    for (std::uint64_t i = 0; i < vertex_count_; ++i) read_vertex();
    for (std::uint64_t i = 0; i < face_count_; ++i) read_face(i);

    if (has_normals) file.notes.push_back("Vertex normals are kept as they are.");
    faces_.append_notes(file.notes);
    if (scanner_.next()) {
      file.notes.push_back(fmt::format("What follows the last face (line {}) is kept but not read.",
                                       input_->line_of(scanner_.offset())));
    }
    file.mesh = Mesh(std::move(points_), faces_.take_cells());
    file.patch = std::make_unique<PlacedPatch>(
        "off", input_, CoordinateCode{}, std::move(places_),
        FileNumbers{
            .cell = "face", .cells = faces_.take_numbers(), .cell_places = faces_.take_places()});
    return file;
  }

 private:
  /// @return  whether vertices have normals
  bool read_keyword() {
    if (!scanner_.next())
      input_->fail("has no line but comments; it was cut off or is no OFF file");
    const char* const first = scanner_.place();
    const std::string_view rest(first, static_cast<std::size_t>(scanner_.end() - first));
    const std::size_t length = off_keyword_length(rest);
    if (length == 0) {
      scanner_.fail(
          fmt::format("{} where an OFF file has its keyword; begin it with OFF", scanner_.shown()));
    }
    const std::string_view prefix = rest.substr(0, length - 3);
    if (prefix.find_first_of("4n") != std::string_view::npos) {
      scanner_.fail(
          fmt::format("{} has vertices of other than three coordinates; write it with "
                      "three, as OFF",
                      rest.substr(0, length)));
    }
    scanner_.set_place(first + length);
    if (scanner_.has_word() && *scanner_.place() == 'B') {
      scanner_.fail(first, "a binary OFF file; write it in ASCII");
    }
    return prefix.find('N') != std::string_view::npos;
  }

  void read_counts() {
    vertex_count_ = scanner_.count("the number of vertices");
    if (!scanner_.has_word()) {
      scanner_.fail("the number of faces is missing behind that of vertices");
    }
    face_count_ = scanner_.count("the number of faces");
    scanner_.skip_line();  // the number of edges means nothing
    if (vertex_count_ == 0) input_->fail("has no vertices");
    scanner_.check_room(vertex_count_, kLeastVertex, "vertices");
    scanner_.check_room(face_count_, kLeastFace, "faces");
    points_.reserve(vertex_count_);
    places_.reserve(vertex_count_);
    faces_.reserve(face_count_);
  }

  void read_vertex() {
    const std::uint64_t vertex = points_.size();
    if (!scanner_.next()) fail_end("vertices", vertex, vertex_count_);
    places_.push_back(scanner_.offset());
    Vec3 position;
    for (int k = 0; k < 3; ++k) {
      if (!scanner_.has_word()) {
        scanner_.fail(fmt::format("vertex {} has {} of 3 coordinates", vertex, k));
      }
      position[k] = scanner_.real("a coordinate");
    }
    points_.push_back(position);
    scanner_.skip_line();
  }

  void read_face(std::uint64_t face) {
    if (!scanner_.next()) fail_end("faces", face, face_count_);
    const std::uint64_t place = scanner_.offset();
    const std::uint64_t count = scanner_.count("the number of vertices of a face");
    corners_.clear();
    while (corners_.size() < count) {
      if (!scanner_.has_word()) {
        scanner_.fail(fmt::format("face {} has {} of {} vertices", face, corners_.size(), count));
      }
      const char* const at = scanner_.place();
      const std::int64_t vertex = scanner_.integer("the number of a vertex");
      if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertex_count_) {
        scanner_.fail(at, fmt::format("face {} names vertex {}; the {} vertices count from 0", face,
                                      vertex, vertex_count_));
      }
      corners_.push_back(static_cast<Index>(vertex));
    }
    faces_.add(corners_, place);
    scanner_.skip_line();
  }

  [[noreturn]] void fail_end(std::string_view what, std::uint64_t has, std::uint64_t count) const {
    scanner_.fail(fmt::format("the file ends after {} of {} {}; it was cut off", has, count, what));
  }

  std::shared_ptr<const InputFile> input_;
  TextScanner scanner_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t face_count_ = 0;

  std::vector<Vec3> points_;
  std::vector<std::uint64_t> places_;
  FaceList faces_;
  std::vector<Index> corners_;  // of the face at hand
};

}  // namespace

std::size_t off_keyword_length(std::string_view word) {
  std::size_t length = 0;
  for (const std::string_view part : {"ST", "C", "N", "4", "n"}) {
    if (word.substr(length).starts_with(part)) length += part.size();
  }
  if (!word.substr(length).starts_with("OFF")) return 0;
  length += 3;
  if (length == word.size() || is_blank(word[length]) || is_eol(word[length])) return length;
  return word[length] == '#' || (word[length] >= '0' && word[length] <= '9') ? length : 0;
}

MeshFile read_off(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
