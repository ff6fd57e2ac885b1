// SPDX-License-Identifier: MIT
#include "evenmesh/io/obj.h"

#include <bit>
#include <limits>
#include <map>

#include <fmt/core.h>

#include "evenmesh/io/byte_patcher.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

/// Every kFaceStride-th face's place is remembered, so that naming a cell need not scan the file.
constexpr std::size_t kFaceStride = 1024;

/// The names of all groups may be so many times longer than the file. No honest file comes near.
constexpr std::size_t kNameRatio = 32;

/// Goes through an OBJ file statement by statement. A statement is a line, or several that are
/// joined by a backslash at the end; empty lines and comments are none.
class Statements {
 public:
  Statements(const char* begin, const char* end) : p_(begin), end_(end) {}

  /// Moves to the first character of the next statement.
  /// @return  false at the end of the file
  bool next() {
    while (p_ != end_) {
      if (is_blank(*p_) || is_eol(*p_)) {
        ++p_;
      } else if (*p_ == '#') {
        skip_line();
      } else if (const int length = continuation_length(p_, end_)) {
        p_ += length;
      } else {
        return true;
      }
    }
    return false;
  }

  /// Moves to the end of the line.
  void skip_line() {
    while (p_ != end_ && !is_eol(*p_)) ++p_;
  }

  /// Moves to the end of the statement. A comment behind it ends with its line.
  void skip_statement() {
    for (const char* line = p_;; line = p_) {
      skip_line();
      if (p_ == end_ || p_ == line || p_[-1] != '\\' || has_comment(line, p_)) return;
      p_ += continuation_length(p_ - 1, end_) - 1;
    }
  }

  /// Whether the statement at hand is of this kind.
  bool is(std::string_view keyword) const {
    return static_cast<std::size_t>(end_ - p_) >= keyword.size() &&
           std::string_view(p_, keyword.size()) == keyword && ends_word(p_ + keyword.size(), end_);
  }

  const char* place() const { return p_; }
  void set_place(const char* p) { p_ = p; }

 private:
  static bool has_comment(const char* line, const char* end) {
    for (const char* p = line; p != end; ++p) {
      if (*p == '#' && (p == line || is_blank(p[-1]))) return true;
    }
    return false;
  }

  const char* p_;
  const char* end_;
};

/// Replaces the words of one vertex that moved.
void patch_vertex(const char* p, const char* end, const Vec3& position, BytePatcher& out) {
  for (int k = 0; k < 3; ++k) {
    p = skip_blank(p, end);
    double before = 0.0;
    const char* const stop = scan_number(p, end, before);
    if (stop == nullptr) return;  // the file was changed under our hands: check_unchanged() says so
    if (std::bit_cast<std::uint64_t>(before) != std::bit_cast<std::uint64_t>(position[k])) {
      out.replace(p, stop, NumberText(position[k]).view());
    }
    p = stop;
  }
}

class ObjPatch final : public FilePatch {
 public:
  ObjPatch(std::shared_ptr<const InputFile> input, std::vector<std::uint64_t> vertices,
           std::vector<std::uint64_t> faces)
      : input_(std::move(input)), vertices_(std::move(vertices)), faces_(std::move(faces)) {}

  std::string_view format() const override { return "obj"; }

  std::vector<Vec3> representable(Points points) const override {
    return {points.begin(), points.end()};
  }

  void write(Points points, const std::function<void(std::string_view)>& sink) const override {
    input_->check_unchanged();
    const std::string_view bytes = input_->bytes();
    BytePatcher out(bytes, sink);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      patch_vertex(bytes.data() + vertices_[i], bytes.data() + bytes.size(), points[i], out);
    }
    out.finish();
    input_->check_unchanged();
  }

  std::string cell_name(std::size_t cell) const override {
    const std::string_view bytes = input_->bytes();
    const char* const end = bytes.data() + bytes.size();
    Statements statements(bytes.data() + faces_[cell / kFaceStride], end);
    for (std::size_t left = cell % kFaceStride; statements.next(); statements.skip_statement()) {
      if (statements.is("f") && left-- == 0) break;
    }
    const auto offset = static_cast<std::size_t>(statements.place() - bytes.data());
    return fmt::format("face {} (line {})", cell + 1, input_->line_of(offset));
  }

  std::string vertex_name(Index vertex) const override {
    return fmt::format("vertex {} (line {})", vertex + 1, input_->line_of(vertices_[vertex]));
  }

 private:
  std::shared_ptr<const InputFile> input_;
  std::vector<std::uint64_t> vertices_;  // where each vertex's first coordinate begins
  std::vector<std::uint64_t> faces_;     // where faces 0, kFaceStride, 2 kFaceStride ... begin
};

