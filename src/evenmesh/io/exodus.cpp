// SPDX-License-Identifier: MIT
#include "evenmesh/io/exodus.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/byte_patcher.h"
#include "evenmesh/io/netcdf_header.h"
#include "evenmesh/io/placed_patch.h"
#include "evenmesh/io/second_order.h"
#include "evenmesh/io/side_labels.h"

namespace evenmesh {
namespace {

constexpr bool kSwap = std::endian::native == std::endian::little;

/// Where the coordinates stand: x of all nodes, then y, then z, or in another order.
struct CoordinateArrays {
  std::array<std::uint64_t, 3> begin{};
  int dimension = 3;
  CoordinateCode code = {};
};

class ExodusPatch : public PlacedPatch {
 public:
  ExodusPatch(std::shared_ptr<const InputFile> input, const CoordinateArrays& arrays,
              FileNumbers numbers)
      : PlacedPatch("exodus", input, arrays.code, {}, std::move(numbers)),
        input_(std::move(input)),
        arrays_(arrays) {}

  void write(Points points, const std::function<void(std::string_view)>& sink) const override {
    input_->check_unchanged();
    const std::string_view bytes = input_->bytes();
    std::vector<int> order{0, 1, 2};
    order.resize(static_cast<std::size_t>(arrays_.dimension));
    std::ranges::sort(order, {}, [this](int axis) { return begin(axis); });
    BytePatcher out(bytes, sink);
    for (const int axis : order) {
      const char* const first = bytes.data() + begin(axis);
      for (std::size_t v = 0; v < points.size(); ++v) {
        if (arrays_.code.kind == CoordinateCode::Kind::float32) {
          patch(first + 4 * v, static_cast<float>(points[v][axis]), out);
        } else {
          patch(first + 8 * v, points[v][axis], out);
        }
      }
    }
    out.finish();
    input_->check_unchanged();
  }

 private:
  std::uint64_t begin(int axis) const { return arrays_.begin[static_cast<std::size_t>(axis)]; }

  template <typename Number>
  static void patch(const char* place, Number wanted, BytePatcher& out) {
    std::array<char, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), &wanted, sizeof wanted);
    if (kSwap) std::reverse(bytes.begin(), bytes.end());
    if (std::memcmp(bytes.data(), place, bytes.size()) == 0) return;
    out.replace(place, place + bytes.size(), {bytes.data(), bytes.size()});
  }

  std::shared_ptr<const InputFile> input_;
  CoordinateArrays arrays_;
};

// ---- elements ----------------------------------------------------------------------------------
struct ElementType {
  CellKind kind = CellKind::triangle;
  std::size_t corners = 0;  // 0: no cell; its nodes are held
  bool is_shell = false;    // whose first two sides are its faces
};

/// Those without a surface, whatever else is in their name.
constexpr std::array<std::string_view, 10> kNoCells{"SPHERE", "CIRCLE", "BAR",  "BEAM",  "TRUSS",
                                                    "ROD",    "EDGE",   "LINE", "POINT", "SPRING"};

struct Family {
  std::string_view name;  // how its name begins
  CellKind kind;
  std::size_t corners;
  std::array<std::size_t, 4> nodes;  // how many there may be
};
constexpr std::array kFamilies{
    Family{"TRI", CellKind::triangle, 3, {3, 6, 7}}, Family{"QUAD", CellKind::quad, 4, {4, 8, 9}},
    Family{"SHELL", CellKind::quad, 4, {4, 8, 9}},   Family{"TET", CellKind::tet, 4, {4, 10}},
    Family{"PYR", CellKind::pyramid, 5, {5, 13}},    Family{"WEDGE", CellKind::wedge, 6, {6, 15}},
    Family{"HEX", CellKind::hex, 8, {8, 20, 27}},
};

/// Local corners of the sides of volume elements, in the order of their numbers.
using Side = std::array<std::uint8_t, 4>;
constexpr std::uint8_t kNone = 255;
constexpr std::array<Side, 4> kTetSides{Side{0, 1, 3, kNone}, Side{1, 2, 3, kNone},
                                        Side{0, 3, 2, kNone}, Side{0, 2, 1, kNone}};
