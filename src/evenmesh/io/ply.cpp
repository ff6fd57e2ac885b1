// SPDX-License-Identifier: MIT
#include "evenmesh/io/ply.h"

#include <limits>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/io/byte_scanner.h"
#include "evenmesh/io/face_list.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/ply_header.h"
#include "evenmesh/io/text_scanner.h"

namespace evenmesh {
namespace {

/// Takes numbers one by one from a text.
class TextSource {
 public:
  TextSource(const InputFile& input, std::uint64_t data) : scanner_(input) {
    scanner_.set_place(input.bytes().data() + data);
  }
  double real(NumberType) { return scanner_.real("a number"); }
  std::int64_t integer(NumberType) { return scanner_.integer("a whole number"); }
  void skip(NumberType) {
    if (scanner_.word().empty()) {
      scanner_.fail("the file ends here; it was cut off, copy or export it again");
    }
  }
  std::uint64_t place() {
    scanner_.next();
    return scanner_.offset();
  }
  void check_room(std::uint64_t number, std::size_t properties, std::string_view things) const {
    scanner_.check_room(number, 2 * std::max<std::size_t>(properties, 1), things);
  }
  /// Each thing has a line, on which there may be more than the header says.
  void end_thing() { scanner_.skip_line(); }
  bool has_more() { return scanner_.next(); }
  [[noreturn]] void fail(std::uint64_t place, std::string_view message) const {
    scanner_.input().fail_at(place, message);
  }

 private:
  TextScanner scanner_;
};

/// The same from bytes.
class ByteSource {
 public:
  ByteSource(const InputFile& input, std::uint64_t data, bool swap) : scanner_(input, data, swap) {}
  double real(NumberType type) {
    return type == NumberType::float32 ? static_cast<double>(scanner_.take<float>())
                                       : scanner_.take<double>();
  }
  std::int64_t integer(NumberType type) {
    switch (type) {
      case NumberType::int8:
        return scanner_.take<std::int8_t>();
      case NumberType::uint8:
        return scanner_.take<std::uint8_t>();
      case NumberType::int16:
        return scanner_.take<std::int16_t>();
      case NumberType::uint16:
        return scanner_.take<std::uint16_t>();
      case NumberType::int32:
        return scanner_.take<std::int32_t>();
      default:
        return scanner_.take<std::uint32_t>();
    }
  }
  void skip(NumberType type) { scanner_.skip(size_of(type)); }
  std::uint64_t place() const { return scanner_.offset(); }
  void check_room(std::uint64_t number, std::size_t bytes, std::string_view things) const {
    scanner_.check_room(number, std::max<std::size_t>(bytes, 1), things);
  }
  void end_thing() {}
  bool has_more() const { return scanner_.rest() > 0; }
  [[noreturn]] void fail(std::uint64_t place, std::string_view message) const {
    scanner_.fail(place, message);
  }

 private:
  ByteScanner scanner_;
};

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), header_(read_ply_header(*input_)) {}

  MeshFile read() {
    check_elements();
    if (header_.code == PlyHeader::Code::text) {
      TextSource source(*input_, header_.data);
      read_all(source);
    } else {
      ByteSource source(*input_, header_.data, header_.code == PlyHeader::Code::big_endian);
      read_all(source);
    }
    return take_file();
  }

