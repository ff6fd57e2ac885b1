// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "evenmesh/base/vec3.h"

namespace evenmesh::testing {

/// How a Gmsh file writes numbers.
enum class MshNumbers { text, little_endian, big_endian };

struct MshNode {
  std::uint64_t tag;
  Vec3 position;
};
struct MshElement {
  int type;
  int tag;
  int physical;  // 0: none
  int entity;
  std::vector<std::uint64_t> nodes;
};
struct MshModel {
  std::vector<MshNode> nodes;
  std::vector<MshElement> elements;
  std::string names;  // what stands in $PhysicalNames, if anything
};

/// Writes Gmsh files of every version, and knows nothing of the reader.
class MshWriter {
 public:
  MshWriter(int version, MshNumbers numbers) : version_(version), numbers_(numbers) {}

  std::string write(const MshModel& model) {
    text_ = fmt::format("$MeshFormat\n{}.{} {} 8\n", version_ / 10, version_ % 10,
                        numbers_ == MshNumbers::text ? 0 : 1);
    if (numbers_ != MshNumbers::text) {
      number(1, 4);
      text_ += "\n";
    }
    text_ += "$EndMeshFormat\n";
    if (!model.names.empty()) text_ += "$PhysicalNames\n" + model.names + "$EndPhysicalNames\n";
    if (version_ < 40) {
      write_version_2(model);
    } else {
      write_version_4(model);
    }
    return text_;
  }

 private:
  void bytes(std::uint64_t bits, int size) {
    std::string little;
    for (int i = 0; i < size; ++i) little += static_cast<char>(bits >> (8 * i));
    if (numbers_ == MshNumbers::big_endian) std::reverse(little.begin(), little.end());
    text_ += little;
  }
  void number(std::uint64_t value, int size) {
    if (numbers_ == MshNumbers::text) {
      text_ += fmt::format("{} ", value);
    } else {
      bytes(value, size);
    }
  }
  void real(double value) {
    if (numbers_ == MshNumbers::text) {
      text_ += fmt::format("{} ", value);
    } else {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      bytes(bits, 8);
    }
  }
  void position(const Vec3& at) {
    for (int k = 0; k < 3; ++k) real(at[k]);
    end_line();
  }
  void end_line() {
    if (numbers_ == MshNumbers::text) text_ += "\n";
  }
  void end_section(const char* name) {
    if (numbers_ != MshNumbers::text) text_ += "\n";
    text_ += fmt::format("$End{}\n", name);
  }

  void write_version_2(const MshModel& model) {
    text_ += fmt::format("$Nodes\n{}\n", model.nodes.size());
    for (const MshNode& node : model.nodes) {
      number(node.tag, 4);
      position(node.position);
    }
    end_section("Nodes");
    text_ += fmt::format("$Elements\n{}\n", model.elements.size());
    for (const MshElement& element : model.elements) {
      const auto as_number = [](int value) { return static_cast<std::uint64_t>(value); };
      if (numbers_ == MshNumbers::text) {
        number(as_number(element.tag), 4);
        number(as_number(element.type), 4);
      } else {
        number(as_number(element.type), 4);
        number(1, 4);
      }
      number(2, 4);
      if (numbers_ != MshNumbers::text) number(as_number(element.tag), 4);
      number(as_number(element.physical), 4);
      number(as_number(element.entity), 4);
      for (const std::uint64_t node : element.nodes) number(node, 4);
      end_line();
    }
    end_section("Elements");
  }

  static int dimension(int type) { return type == 15 ? 0 : type == 1 ? 1 : type < 4 ? 2 : 3; }

  void write_entity(const MshElement& element) {
    const bool point = dimension(element.type) == 0;
    number(static_cast<std::uint64_t>(element.entity), 4);
    for (int i = 0; i < (version_ == 41 && point ? 3 : 6); ++i) real(0.5);
    number(element.physical != 0 ? 1 : 0, 8);
    if (element.physical != 0) number(static_cast<std::uint64_t>(element.physical), 4);
    if (!point) number(1, 8);
    if (!point) number(3, 4);
    end_line();
  }

  void block_of(int dimension, int entity) {
    number(static_cast<std::uint64_t>(version_ == 41 ? dimension : entity), 4);
    number(static_cast<std::uint64_t>(version_ == 41 ? entity : dimension), 4);
  }

  void write_version_4(const MshModel& model) {
    const int tag_size = version_ == 41 ? 8 : 4;
    text_ += "$Entities\n";
    for (int d = 0; d < 4; ++d) {
      number(static_cast<std::uint64_t>(
                 std::count_if(model.elements.begin(), model.elements.end(),
                               [&](const MshElement& e) { return dimension(e.type) == d; })),
             8);
    }
    end_line();
    for (int d = 0; d < 4; ++d) {
      for (const MshElement& element : model.elements) {
        if (dimension(element.type) == d) write_entity(element);
      }
    }
    end_section("Entities");

    // Two blocks: the first node alone, then the others.
    text_ += "$Nodes\n";
    number(2, 8);
    number(model.nodes.size(), 8);
    if (version_ == 41) number(1, 8), number(99, 8);
    end_line();
    for (const auto& [first, last] :
         {std::pair<std::size_t, std::size_t>{0, 1}, {1, model.nodes.size()}}) {
      block_of(2, 1);
      number(0, 4);
      number(last - first, 8);
      end_line();
      for (std::size_t i = first; i < last; ++i) {
        number(model.nodes[i].tag, tag_size);
        if (version_ == 40) position(model.nodes[i].position);
        if (version_ == 41) end_line();
      }
      for (std::size_t i = first; version_ == 41 && i < last; ++i)
        position(model.nodes[i].position);
    }
    end_section("Nodes");

    text_ += "$Elements\n";
    number(model.elements.size(), 8);
    number(model.elements.size(), 8);
    if (version_ == 41) number(1, 8), number(99, 8);
    end_line();
    for (const MshElement& element : model.elements) {
      block_of(dimension(element.type), element.entity);
      number(static_cast<std::uint64_t>(element.type), 4);
      number(1, 8);
      end_line();
      number(static_cast<std::uint64_t>(element.tag), tag_size);
      for (const std::uint64_t node : element.nodes) number(node, tag_size);
      end_line();
    }
    end_section("Elements");
  }

  int version_;
  MshNumbers numbers_;
  std::string text_;
};

}  // namespace evenmesh::testing
