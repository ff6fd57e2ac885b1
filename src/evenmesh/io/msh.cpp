// SPDX-License-Identifier: MIT
#include "evenmesh/io/msh.h"

#include <bit>
#include <charconv>
#include <cstring>

#include <fmt/core.h>

#include "evenmesh/io/byte_patcher.h"
#include "evenmesh/io/msh2.h"
#include "evenmesh/io/msh4.h"
#include "evenmesh/io/msh_content.h"
#include "evenmesh/io/msh_scanner.h"
#include "evenmesh/io/second_order.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

static_assert(std::endian::native == std::endian::little, "swapping is written for this order");

/// How the numbers of a file are written.
enum class Numbers : std::uint8_t { text, binary, swapped };

struct Layout {
  int version = 0;    // 20 to 22, 40 or 41
  bool wide = false;  // tags of elements have 8 bytes
  Numbers numbers = Numbers::text;
};

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void patch_text(const char* p, const char* end, const Vec3& position, BytePatcher& out) {
  for (int k = 0; k < 3; ++k) {
    p = skip_blank(p, end);
    double before = 0.0;
    const char* const stop = scan_number(p, end, before);
    if (stop == nullptr) return;  // the file was changed under our hands: check_unchanged() says so
    if (!same_bits(before, position[k])) out.replace(p, stop, NumberText(position[k]).view());
    p = stop;
  }
}

void patch_binary(const char* p, const Vec3& position, bool swap, BytePatcher& out) {
  for (int k = 0; k < 3; ++k, p += sizeof(double)) {
    if (same_bits(double_at(p, swap), position[k])) continue;
    char bytes[sizeof(double)];
    const auto bits = std::bit_cast<std::uint64_t>(position[k]);
    const std::uint64_t ordered = swap ? __builtin_bswap64(bits) : bits;
    std::memcpy(bytes, &ordered, sizeof(bytes));
    out.replace(p, p + sizeof(bytes), {bytes, sizeof(bytes)});
  }
}

class MshPatch final : public FilePatch {
 public:
  MshPatch(std::shared_ptr<const InputFile> input, Layout layout, std::vector<std::uint64_t> tags,
           std::vector<std::uint64_t> vertices, std::vector<std::uint64_t> cells)
      : input_(std::move(input)),
        layout_(layout),
        tags_(std::move(tags)),
        vertices_(std::move(vertices)),
        cells_(std::move(cells)) {}

  std::string_view format() const override { return "msh"; }

  std::vector<Vec3> representable(Points points) const override {
    return {points.begin(), points.end()};
  }

