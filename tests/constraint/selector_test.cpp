// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/selector.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

/// The cube's surface with 2 x 2 quads per face: 8 corners, 12 more on edges, 6 in face centres.
class Selector : public testing::Test {
 protected:
  std::vector<char> select(std::string_view text, Index first_id = 1) const {
    return select_vertices(text, mesh_, topology_, {.first_id = first_id});
  }
  std::ptrdiff_t count(std::string_view text, Index first_id = 1) const {
    const auto flags = select(text, first_id);
    EXPECT_EQ(flags.size(), mesh_.point_count());
    return std::count(flags.begin(), flags.end(), char{1});
  }
  /// What the message says, or "" if nothing is thrown.
  std::string complaint(std::string_view text, Index first_id = 1) const {
    try {
      select(text, first_id);
    } catch (const InvalidOption& error) {
      return error.what();
    }
    return "";
  }

  Mesh mesh_ = shapes::cube_surface(2);
  Topology topology_ = find_topology(mesh_, find_orientation(mesh_));
};

TEST_F(Selector, KnowsEveryWord) {
  EXPECT_EQ(count("all"), 26);
  EXPECT_EQ(count("none"), 0);
  EXPECT_EQ(count("boundary"), 0);
  EXPECT_EQ(count("features"), 20);
  EXPECT_EQ(count("corners"), 8);
  EXPECT_EQ(count("interface"), 0);
  EXPECT_EQ(count("non_manifold"), 0);
  EXPECT_EQ(select("features"), topology_.features);
}

TEST_F(Selector, FeaturesIncludeNonManifoldEdges) {
  const Mesh fan = shapes::fan_of_three();
  const Topology topology = find_topology(fan, find_orientation(fan));
  EXPECT_EQ(select_vertices("features", fan, topology), (std::vector<char>{1, 1, 0, 0, 0}));
  EXPECT_EQ(select_vertices("non_manifold", fan, topology), (std::vector<char>{1, 1, 0, 0, 0}));
  EXPECT_EQ(select_vertices("boundary", fan, topology), (std::vector<char>{1, 1, 1, 1, 1}));
}

TEST_F(Selector, ReadsJointsFromLeftToRight) {
  EXPECT_EQ(count("features - corners"), 12);
  EXPECT_EQ(count("all-features"), 6);
  EXPECT_EQ(count("all - features + corners"), 14);
  EXPECT_EQ(count("all + corners & features"), 20);  // (all + corners) & features
  EXPECT_EQ(count("corners & none + corners"), 8);
  EXPECT_EQ(count("  all\t-\nfeatures  "), 6);
}

TEST_F(Selector, TakesIdsFromTheFirstOfTheFile) {
  EXPECT_EQ(select("id:1")[0], 1);
  EXPECT_EQ(select("id:0", 0)[0], 1);
  EXPECT_EQ(select("id:26")[25], 1);
  EXPECT_EQ(count("id:1,5-9"), 6);
  EXPECT_EQ(count("id:5-9,7-11,9,9"), 7);
  EXPECT_EQ(count("id:1, 5-9 , 12"), 7);
  EXPECT_EQ(count("id:1-26-id:2"), 25);
  EXPECT_EQ(count("id:3-all"), 0);
  EXPECT_EQ(count("id:3 +id:4"), 2);
}

TEST_F(Selector, TakesNumbersWithSignsAndExponentsInABox) {
  EXPECT_EQ(count("box:0,0,0,1,1,1"), 26);  // faces included
  EXPECT_EQ(count("box:-1e-5,-.5,+0,0,1e+1,1"), 9);
  EXPECT_EQ(count("box:0,0,0,1,1,0-corners"), 5);
  EXPECT_EQ(count("box: 0 , 0, 0, 1, 1, 0 + corners"), 13);
  EXPECT_EQ(count("box:-inf,-inf,.25,inf,inf,.75"), 8);
  EXPECT_EQ(count("box:5,5,5,6,6,6"), 0);
}