constexpr std::array<Side, 6> kHexSides{Side{0, 1, 5, 4}, Side{1, 2, 6, 5}, Side{2, 3, 7, 6},
                                        Side{0, 4, 7, 3}, Side{0, 3, 2, 1}, Side{4, 5, 6, 7}};
constexpr std::array<Side, 5> kWedgeSides{Side{0, 1, 4, 3}, Side{1, 2, 5, 4}, Side{0, 3, 5, 2},
                                          Side{0, 2, 1, kNone}, Side{3, 4, 5, kNone}};
constexpr std::array<Side, 5> kPyramidSides{Side{0, 1, 4, kNone}, Side{1, 2, 4, kNone},
                                            Side{2, 3, 4, kNone}, Side{0, 4, 3, kNone},
                                            Side{0, 3, 2, 1}};

std::span<const Side> sides_of(CellKind kind) {
  switch (kind) {
    case CellKind::tet:
      return kTetSides;
    case CellKind::hex:
      return kHexSides;
    case CellKind::wedge:
      return kWedgeSides;
    case CellKind::pyramid:
      return kPyramidSides;
    default:
      return {};
  }
}

/// The vertices of a side of a cell, counted from 0; empty if it has no such side.
std::vector<Index> side_vertices(CellKind kind, std::span<const Index> corners, bool is_shell,
                                 std::uint64_t side) {
  const std::span<const Side> sides = sides_of(kind);
  std::vector<Index> result;
  if (!sides.empty()) {
    if (side >= sides.size()) return {};
    for (const std::uint8_t i : sides[side]) {
      if (i != kNone) result.push_back(corners[i]);
    }
    return result;
  }
  const std::size_t faces = is_shell ? 2 : 0;
  if (side < faces) return {corners.begin(), corners.end()};
  const std::size_t edge = side - faces;
  if (edge >= corners.size()) return {};
  return {corners[edge], corners[(edge + 1) % corners.size()]};
}

class Reader {
 public:
  explicit Reader(std::shared_ptr<const InputFile> input)
      : input_(std::move(input)), header_(read_netcdf_header(*input_)) {}

  MeshFile read() {
    read_points();
    const std::uint64_t blocks = header_.length("num_el_blk");
    if (blocks > header_.variables.size()) fail("has fewer blocks of elements than it promises");
    for (std::uint64_t block = 1; block <= blocks; ++block) read_block(block);
    take_numbers("elem_num_map", cells_in_file_, numbers_.cells);
    take_numbers("node_num_map", points_.size(), numbers_.vertices);
    if (!numbers_.cells.empty() || cells_in_file_ != cells_.size()) number_cells();
    return take_file();
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    input_->fail(fmt::format("{}; export it again", message));
  }

  // ---- arrays --------------------------------------------------------------------------------
  const char* data(const NetcdfVariable& variable) const {
    return input_->bytes().data() + variable.begin;
  }

  /// Calls take with each number of an array of whole numbers.
  template <typename Take>
  void for_each(const NetcdfVariable& variable, const Take& take) const {
    if (!variable.type || is_real(*variable.type) || variable.is_record) {
      fail(fmt::format("has no whole numbers in {}", shown(variable.name)));
    }
    const std::string_view bytes =
        input_->bytes().substr(variable.begin, variable.size() * size_of(*variable.type));
    for_each_number(bytes, *variable.type, kSwap, [&](auto value) {
      if constexpr (std::is_integral_v<decltype(value)>) take(static_cast<std::int64_t>(value));
    });
  }

  std::vector<std::int64_t> whole_numbers(std::string_view name) const {
    std::vector<std::int64_t> result;
    const NetcdfVariable* const variable = header_.find(name);
    if (variable == nullptr) return result;
    result.reserve(variable->size());
    for_each(*variable, [&](std::int64_t value) { result.push_back(value); });
    return result;
  }