  void write(Points points, const std::function<void(std::string_view)>& sink) const override {
    input_->check_unchanged();
    const std::string_view bytes = input_->bytes();
    BytePatcher out(bytes, sink);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const char* const place = bytes.data() + vertices_[i];
      if (layout_.numbers == Numbers::text) {
        patch_text(place, bytes.data() + bytes.size(), points[i], out);
      } else {
        patch_binary(place, points[i], layout_.numbers == Numbers::swapped, out);
      }
    }
    out.finish();
    input_->check_unchanged();
  }

  std::string cell_name(std::size_t cell) const override {
    return name("element", cell_number(cell), cells_[cell]);
  }

  std::uint64_t cell_number(std::size_t cell) const override {
    return tag_at(input_->bytes().data() + cells_[cell]);
  }

  std::string vertex_name(Index vertex) const override {
    return name("node", tags_[vertex], vertices_[vertex]);
  }

  std::span<const std::uint64_t> vertex_numbers() const override { return tags_; }

 private:
  std::string name(std::string_view what, std::uint64_t tag, std::uint64_t offset) const {
    if (layout_.numbers != Numbers::text) return fmt::format("{} {}", what, tag);
    return fmt::format("{} {} (line {})", what, tag, input_->line_of(offset));
  }

  std::uint64_t tag_at(const char* p) const {
    const std::string_view bytes = input_->bytes();
    std::uint64_t tag = 0;
    if (layout_.numbers == Numbers::text) {
      std::from_chars(p, bytes.data() + bytes.size(), tag);
      return tag;
    }
    const bool swap = layout_.numbers == Numbers::swapped;
    if (layout_.wide) {
      std::memcpy(&tag, p, sizeof(tag));
      return swap ? __builtin_bswap64(tag) : tag;
    }
    std::uint32_t narrow = 0;
    std::memcpy(&narrow, p, sizeof(narrow));
    return swap ? __builtin_bswap32(narrow) : narrow;
  }

  std::shared_ptr<const InputFile> input_;
  Layout layout_;
  std::vector<std::uint64_t> tags_;      // of the nodes
  std::vector<std::uint64_t> vertices_;  // where each vertex's first coordinate begins
  std::vector<std::uint64_t> cells_;     // where each cell's tag stands
};

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), scanner_(*input_) {}

  MeshFile read() {
    for (;;) {
      const std::string_view section = scanner_.next_section();
      if (section.empty()) break;
      read_section(section, section.data() - 1);
    }
    if (layout_.version == 0) input_->fail("has no $MeshFormat; it is no Gmsh mesh");
    if (content_.nodes.tags.empty()) input_->fail("has no nodes; export the mesh again");
    return take_file();
  }

 private:
  void read_section(std::string_view name, const char* place) {
    if (name == "MeshFormat") {
      read_format(place);
    } else if (name == "NOD" || name == "ELM") {
      scanner_.fail(place,
                    "a Gmsh mesh of version 1 is not read; save it as version 4.1 with 'gmsh -save "
                    "-format msh41'");
    } else if (layout_.version == 0) {
      if (name != "Comments") {
        scanner_.fail(place, fmt::format("${} comes before $MeshFormat, which says how to read it",
                                         shown(name)));
      }
      return skip(name);
    } else if (name == "PhysicalNames") {
      read_physical_names();
    } else if (name == "Entities" && layout_.version >= 40) {
      if (has_elements_) scanner_.fail(place, "$Entities must come before $Elements");
      Msh4Reader(scanner_, content_, layout_.wide).read_entities();
    } else if (name == "Nodes") {
      read_nodes(place);
    } else if (name == "Elements") {
      read_elements(place);
    } else {
      return read_over(name, place);
    }
    scanner_.end_section(name);
  }

  void skip(std::string_view name) {
    scanner_.skip_section(name);
    scanner_.end_section(name);
  }

  /// A section that is kept as it is. Some of them concern what moves.
  void read_over(std::string_view name, const char* place) {
    if (name == "ParametricNodes") {
      scanner_.fail(place,
                    "nodes have parametric coordinates, which would not fit them any more when "
                    "they move; save the mesh with 'gmsh -setnumber Mesh.SaveParametric 0'");
    }
    if (name == "Periodic") {
      notes_.push_back("$Periodic is kept as it is: by itself it does not hold nodes together.");
    }
    if (name == "PartitionedEntities") {
      notes_.push_back("The mesh is partitioned: its groups are the entities of the partitions.");
    }
    skip(name);
  }

  /// A version as text would have it, without its point: 22, 41.
  int read_version() {
    const char* const place = scanner_.item();
    const double version = scanner_.real("the version");
    for (const int known : {20, 21, 22, 40, 41}) {
      if (version == known / 10.0) return known;
    }
    scanner_.fail(place, fmt::format("version {} of the Gmsh format is not read, only 2, 4.0 and "
                                     "4.1; save the mesh with 'gmsh -save -format msh41'",
                                     version));
  }

  void read_format(const char* place) {
    if (layout_.version != 0)
      scanner_.fail(place, "a second $MeshFormat; only one file can be read");
    scanner_.start_record();
    layout_.version = read_version();
    layout_.wide = layout_.version == 41;
    const char* const type_place = scanner_.item();
    const std::int64_t type = scanner_.integer("the file's type");
    const char* const size_place = scanner_.item();
    if (scanner_.integer("the size of numbers") != 8) {
      scanner_.fail(size_place,
                    "numbers of another size than 8 bytes are not read; save the mesh "
                    "again with Gmsh on a 64-bit machine");
    }
    if (type != 0 && type != 1) {
      scanner_.fail(type_place,
                    fmt::format("the file's type must be 0 (text) or 1 (binary), not {}", type));
    }
    scanner_.end_line();
    if (type == 1) read_byte_order();
  }

  /// The number 1 as the file's bytes have it.
  void read_byte_order() {
    const char* const place = scanner_.place();
    scanner_.set_binary(false);
    const std::int64_t one = scanner_.integer("the number 1 that shows the order of bytes");
    const bool swap = one == __builtin_bswap32(1);
    if (one != 1 && !swap) {
      scanner_.fail(place,
                    "the number 1 that shows the order of bytes is missing; the file was "
                    "damaged, perhaps by a transfer as text");
    }
    scanner_.set_binary(swap);
    layout_.numbers = swap ? Numbers::swapped : Numbers::binary;
  }

  void read_physical_names() {
    scanner_.start_line();
    std::int64_t count = scanner_.text_integer("the number of physical groups");
    scanner_.end_line();
    for (; count > 0; --count) {
      scanner_.start_line();
      const std::int64_t dimension = scanner_.text_integer("the dimension of a physical group");
      const std::int64_t tag = scanner_.text_integer("the tag of a physical group");
      std::string_view name = scanner_.rest_of_line();
      if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
        name = name.substr(1, name.size() - 2);
      }
      if (dimension >= 0 && dimension <= 3) {
        MshGroups& groups = dimension < 2 ? content_.side_groups : content_.groups;
        groups.set_name(static_cast<int>(dimension), tag, name);
      }
    }
  }

  void read_nodes(const char* place) {
    if (content_.nodes.is_finished()) scanner_.fail(place, "a second $Nodes; join them with Gmsh");
    if (layout_.version >= 40) {
      Msh4Reader(scanner_, content_, layout_.wide).read_nodes();
    } else {
      read_msh2_nodes(scanner_, content_);
    }
    content_.nodes.finish(scanner_);
  }

  void read_elements(const char* place) {
    if (has_elements_) scanner_.fail(place, "a second $Elements; join them with Gmsh");
    if (!content_.nodes.is_finished()) {
      scanner_.fail(place, "$Elements must come behind $Nodes; save the mesh with Gmsh");
    }
    has_elements_ = true;
    if (layout_.version >= 40) {
      Msh4Reader(scanner_, content_, layout_.wide).read_elements();
    } else {
      read_msh2_elements(scanner_, content_);
    }
  }

  void check_not_torn() const {
    const MshNodes& nodes = content_.nodes;
    if (const auto v = torn_vertex(content_.followers, content_.cells, nodes.points.size())) {
      scanner_.fail(nodes.offsets[*v],
                    torn_message(fmt::format("node {}", nodes.tags[*v]), "element"));
    }
  }

  MeshFile take_file() {
    check_not_torn();
    MeshFile file;
    file.notes = std::move(notes_);
    file.followers = std::move(content_.followers);
    if (content_.cells.empty()) {
      file.notes.push_back("The file has nodes but no elements that make a surface or a volume.");
    }
    file.group_names = content_.groups.names(*input_);
    content_.add_sets(file);
    file.mesh = Mesh(std::move(content_.nodes.points), std::move(content_.cells));
    file.patch = std::make_unique<MshPatch>(input_, layout_, std::move(content_.nodes.tags),
                                            std::move(content_.nodes.offsets),
                                            std::move(content_.cell_offsets));
    return file;
  }

  /// A name from the file as a message may show it.
  static std::string shown(std::string_view name) {
    std::string text = quoted_word(name.data(), name.data() + name.size());
    return text.substr(1, text.size() - 2);
  }

  std::shared_ptr<const InputFile> input_;
  MshScanner scanner_;
  Layout layout_;
  MshContent content_;
  std::vector<std::string> notes_;
  bool has_elements_ = false;
};

}  // namespace

MeshFile read_msh(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
