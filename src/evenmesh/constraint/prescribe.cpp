// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/prescribe.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"

namespace evenmesh {
namespace {

enum class Columns : std::uint8_t { positions, displacements };

constexpr std::string_view kFormats =
    "a line is id,x,y,z (new positions), or id,dx,dy,dz below such a header (displacements)";

[[noreturn]] void fail(std::size_t line, std::string_view what) {
  throw InvalidOption(fmt::format("line {}: {}", line, what));
}

/// The fields of a line that is not empty. Blanks around a comma or semicolon belong to it.
std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t length = std::min(line.find_first_of(",; \t"), line.size());
    result.push_back(line.substr(0, length));
    line = trimmed(line.substr(length));
    if (line.empty()) return result;
    if (line.front() == ',' || line.front() == ';') {
      line = trimmed(line.substr(1));
      if (line.empty()) {
        result.push_back(line);
        return result;
      }
    }
  }
}

/// A whole field as a number; from_chars takes no plus.
template <typename Number>
std::errc parse(std::string_view field, Number& value) {
  if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  return error == std::errc() && stop != end ? std::errc::invalid_argument : error;
}

class Reader {
 public:
  Reader(Points points, std::uint64_t first_id, std::span<const std::uint64_t> ids)
      : points_(points), first_id_(first_id), ids_(ids) {
    for (Index v = 0; v < ids.size(); ++v) vertex_of_.emplace(ids[v], v);
  }

  void read_line(std::string_view text) {
    ++line_;
    text = trimmed(text.substr(0, text.find('#')));
    if (text.empty()) return;
    const bool is_first = !std::exchange(has_begun_, true);
    const std::vector<std::string_view> columns = fields(text);
    if (is_first && is_letter(text.front())) {
      read_header(text, columns);
    } else {
      read_target(text, columns);
    }
  }

  /// By vertex, each once.
  std::vector<Target> take() {
    std::stable_sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return a.target.vertex < b.target.vertex;
    });
    std::vector<Target> result;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const Target& target = found_[i].target;
      if (result.empty() || result.back().vertex != target.vertex) {
        result.push_back(target);
      } else if (result.back().position != target.position) {
        fail(found_[i].line,
             fmt::format("vertex {} was sent to another place in line {}; keep one of the two",
                         id_of(target.vertex), found_[i - 1].line));
      }
    }
    return result;
  }

 private:
  struct Found {
    Target target;
    std::size_t line;
  };

  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

  void read_header(std::string_view text, std::span<const std::string_view> columns) {
    std::string names;
    for (const std::string_view column : columns) names += lower(column) + ",";
    if (names == "id,x,y,z,") return;
    if (names != "id,dx,dy,dz,") {
      fail(line_, fmt::format("the header '{}' is not known; {}", shown(text), kFormats));
    }
    columns_ = Columns::displacements;
  }

  void read_target(std::string_view text, std::span<const std::string_view> columns) {
    if (columns.size() != 4) {
      const std::string_view hint =
          columns.size() > 4 ? "; write decimals with a point, 0.5 and not 0,5" : "";
      fail(line_, fmt::format("'{}' has {} columns instead of 4{}; {}", shown(text), columns.size(),
                              hint, kFormats));
    }
    Target target{vertex(columns[0]), Vec3::Zero()};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      target.position[static_cast<Eigen::Index>(axis)] = coordinate(columns[axis + 1]);
    }
    if (columns_ == Columns::displacements) {
      target.position += points_[target.vertex];
      if (!target.position.allFinite()) fail(line_, "the new position is beyond all numbers");
    }
    found_.push_back({target, line_});
  }

  Index vertex(std::string_view field) const {
    std::uint64_t id = 0;
    const std::errc error = parse(field, id);
    if (error == std::errc::invalid_argument) {
      fail(line_, fmt::format("'{}' is no vertex number; {}", shown(field), kFormats));
    }
    if (!ids_.empty()) {
      const auto found = vertex_of_.find(id);
      if (error == std::errc() && found != vertex_of_.end()) return found->second;
      fail(line_, fmt::format("there is no vertex {} in this mesh", shown(field)));
    }
    if (error == std::errc() && id >= first_id_ && id - first_id_ < points_.size()) {
      return static_cast<Index>(id - first_id_);
    }
    if (points_.empty()) fail(line_, "the mesh has no vertices");
    fail(line_, fmt::format("there is no vertex {}: this mesh numbers its vertices {} to {}",
                            shown(field), first_id_, first_id_ + (points_.size() - 1)));
  }

  double coordinate(std::string_view field) const {
    double value = 0.0;
    const std::errc error = parse(field, value);
    if (error == std::errc() && std::isfinite(value)) return value;
    if (error == std::errc::invalid_argument) {
      fail(line_, fmt::format("'{}' is no number", shown(field)));
    }
    fail(line_, fmt::format("'{}' is no finite number that a double can hold", shown(field)));
  }

  std::uint64_t id_of(Index v) const { return ids_.empty() ? first_id_ + v : ids_[v]; }

  Points points_;
  std::uint64_t first_id_;
  std::span<const std::uint64_t> ids_;
  std::unordered_map<std::uint64_t, Index> vertex_of_;  // by id, where they are not counted
  std::size_t line_ = 0;
  bool has_begun_ = false;
  Columns columns_ = Columns::positions;
  std::vector<Found> found_;
};

}  // namespace

std::vector<Target> read_targets(std::string_view text, Points points, std::uint64_t first_id,
                                 std::span<const std::uint64_t> ids) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Reader reader(points, first_id, ids);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.read_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.take();
}

std::vector<Target> targets_from(const Mesh& mesh, const Mesh& moved, std::span<const char> mask) {
  if (mesh.point_count() != moved.point_count()) {
    throw InvalidOption(fmt::format(
        "the mesh has {} vertices and the one that says where they go has {}; both must have the "
        "same, in the same order",
        mesh.point_count(), moved.point_count()));
  }
  assert(mask.empty() || mask.size() == mesh.point_count());
  std::vector<Target> result;
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    const Vec3& position = moved.points()[v];
    const bool chosen = mask.empty() ? position != mesh.points()[v] : mask[v] != 0;
    if (chosen) result.push_back({static_cast<Index>(v), position});
  }
  return result;
}

}  // namespace evenmesh