  /// What the file calls the i-th of some things, counted from 1: a name, else a number.
  std::string name_of(std::string_view names, std::string_view ids, std::uint64_t i) const {
    const NetcdfVariable* const letters = header_.find(names);
    if (letters != nullptr && !letters->type && letters->shape.size() == 2 &&
        i <= letters->shape[0]) {
      const std::size_t width = letters->shape[1];
      std::string name(data(*letters) + (i - 1) * width, width);
      name.erase(std::min(name.find('\0'), name.size()));
      while (!name.empty() && name.back() == ' ') name.pop_back();
      if (!name.empty()) return name;
    }
    const NetcdfVariable* const numbers = header_.find(ids);
    auto number = static_cast<std::int64_t>(i);
    if (numbers != nullptr && numbers->type && i <= numbers->size()) {
      NetcdfVariable one = *numbers;
      one.shape = {1};
      one.begin += (i - 1) * size_of(*one.type);
      for_each(one, [&](std::int64_t found) { number = found; });
    }
    return std::to_string(number);
  }

  // ---- nodes ---------------------------------------------------------------------------------
  const NetcdfVariable& coordinates(std::string_view name, std::size_t count) {
    const NetcdfVariable* const found = header_.find(name);
    if (found == nullptr || !found->type || !is_real(*found->type) || found->is_record ||
        found->size() != count) {
      fail(fmt::format("is netCDF, but its nodes have no {} as Exodus has it", name));
    }
    const auto kind = *found->type == NumberType::float32 ? CoordinateCode::Kind::float32
                                                          : CoordinateCode::Kind::float64;
    if (arrays_.begin[0] != 0 && kind != arrays_.code.kind) {
      fail("has coordinates of different types");
    }
    arrays_.code.kind = kind;
    return *found;
  }

  void read_points() {
    const std::uint64_t nodes = header_.length("num_nodes");
    const std::uint64_t dimension = header_.length("num_dim");
    if (nodes == 0) fail("has no nodes");
    if (dimension != 2 && dimension != 3) {
      fail(fmt::format("has {} coordinates; 2 and 3 are read", dimension));
    }
    arrays_.dimension = static_cast<int>(dimension);
    arrays_.code.dimension = arrays_.dimension;
    arrays_.code.swap = kSwap;
    constexpr std::array<std::string_view, 3> kNames{"coordx", "coordy", "coordz"};
    const bool together = header_.find("coord") != nullptr;
    for (std::size_t k = 0; k < dimension; ++k) {
      const NetcdfVariable& found =
          together ? coordinates("coord", dimension * nodes) : coordinates(kNames[k], nodes);
      arrays_.begin[k] =
          found.begin + (together ? k * nodes * arrays_.code.bytes_each() : std::uint64_t{0});
    }
    points_.reserve(nodes);
    for (std::uint64_t v = 0; v < nodes; ++v) points_.push_back(position(v));
  }

  Vec3 position(std::uint64_t v) const {
    Vec3 result = Vec3::Zero();
    const std::size_t bytes = arrays_.code.bytes_each();
    for (int k = 0; k < arrays_.dimension; ++k) {
      const char* const place =
          input_->bytes().data() + arrays_.begin[static_cast<std::size_t>(k)] + v * bytes;
      result[k] =
          bytes == 4 ? double{number_at<float>(place, kSwap)} : number_at<double>(place, kSwap);
    }
    if (!result.allFinite()) {
      fail(fmt::format("has a coordinate of node {} that is no finite number", v + 1));
    }
    return result;
  }