TEST_F(Selector, SaysWhereItDoesNotUnderstandAndWhatIsKnown) {
  const std::string text = complaint("all - boundry");
  EXPECT_NE(text.find("character 7"), std::string::npos) << text;
  EXPECT_NE(text.find("'boundry'"), std::string::npos) << text;
  EXPECT_NE(text.find("did you mean 'boundary'?"), std::string::npos) << text;
  EXPECT_NE(text.find("non_manifold"), std::string::npos) << text;
  EXPECT_NE(complaint("Corner").find("'corners'?"), std::string::npos);
  EXPECT_NE(complaint("non-manifold").find("'non_manifold'?"), std::string::npos);
  EXPECT_NE(complaint("boundry-corners").find("'boundary'?"), std::string::npos);
  EXPECT_EQ(complaint("quux").find("did you mean"), std::string::npos);
}

TEST_F(Selector, RejectsWhatDoesNotParse) {
  for (const char* text : {"",
                           "   ",
                           "+",
                           "all +",
                           "+ all",
                           "all all",
                           "all + + all",
                           "all; none",
                           "id:",
                           "id:,",
                           "id:1,",
                           "id:a",
                           "id:1-",
                           "id:-1",
                           "id:1.5",
                           "id:1 2",
                           "id",
                           "box",
                           "box:",
                           "box:1,2,3",
                           "box:0,0,0,1,1",
                           "box:0,0,0,1,1,",
                           "box:0,0,0,1,1,1,1",
                           "box:a,0,0,1,1,1",
                           "box:nan,0,0,1,1,1",
                           "box:0,0,0,1,1,1e999",
                           "box:1,0,0,0,1,1",
                           "group:steel",
                           ":",
                           "all:",
                           "id:9-5",
                           "id:5-9-12",
                           "\xff\xfe",
                           "all\n\x01"}) {
    EXPECT_NE(complaint(text), "") << "'" << text << "'";
  }
}

TEST_F(Selector, NamesTheValidRangeForAnIdThatIsNotInTheMesh) {
  for (const char* text : {"id:0", "id:27", "id:20-27", "id:99999999999999999999999"}) {
    EXPECT_NE(complaint(text).find("1 to 26"), std::string::npos) << complaint(text);
  }
  EXPECT_NE(complaint("id:26", 0).find("0 to 25"), std::string::npos);
  const Mesh empty;
  EXPECT_THROW(select_vertices("id:1", empty, find_topology(empty, {})), InvalidOption);
  EXPECT_TRUE(select_vertices("all + boundary", empty, find_topology(empty, {})).empty());
}

TEST_F(Selector, KeepsMessagesShort) {
  const std::string text = complaint("all + " + std::string(100000, 'x') + "\x1b[31m");
  EXPECT_LT(text.size(), 500u);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(complaint("\xff\x1b[31m").find("'??[31m'"), std::string::npos);
}

TEST(SelectorOfALargeMesh, TakesAHundredThousandOverlappingRangesAtOnce) {
  const Mesh mesh = shapes::quad_grid(300);
  const Topology topology = find_topology(mesh, find_orientation(mesh));
  std::string text = "id:1-90601";
  for (int i = 0; i < 100000; ++i) text += ",1-90601";
  const auto flags = select_vertices(text, mesh, topology);
  EXPECT_EQ(std::count(flags.begin(), flags.end(), char{1}), 90601);
}

NamedSet named(std::string kind, std::string name, std::vector<Index> vertices) {
  return {.kind = std::move(kind), .name = std::move(name), .vertices = [vertices](const Cells&) {
            return vertices;
          }};
}

