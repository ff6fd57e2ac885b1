// SPDX-License-Identifier: MIT
#include "evenmesh/io/placed_patch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

static_assert(std::endian::native == std::endian::little, "swapping is written for this order");

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

float nearest_float(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));
}

NumberText text_of(double value, const CoordinateCode& code) {
  if (code.widest > 0) return NumberText::fitted(value, code.widest);
  return code.single ? NumberText(nearest_float(value)) : NumberText(value);
}

/// The next word that may be a number, over commas, line ends and comments.
const char* next_number(const char* p, const char* end) {
  while (p != end && (is_blank(*p) || is_eol(*p) || *p == ',' || *p == '#')) {
    if (*p == '#') {
      while (p != end && !is_eol(*p)) ++p;
    } else {
      ++p;
    }
  }
  return p;
}

double bytes_at(const char* p, const CoordinateCode& code) {
  if (code.kind == CoordinateCode::Kind::float32) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, p, sizeof(bits));
    return std::bit_cast<float>(code.swap ? __builtin_bswap32(bits) : bits);
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, p, sizeof(bits));
  return std::bit_cast<double>(code.swap ? __builtin_bswap64(bits) : bits);
}

void patch_bytes(const char* p, double value, const CoordinateCode& code, BytePatcher& out) {
  char bytes[sizeof(double)];
  if (code.kind == CoordinateCode::Kind::float32) {
    const auto bits = std::bit_cast<std::uint32_t>(nearest_float(value));
    const std::uint32_t ordered = code.swap ? __builtin_bswap32(bits) : bits;
    std::memcpy(bytes, &ordered, sizeof(ordered));
  } else {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t ordered = code.swap ? __builtin_bswap64(bits) : bits;
    std::memcpy(bytes, &ordered, sizeof(ordered));
  }
  out.replace(p, p + code.bytes_each(), {bytes, code.bytes_each()});
}

}  // namespace

bool CoordinateCode::is_exact() const {
  return dimension == 3 && kind != Kind::float32 && !single && widest == 0;
}

double CoordinateCode::representable(double coordinate) const {
  if (kind == Kind::float64) return coordinate;
  if (kind == Kind::float32) return nearest_float(coordinate);
  if (!single && widest == 0) return coordinate;
  const NumberText written = text_of(coordinate, *this);
  const std::string_view text = written.view();
  double value = 0.0;
  scan_number(text.data(), text.data() + text.size(), value);
  return value;
}

void CoordinateCode::patch(const char* p, const char* end, const Vec3& position,
                           BytePatcher& out) const {
  for (int k = 0; k < dimension; ++k) {
    if (kind != Kind::text) {
      if (!same_bits(bytes_at(p, *this), position[k])) patch_bytes(p, position[k], *this, out);
      p += bytes_each();
      continue;
    }
    p = next_number(p, end);
    double before = 0.0;
    const char* const stop = scan_value(p, end, before);
    if (stop == nullptr) return;  // the file was changed under our hands: check_unchanged() says so
    if (!same_bits(before, position[k])) out.replace(p, stop, text_of(position[k], *this).view());
    p = stop;
  }
}

Vec3 CoordinateCode::position_at(const char* p) const {
  Vec3 position = Vec3::Zero();
  for (int k = 0; k < dimension; ++k) position[k] = bytes_at(p + bytes_each() * k, *this);
  return position;
}

PlacedPatch::PlacedPatch(std::string_view format, std::shared_ptr<const InputFile> input,
                         CoordinateCode code, std::vector<std::uint64_t> places,
                         FileNumbers numbers)
    : format_(format),
      input_(std::move(input)),
      code_(code),
      places_(std::move(places)),
      numbers_(std::move(numbers)) {}

std::vector<Vec3> PlacedPatch::representable(Points points) const {
  std::vector<Vec3> result(points.begin(), points.end());
  if (code_.is_exact()) return result;
  for (Vec3& position : result) {
    for (int k = 0; k < 3; ++k) {
      position[k] = k < code_.dimension ? code_.representable(position[k]) : 0.0;
    }
  }
  return result;
}

void PlacedPatch::write(Points points, const std::function<void(std::string_view)>& sink) const {
  input_->check_unchanged();
  const std::string_view bytes = input_->bytes();
  BytePatcher out(bytes, sink);
  for (std::size_t v = 0; v < places_.size(); ++v) {
    code_.patch(bytes.data() + places_[v], bytes.data() + bytes.size(), points[v], out);
  }
  out.finish();
  input_->check_unchanged();
}

std::uint64_t PlacedPatch::cell_number(std::size_t cell) const {
  if (numbers_.cell_places.empty() || !numbers_.number_at_place) {
    return numbers_.cells.empty() ? numbers_.first_cell + cell : numbers_.cells[cell];
  }
  const std::string_view bytes = input_->bytes();
  std::int64_t read = 0;
  scan_whole(bytes.data() + numbers_.cell_places[cell], bytes.data() + bytes.size(), read);
  return static_cast<std::uint64_t>(read);
}

std::string PlacedPatch::cell_name(std::size_t cell) const {
  const std::uint64_t number = cell_number(cell);
  if (numbers_.cell_places.empty()) return fmt::format("{} {}", numbers_.cell, number);
  return fmt::format("{} {} (line {})", numbers_.cell, number,
                     input_->line_of(numbers_.cell_places[cell]));
}

std::string PlacedPatch::vertex_name(Index vertex) const {
  const std::uint64_t number =
      numbers_.vertices.empty() ? numbers_.first_vertex + vertex : numbers_.vertices[vertex];
  if (code_.kind != CoordinateCode::Kind::text) {
    return fmt::format("{} {}", numbers_.vertex, number);
  }
  return fmt::format("{} {} (line {})", numbers_.vertex, number, input_->line_of(places_[vertex]));
}

}  // namespace evenmesh
