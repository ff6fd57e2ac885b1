// SPDX-License-Identifier: MIT
#include "evenmesh/io/stl_binary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/core.h>

#include "evenmesh/io/byte_patcher.h"
#include "evenmesh/io/stl_soup.h"

namespace evenmesh {
namespace {

static_assert(std::endian::native == std::endian::little, "STL is little-endian, as is this code");

/// The twelve numbers of a facet: its normal, then its three corners.
using Floats = std::array<float, 12>;

std::size_t facet_offset(std::size_t facet) { return kBinaryStlHeader + kBinaryStlFacet * facet; }

Floats floats_at(std::string_view bytes, std::size_t facet) {
  Floats floats;
  std::memcpy(floats.data(), bytes.data() + facet_offset(facet), sizeof(floats));
  return floats;
}

std::array<Vec3, 3> corners_of(const Floats& floats) {
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = Vec3(floats[3 * i + 3], floats[3 * i + 4], floats[3 * i + 5]);
  }
  return corners;
}

bool all_finite(const std::array<Vec3, 3>& corners) {
  return std::ranges::all_of(corners, [](const Vec3& corner) { return corner.allFinite(); });
}

std::uint32_t count_in(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

/// Facets that follow those counted: the bytes are a whole number of them, every coordinate is
/// finite, and none is all zero, which would be padding.
std::size_t uncounted_facets(std::string_view bytes, std::size_t count) {
  const std::size_t rest = bytes.size() - facet_offset(count);
  if (rest % kBinaryStlFacet != 0) return 0;
  const std::size_t found = rest / kBinaryStlFacet;
  for (std::size_t i = count; i < count + found; ++i) {
    const auto corners = corners_of(floats_at(bytes, i));
    const bool zero = std::ranges::all_of(corners, [](const Vec3& c) { return c.isZero(0.0); });
    if (zero || !all_finite(corners)) return 0;
  }
  return found;
}

[[noreturn]] void fail_count(const InputFile& input, std::uint32_t count, std::size_t fits) {
  if (facet_offset(__builtin_bswap32(count)) == input.bytes().size()) {
    input.fail("is a big-endian STL, but STL is little-endian; write it again that way");
  }
  input.fail(
      fmt::format("promises {} facets but has room for {}; it was cut off, or is no binary "
                  "STL. Export or copy it again",
                  count, fits));
}

/// The finite float nearest to x.
double nearest_float(double x) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<double>(static_cast<float>(std::clamp(x, -kLargest, kLargest)));
}

class BinaryStlPatch final : public StlPatch {
 public:
  BinaryStlPatch(std::shared_ptr<const InputFile> file, Mesh as_read)
      : StlPatch(std::move(file), std::move(as_read)) {}

  std::string_view format() const override { return "stl_binary"; }

  std::vector<Vec3> representable(Points points) const override {
    std::vector<Vec3> result(mesh().points().begin(), mesh().points().end());
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const double nearest = nearest_float(points[i][k]);
        if (nearest != result[i][k]) result[i][k] = nearest;
      }
    }
    return result;
  }

  void write(Points points, const std::function<void(std::string_view)>& sink) const override {
    input().check_unchanged();
    const std::vector<Vec3> wanted = representable(points);
    BytePatcher out(input().bytes(), sink);
    for (std::size_t i = 0; i < mesh().cells().size(); ++i) {
      if (moved(i, wanted)) patch_facet(i, wanted, out);
    }
    out.finish();
    input().check_unchanged();
  }

  std::string cell_name(std::size_t cell) const override {
    return fmt::format("facet {}", cell + 1);
  }

 private:
  void patch_facet(std::size_t facet, Points wanted, BytePatcher& out) const {
    Floats floats = floats_at(input().bytes(), facet);
    const auto vertices = mesh().cells().vertices(facet);
    const auto [a, b, c] = corners(facet, wanted);
    const Vec3 normal = facet_normal(a, b, c);
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      floats[k] = static_cast<float>(normal[axis]);
      for (std::size_t i = 0; i < 3; ++i) {
        if (!moved(vertices[i], axis, wanted)) continue;
        floats[3 * i + 3 + k] = static_cast<float>(wanted[vertices[i]][axis]);
      }
    }
    const char* const first = input().bytes().data() + facet_offset(facet);
    out.replace(first, first + sizeof(floats),
                {reinterpret_cast<const char*>(floats.data()), sizeof(floats)});
  }
};

}  // namespace

bool has_binary_stl_size(std::string_view bytes) {
  return bytes.size() >= kBinaryStlHeader && facet_offset(count_in(bytes)) == bytes.size();
}

MeshFile read_stl_binary(std::shared_ptr<const InputFile> input, const ReadOptions& options) {
  const std::string_view bytes = input->bytes();
  if (bytes.size() < kBinaryStlHeader) {
    input->fail(fmt::format("has {} bytes, but a binary STL begins with {} bytes of header",
                            bytes.size(), kBinaryStlHeader));
  }
  const std::uint32_t count = count_in(bytes);
  const std::size_t fits = (bytes.size() - kBinaryStlHeader) / kBinaryStlFacet;
  if (count > fits) fail_count(*input, count, fits);

  MeshFile file;
  const std::size_t uncounted = uncounted_facets(bytes, count);
  const std::size_t facets = count + uncounted;
  if (uncounted > 0) {
    file.notes.push_back(fmt::format(
        "The header promises {} facets, but {} more follow; all {} are read, and the count is left "
        "as it is.",
        count, uncounted, facets));
  } else if (facet_offset(facets) < bytes.size()) {
    file.notes.push_back(
        fmt::format("{} bytes behind the last facet are kept but mean nothing here.",
                    bytes.size() - facet_offset(facets)));
  }

  StlSoup soup(options);
  for (std::size_t i = 0; i < facets; ++i) {
    const auto corners = corners_of(floats_at(bytes, i));
    if (!all_finite(corners)) {
      input->fail(
          fmt::format("facet {} (byte {}) has a coordinate that is not a finite number; "
                      "repair the mesh or export it again",
                      i + 1, facet_offset(i)));
    }
    soup.add(corners);
  }
  if (facets == 0) file.notes.push_back("The file has no facets.");
  file.mesh = soup.take_mesh();
  file.group_names = {""};
  file.patch = std::make_unique<BinaryStlPatch>(std::move(input), file.mesh);
  return file;
}

}  // namespace evenmesh
