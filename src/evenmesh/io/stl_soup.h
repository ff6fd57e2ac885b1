// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/io/input_file.h"
#include "evenmesh/io/mesh_file.h"
#include "evenmesh/io/weld.h"

namespace evenmesh {

/// Collects the facets of an STL, welds their corners and makes a mesh of them.
class StlSoup {
 public:
  /// @throws InvalidOption  the weld tolerance is negative or not finite
  explicit StlSoup(const ReadOptions& options);

  /// Appends a facet. @pre all finite
  void add(const std::array<Vec3, 3>& corners);
  std::size_t size() const { return corners_.size() / 3; }

  /// @param groups  per facet its group; empty: none has one
  Mesh take_mesh(const std::vector<std::uint32_t>& groups = {});

 private:
  double tolerance_;
  Welder welder_;
  std::vector<Index> corners_;
};

/// The unit normal of a triangle by the right-hand rule; zero where it has none.
Vec3 facet_normal(const Vec3& a, const Vec3& b, const Vec3& c);

/// What the patches of both kinds of STL have in common.
class StlPatch : public FilePatch {
 public:
  std::string vertex_name(Index vertex) const override;

 protected:
  StlPatch(std::shared_ptr<const InputFile> input, Mesh mesh)
      : input_(std::move(input)), mesh_(std::move(mesh)) {}

  const InputFile& input() const { return *input_; }
  const Mesh& mesh() const { return mesh_; }

  /// Compared as numbers: what moves from 0 to -0 stays where it is, and so keeps its text.
  bool moved(std::size_t facet, Points points) const;
  bool moved(Index vertex, int axis, Points points) const {
    return points[vertex][axis] != mesh_.points()[vertex][axis];
  }
  std::array<Vec3, 3> corners(std::size_t facet, Points points) const;

 private:
  std::shared_ptr<const InputFile> input_;
  Mesh mesh_;  // as read
};

}  // namespace evenmesh