  // ---- elements ------------------------------------------------------------------------------
  ElementType type_of(std::string_view name, std::size_t nodes) const {
    std::string word;
    for (const char c : name) {
      if (c == '\0') break;
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    for (const std::string_view none : kNoCells) {
      if (word.starts_with(none)) return {};
    }
    if (word.starts_with("SHELL") && (nodes == 3 || nodes == 6)) word = "TRI";
    for (const Family& family : kFamilies) {
      if (!word.starts_with(family.name)) continue;
      if (nodes == 0 || std::ranges::find(family.nodes, nodes) == family.nodes.end()) break;
      const bool flat = traits(family.kind).dimension == 2;
      return {family.kind, family.corners,
              flat && (arrays_.dimension == 3 || word.find("SHELL") != std::string::npos)};
    }
    input_->fail(
        fmt::format("elements {} with {} nodes are not read; save the mesh with elements of "
                    "first or second order",
                    shown(name), nodes));
  }

  void read_block(std::uint64_t block) {
    const NetcdfVariable* const connect = header_.find(fmt::format("connect{}", block));
    if (connect == nullptr) {
      if (header_.length(fmt::format("num_el_in_blk{}", block)) > 0) {
        fail(fmt::format("has block {} of elements without their nodes", block));
      }
      return;
    }
    if (connect->shape.size() != 2 || connect->is_record) {
      fail(fmt::format("has elements in connect{} that are not read", block));
    }
    const std::size_t nodes = connect->shape[1];
    const ElementType type = type_of(connect->element_type, nodes);
    const auto group = static_cast<std::uint32_t>(names_.size());
    names_.push_back("block " + name_of("eb_names", "eb_prop1", block));
    blocks_.push_back({cells_in_file_, connect->shape[0], cells_.size(), type});
    if (type.corners > 0) {
      cells_.reserve(cells_.size() + connect->shape[0],
                     cells_.corners().size() + connect->shape[0] * type.corners);
    }
    std::vector<Index> element;
    for_each(*connect, [&](std::int64_t node) {
      if (node < 1 || static_cast<std::uint64_t>(node) > points_.size()) {
        fail(fmt::format("has element {} with node {}; there are {}", cells_in_file_ + 1, node,
                         points_.size()));
      }
      element.push_back(static_cast<Index>(node - 1));
      if (element.size() < nodes) return;
      add_element(type, group, element);
      element.clear();
    });
  }

  void add_element(const ElementType& type, std::uint32_t group, std::vector<Index>& nodes) {
    ++cells_in_file_;
    if (type.corners == 0) {
      held_.insert(held_.end(), nodes.begin(), nodes.end());
      return;
    }
    cells_.add(type.kind, std::span(nodes).first(type.corners), group);
    constexpr std::size_t kFull = 27;
    constexpr std::size_t kEdges = 20;
    if (nodes.size() == kFull) {
      // Behind the edges: the middle, bottom, top, left, right, front, back; ours has the middle
      // last and bottom and top before it.
      std::rotate(nodes.begin() + kEdges, nodes.begin() + kEdges + 3, nodes.end());
      std::rotate(nodes.begin() + kEdges + 4, nodes.begin() + kEdges + 5, nodes.end());
    }
    add_followers(type.kind, EdgeOrder::nastran, nodes, followers_);
  }

  // ---- numbers -------------------------------------------------------------------------------
  void take_numbers(std::string_view name, std::size_t count,
                    std::vector<std::uint64_t>& numbers) const {
    const std::vector<std::int64_t> found = whole_numbers(name);
    const bool counted = [&] {
      for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] != static_cast<std::int64_t>(i + 1)) return false;
      }
      return true;
    }();
    const bool is_map = found.size() == count &&
                        std::ranges::all_of(found, [](std::int64_t number) { return number > 0; });
    if (is_map && !counted) numbers.assign(found.begin(), found.end());
  }

  /// Numbers of all elements become those of the cells.
  void number_cells() {
    std::vector<std::uint64_t> result;
    result.reserve(cells_.size());
    for (const Block& block : blocks_) {
      if (block.type.corners == 0) continue;
      for (std::uint64_t i = 0; i < block.elements; ++i) {
        const std::uint64_t element = block.first_element + i;
        result.push_back(numbers_.cells.empty() ? element + 1 : numbers_.cells[element]);
      }
    }
    numbers_.cells = std::move(result);
  }

  // ---- sets ----------------------------------------------------------------------------------
  void add_node_sets(MeshFile& file) const {
    const std::uint64_t sets =
        std::min<std::uint64_t>(header_.length("num_node_sets"), header_.variables.size());
    for (std::uint64_t set = 1; set <= sets; ++set) {
      std::vector<Index> vertices;
      for (const std::int64_t node : whole_numbers(fmt::format("node_ns{}", set))) {
        if (node < 1 || static_cast<std::uint64_t>(node) > points_.size()) {
          fail(fmt::format("has node {} in a node set; there are {}", node, points_.size()));
        }
        vertices.push_back(static_cast<Index>(node - 1));
      }
      const std::size_t members = vertices.size();
      file.sets.push_back(named_list("nset", name_of("ns_names", "ns_prop1", set), members,
                                     "vertices", std::move(vertices)));
    }
  }

  void add_side_sets(MeshFile& file, SideLabels& labels) const {
    const std::uint64_t sets =
        std::min<std::uint64_t>(header_.length("num_side_sets"), header_.variables.size());
    for (std::uint64_t set = 1; set <= sets; ++set) {
      const std::vector<std::int64_t> elements = whole_numbers(fmt::format("elem_ss{}", set));
      const std::vector<std::int64_t> sides = whole_numbers(fmt::format("side_ss{}", set));
      if (elements.size() != sides.size()) fail("has a side set with more elements than sides");
      std::vector<Index> vertices;
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::vector<Index> side = vertices_of_side(elements[i], sides[i]);
        if (side.empty()) continue;
        labels.add(side, static_cast<std::uint32_t>(set));
        vertices.insert(vertices.end(), side.begin(), side.end());
      }
      file.sets.push_back(named_list("marker", name_of("ss_names", "ss_prop1", set), sides.size(),
                                     "sides", std::move(vertices)));
    }
  }

  /// Empty for an element that is no cell.
  std::vector<Index> vertices_of_side(std::int64_t element, std::int64_t side) const {
    if (element < 1 || static_cast<std::uint64_t>(element) > cells_in_file_) {
      fail(fmt::format("has element {} in a side set; there are {}", element, cells_in_file_));
    }
    const auto number = static_cast<std::uint64_t>(element - 1);
    const auto at = std::partition_point(
        blocks_.begin(), blocks_.end(),
        [number](const Block& block) { return number >= block.first_element + block.elements; });
    if (at->type.corners == 0) return {};
    const std::size_t cell = at->first_cell + (number - at->first_element);
    std::vector<Index> vertices =
        side_vertices(at->type.kind, cells_.vertices(cell), at->type.is_shell,
                      static_cast<std::uint64_t>(side) - 1);
    if (vertices.empty()) {
      fail(fmt::format("has side {} of element {} in a side set, which has fewer", side, element));
    }
    return vertices;
  }

  MeshFile take_file() {
    MeshFile file;
    if (const auto v = torn_vertex(followers_, cells_, points_.size())) {
      input_->fail(torn_message(fmt::format("node {}", *v + 1), "element"));
    }
    add_node_sets(file);
    SideLabels labels;
    add_side_sets(file, labels);
    const std::vector<Index> rims = labels.rims();
    held_.insert(held_.end(), rims.begin(), rims.end());
    file.held = {std::move(held_), "at the rims of side sets, or in elements without a surface"};
    if (cells_.empty()) {
      file.notes.push_back("The file has nodes but no elements that make a surface or a volume.");
    }
    if (header_.steps > 0) {
      file.notes.push_back("Results of time steps are kept as they are.");
    }
    numbers_.vertex = "node";
    numbers_.cell = "element";
    numbers_.first_vertex = numbers_.first_cell = 1;
    file.group_names = std::move(names_);
    file.followers = std::move(followers_);
    file.mesh = Mesh(std::move(points_), std::move(cells_));
    file.patch = std::make_unique<ExodusPatch>(input_, arrays_, std::move(numbers_));
    return file;
  }

  struct Block {
    std::uint64_t first_element;
    std::uint64_t elements;
    std::size_t first_cell;
    ElementType type;
  };

  std::shared_ptr<const InputFile> input_;
  NetcdfHeader header_;
  CoordinateArrays arrays_;
  std::vector<Vec3> points_;
  Cells cells_;
  Followers followers_;
  std::vector<Block> blocks_;
  std::uint64_t cells_in_file_ = 0;
  FileNumbers numbers_;
  std::vector<std::string> names_{""};
  std::vector<Index> held_;
};

}  // namespace

MeshFile read_exodus(std::shared_ptr<const InputFile> input) {
  return Reader(std::move(input)).read();
}

}  // namespace evenmesh