TEST_F(Selector, KnowsTheSetsOfAFile) {
  const std::vector<NamedSet> sets = {named("nset", "Part.bolt-holes", {0, 1, 1}),
                                      named("nset", "bolt", {5}),
                                      named("elset", "bolt", {6, 7, 8})};
  const auto select = [&](std::string_view text) {
    const auto flags = select_vertices(text, mesh_, topology_, {.sets = sets});
    return std::count(flags.begin(), flags.end(), char{1});
  };
  EXPECT_EQ(select("nset:bolt"), 1);
  EXPECT_EQ(select("elset:BOLT"), 3);
  EXPECT_EQ(select("nset:Bolt-Holes"), 2);  // the part need not be named, the longest name counts
  EXPECT_EQ(select("nset:part.bolt-holes + nset:bolt"), 3);
  EXPECT_EQ(select("nset:'bolt' - id:6"), 0);
  const auto complaint = [&](std::string_view text) {
    try {
      select(text);
    } catch (const InvalidOption& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaint("nset:bold").find("there is no nset 'bold' (did you mean 'bolt'?)"),
            std::string::npos)
      << complaint("nset:bold");
  EXPECT_NE(complaint("marker:wall").find("there is no marker 'wall': the file has none"),
            std::string::npos);
}

DataArray array_of(std::string name, bool on_cells, std::size_t size) {
  std::vector<double> values(size);
  for (std::size_t i = 0; i < size; ++i) values[i] = static_cast<double>(i);
  return {.name = std::move(name), .on_cells = on_cells, .values = [values] { return values; }};
}

TEST_F(Selector, ComparesTheArraysOfAFile) {
  std::vector<DataArray> arrays = {array_of("my bc", false, mesh_.point_count()),
                                   array_of("size", true, mesh_.cells().size()),
                                   array_of("size", false, mesh_.point_count())};
  arrays[0].values = [values = arrays[0].values()] {
    std::vector<double> changed = values;
    changed[3] = -1.5;
    changed[4] = std::nan("");
    return changed;
  };
  const auto select = [&](std::string_view text) {
    const auto flags = select_vertices(text, mesh_, topology_, {.arrays = arrays});
    return std::count(flags.begin(), flags.end(), char{1});
  };
  EXPECT_EQ(select("array:my bc==2"), 1);
  EXPECT_EQ(select("array:my bc != 2"), 25);  // what is no number equals none
  EXPECT_EQ(select("array:'my bc' < 2"), 3);
  EXPECT_EQ(select("array:my bc<=2"), 4);
  EXPECT_EQ(select("array:my bc>-2"), 25);
  EXPECT_EQ(select("array:my bc>=2.2e1"), 4);
  EXPECT_EQ(select("array:my bc==-1.5+id:1"), 2);
  EXPECT_EQ(select("array:cell.size==0"), 4);  // the vertices of one quad
  EXPECT_EQ(select("array:point.size==0-id:1"), 0);
  const auto complaint = [&](std::string_view text) {
    try {
      select(text);
    } catch (const InvalidOption& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto expect_complaint = [&](std::string_view text, std::string_view about) {
    EXPECT_NE(complaint(text).find(about), std::string::npos) << complaint(text);
  };
  expect_complaint("array:size==0", "say 'point.size' or 'cell.size'");
  expect_complaint("array:my bd==0", "(did you mean 'my bc'?)");
  expect_complaint("array:my bc=0", "a comparison is expected behind the array");
  expect_complaint("array:my bc", "a comparison is expected behind the array");
  expect_complaint("array:my bc==x", "a number is expected");
  expect_complaint("array:==1", "the name of an array is expected");
}

TEST_F(Selector, TakesTheNumbersOfTheFileWithTheirGaps) {
  std::vector<std::uint64_t> ids(mesh_.point_count());
  for (std::size_t v = 0; v < ids.size(); ++v) ids[v] = 10 * (ids.size() - v);
  const auto select = [&](std::string_view text) {
    return select_vertices(text, mesh_, topology_, {.ids = ids});
  };
  std::vector<char> wanted(ids.size(), 0);
  wanted[ids.size() - 1] = wanted[ids.size() - 2] = wanted[ids.size() - 3] = 1;
  EXPECT_EQ(select("id:10-30"), wanted);
  EXPECT_EQ(select("id:30,10-20,10"), wanted);
  EXPECT_THROW(select("id:15"), InvalidOption);
}

TEST_F(Selector, AMiddleOfAnEdgeStandsForItsCorners) {
  Followers followers;
  const std::vector<Index> leaders = {3, 4};
  followers.add(20, leaders);
  const auto flags = select_vertices("id:21", mesh_, topology_, {.followers = &followers});
  EXPECT_EQ(std::count(flags.begin(), flags.end(), char{1}), 3);
  EXPECT_TRUE(flags[3] && flags[4] && flags[20]);
}

}  // namespace
}  // namespace evenmesh