 private:
  void check_elements() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") check_vertex(element);
      if (element.name == "tristrips") {
        input_->fail_at(element.place, "triangle strips are not read; export it with faces");
      }
    }
    if (vertex_ == nullptr || vertex_->count == 0) input_->fail("has no vertices; export it again");
  }

  void check_vertex(const PlyElement& element) {
    if (vertex_ != nullptr) input_->fail_at(element.place, "a second element 'vertex'");
    vertex_ = &element;
    const auto& properties = element.properties;
    while (first_ < properties.size() && properties[first_].name != "x") ++first_;
    const bool in_order = first_ + 2 < properties.size() && properties[first_ + 1].name == "y" &&
                          properties[first_ + 2].name == "z";
    if (!in_order) {
      input_->fail_at(element.place,
                      "the properties x, y and z of a vertex must follow each other");
    }
    const NumberType type = properties[first_].type;
    for (std::size_t k = first_; k < first_ + 3; ++k) {
      if (properties[k].is_list || properties[k].type != type || !is_real(type)) {
        input_->fail_at(properties[k].place, "coordinates must be float or double, all the same");
      }
    }
    code_.single = type == NumberType::float32;
    if (header_.code == PlyHeader::Code::text) return;
    code_.kind = code_.single ? CoordinateCode::Kind::float32 : CoordinateCode::Kind::float64;
    code_.swap = header_.code == PlyHeader::Code::big_endian;
  }

  /// The least that one thing takes: numbers in a text, bytes else.
  std::size_t least(const PlyElement& element) const {
    std::size_t sum = 0;
    for (const PlyProperty& property : element.properties) {
      const NumberType type = property.is_list ? property.count_type : property.type;
      sum += header_.code == PlyHeader::Code::text ? 1 : size_of(type);
    }
    return sum;
  }

  template <typename Source>
  void read_all(Source& source) {
    for (const PlyElement& element : header_.elements) {
      source.check_room(element.count, least(element), element.name);
      if (&element == vertex_) {
        points_.reserve(element.count);
        places_.reserve(element.count);
      } else if (element.name == "face") {
        faces_.reserve(element.count);
      }
      if (element.properties.empty()) continue;
      for (std::uint64_t i = 0; i < element.count; ++i) read_one(source, element, i);
    }
    has_more_ = source.has_more();
  }

  template <typename Source>
  void read_one(Source& source, const PlyElement& element, std::uint64_t number) {
    const std::uint64_t place = source.place();
    bool has_face = false;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (&element == vertex_ && i == first_) {
        read_position(source, property.type);
        i += 2;
      } else if (property.is_list) {
        const bool is_face = element.name == "face" && !has_face &&
                             (property.name == "vertex_indices" || property.name == "vertex_index");
        read_list(source, property, number, is_face);
        if (is_face) {
          // Faces may come before the vertices; their numbers are checked at the end.
          faces_.add(corners_, place);
          has_face = true;
        }
      } else {
        source.skip(property.type);
      }
    }
    source.end_thing();
  }

  template <typename Source>
  void read_position(Source& source, NumberType type) {
    const std::uint64_t place = source.place();
    Vec3 position;
    for (int k = 0; k < 3; ++k) position[k] = source.real(type);
    if (!position.allFinite()) {
      source.fail(place, fmt::format("vertex {} has a coordinate that is no finite number; repair "
                                     "the file or write it again",
                                     points_.size()));
    }
    places_.push_back(place);
    points_.push_back(position);
  }

  template <typename Source>
  void read_list(Source& source, const PlyProperty& property, std::uint64_t number, bool is_face) {
    const std::uint64_t place = source.place();
    const std::int64_t count = source.integer(property.count_type);
    if (count < 0) source.fail(place, fmt::format("a list of {} numbers", count));
    const bool text = header_.code == PlyHeader::Code::text;
    source.check_room(static_cast<std::uint64_t>(count), text ? 1 : size_of(property.type),
                      "numbers in a list");
    if (is_face) corners_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      if (!is_face) {
        source.skip(property.type);
        continue;
      }
      if (is_real(property.type)) {
        input_->fail_at(property.place, "the vertices of faces are no whole numbers");
      }
      const std::uint64_t at = source.place();
      const std::int64_t vertex = source.integer(property.type);
      if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertex_->count) {
        source.fail(at, fmt::format("face {} names vertex {}; the {} vertices count from 0", number,
                                    vertex, vertex_->count));
      }
      corners_.push_back(static_cast<Index>(vertex));
    }
  }

  MeshFile take_file() {
    MeshFile file;
    if (points_.size() >= std::numeric_limits<Index>::max()) {
      input_->fail("has more vertices than 32-bit numbers can count");
    }
    if (vertex_->find("nx") != nullptr)
      file.notes.push_back("Vertex normals are kept as they are.");
    faces_.append_notes(file.notes);
    if (has_more_) file.notes.push_back("What follows the last element is kept but not read.");
    file.mesh = Mesh(std::move(points_), faces_.take_cells());
    FileNumbers numbers{.cell = "face", .cells = faces_.take_numbers()};
    if (header_.code == PlyHeader::Code::text) numbers.cell_places = faces_.take_places();
    file.patch =
        std::make_unique<PlacedPatch>("ply", input_, code_, std::move(places_), std::move(numbers));
    return file;
  }

  std::shared_ptr<const InputFile> input_;
  PlyHeader header_;
  const PlyElement* vertex_ = nullptr;
  std::size_t first_ = 0;  // property of a vertex that is x
  CoordinateCode code_;
  std::vector<Vec3> points_;
  std::vector<std::uint64_t> places_;
  FaceList faces_;
  std::vector<Index> corners_;  // of the face at hand
  bool has_more_ = false;
};

}  // namespace

MeshFile read_ply(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