/// The object, group and material in force, and the numbers of their combinations.
class Groups {
 public:
  void set_object(std::string name) { set(object_, std::move(name)); }
  void set_group(std::string name) { set(group_, std::move(name)); }
  void set_material(std::string name) { set(material_, std::move(name)); }

  std::uint32_t number() {
    if (stale_) {
      number_ = find();
      stale_ = false;
    }
    return number_;
  }
  std::vector<std::string> take_names() { return std::move(names_); }

  /// Length of all names. One object's name goes into the names of all combinations with it, so
  /// this may exceed the file.
  std::size_t name_bytes() const { return name_bytes_; }

 private:
  void set(std::string& which, std::string name) {
    which = std::move(name);
    stale_ = true;
  }

  std::uint32_t find() {
    std::string name;
    const auto append = [&](std::string_view keyword, const std::string& value) {
      if (value.empty()) return;
      if (!name.empty()) name += ", ";
      name.append(keyword).append(" ").append(value);
    };
    append("o", object_);
    append("g", group_);
    append("usemtl", material_);
    if (name.empty()) return 0;
    const auto [place, is_new] = numbers_.emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) {
      name_bytes_ += name.size();
      names_.push_back(std::move(name));
    }
    return place->second;
  }

  std::string object_, group_, material_;
  std::map<std::string, std::uint32_t> numbers_;
  std::vector<std::string> names_{""};
  std::size_t name_bytes_ = 0;
  std::uint32_t number_ = 0;
  bool stale_ = false;
};

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)),
        begin_(input_->bytes().data()),
        end_(begin_ + input_->bytes().size()),
        statements_(begin_ + (input_->bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0), end_) {}

  MeshFile read() {
    while (statements_.next()) read_statement();
    check_corners();

    MeshFile file;
    if (cells_.empty()) file.notes.push_back("The file has vertices but no faces.");
    file.mesh = Mesh(std::move(points_), std::move(cells_));
    file.group_names = groups_.take_names();
    file.patch = std::make_unique<ObjPatch>(input_, std::move(vertices_), std::move(faces_));
    return file;
  }

 private:
  void read_statement() {
    const char* const p = statements_.place();
    switch (*p) {
      case 'v':
        if (statements_.is("v")) return read_vertex(p + 1);
        break;
      case 'f':
        if (statements_.is("f")) return read_face(p);
        break;
      case 'o':
        if (statements_.is("o")) return groups_.set_object(read_name(p + 1));
        break;
      case 'g':
        if (statements_.is("g")) return groups_.set_group(read_name(p + 1));
        break;
      case 'u':
        if (statements_.is("usemtl")) return groups_.set_material(read_name(p + 6));
        break;
      default:
        if (static_cast<unsigned char>(*p) < ' ') {
          input_->fail_at(p, "binary data in an OBJ file; it was damaged or is another format");
        }
    }
    statements_.skip_statement();
  }

  void read_vertex(const char* p) {
    Vec3 position;
    for (int k = 0; k < 3; ++k) {
      p = skip_blank(p, end_);
      if (k == 0) vertices_.push_back(offset(p));
      const char* const stop = scan_number(p, end_, position[k]);
      if (stop == nullptr) fail_in_vertex(p, k);
      p = stop;
    }
    points_.push_back(position);
    p = skip_blank(p, end_);
    if (!ends_statement(p)) p = check_extras(p);
    statements_.set_place(p);
  }

  /// Numbers behind the coordinates: a weight, a colour. They are kept, but a word that is no
  /// number means that two lines ran together, and a vertex would be lost without a word.
  const char* check_extras(const char* p) const {
    for (; !ends_statement(p); p = skip_blank(p, end_)) {
      double ignored = 0.0;
      const char* const stop = scan_number(p, end_, ignored);
      if (stop == nullptr) input_->fail_at(p, explain_bad_number(p, end_));
      p = stop;
    }
    return p;
  }

  [[noreturn]] void fail_in_vertex(const char* p, int k) const {
    if (ends_statement(p)) {
      input_->fail_at(p, fmt::format("vertex {} has {} of 3 coordinates", points_.size() + 1, k));
    }
    input_->fail_at(p, explain_bad_number(p, end_));
  }

  void read_face(const char* p) {
    const char* const start = p;
    corners_.clear();
    for (p = skip_blank(p + 1, end_); !ends_statement(p); p = skip_blank(p, end_)) {
      p = read_corner(p);
    }
    if (corners_.size() < 3) {
      input_->fail_at(start, fmt::format("face {} has {} vertices; a face needs three or more",
                                         cells_.size() + 1, corners_.size()));
    }
    if (cells_.size() % kFaceStride == 0) faces_.push_back(offset(start));
    const CellKind kind = corners_.size() == 3   ? CellKind::triangle
                          : corners_.size() == 4 ? CellKind::quad
                                                 : CellKind::polygon;
    cells_.add(kind, corners_, groups_.number());
    if (groups_.name_bytes() > kNameRatio * input_->bytes().size()) {
      input_->fail_at(start,
                      "the names of objects, groups and materials are too long for so many "
                      "combinations of them; shorten them");
    }
    statements_.set_place(p);
  }

  /// Reads `v`, `v/vt`, `v//vn` or `v/vt/vn` and appends v to corners_.
  /// @return  the end of the word
  const char* read_corner(const char* const word) {
    const bool negative = *word == '-';
    const char* p = negative || *word == '+' ? word + 1 : word;
    std::uint64_t number = 0;
    for (const char* const first = p; p != end_ && *p >= '0' && *p <= '9'; ++p) {
      number = 10 * number + static_cast<std::uint64_t>(*p - '0');
      if (p - first >= 18) fail_index(word);
    }
    if (number == 0) fail_index(word);
    if (p != end_ && *p == '/') p = skip_references(p);
    if (!ends_word(p, end_)) fail_index(word);

    if (negative) {
      if (number > points_.size()) fail_index(word);
      corners_.push_back(static_cast<Index>(points_.size() - number));
    } else {
      if (number >= std::numeric_limits<Index>::max()) fail_index(word);
      if (number > largest_) {
        largest_ = number;
        largest_at_ = word;
      }
      corners_.push_back(static_cast<Index>(number - 1));
    }
    return p;
  }

  /// Skips the texture and normal references at p, which begin with a slash.
  const char* skip_references(const char* p) const {
    for (int slashes = 0; slashes < 2 && p != end_ && *p == '/'; ++slashes) {
      ++p;
      if (p != end_ && (*p == '-' || *p == '+')) ++p;
      while (p != end_ && *p >= '0' && *p <= '9') ++p;
    }
    return p;
  }

  [[noreturn]] void fail_index(const char* word) const {
    input_->fail_at(
        word, fmt::format("face {} names vertex {}; a vertex number counts from 1, or back from -1 "
                          "for the latest of the {} vertices read so far",
                          cells_.size() + 1, quoted_word(word, end_), points_.size()));
  }

  /// The rest of the statement as one line without blanks around it.
  std::string read_name(const char* p) {
    statements_.skip_statement();
    const char* const stop = statements_.place();
    std::string name;
    for (p = skip_blank(p, stop); p != stop;) {
      const int length = continuation_length(p, stop);
      name += length != 0 ? ' ' : *p;
      p += length != 0 ? length : 1;
    }
    while (!name.empty() && is_blank(name.back())) name.pop_back();
    return name;
  }

  /// Faces may come before their vertices, so this can only be judged at the end.
  void check_corners() const {
    if (largest_ > points_.size()) {
      input_->fail_at(largest_at_,
                      fmt::format("a face uses vertex {}, but the file has {} vertices", largest_,
                                  points_.size()));
    }
    if (points_.empty()) {
      input_->fail("has no vertices (lines that begin with 'v'); it is empty or no OBJ file");
    };
    if (points_.size() >= std::numeric_limits<Index>::max()) {
      input_->fail("has more vertices than 32-bit numbers can count");
    }
  }

  bool ends_statement(const char* p) const { return p == end_ || is_eol(*p) || *p == '#'; }
  std::uint64_t offset(const char* p) const { return static_cast<std::uint64_t>(p - begin_); }

  std::shared_ptr<const InputFile> input_;
  const char* begin_;
  const char* end_;
  Statements statements_;

  std::vector<Vec3> points_;
  Cells cells_;
  Groups groups_;
  std::vector<std::uint64_t> vertices_;
  std::vector<std::uint64_t> faces_;
  std::vector<Index> corners_;  // of the face at hand
  std::uint64_t largest_ = 0;   // vertex number in a face, counted from 1
  const char* largest_at_ = nullptr;
};

}  // namespace

MeshFile read_obj(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
