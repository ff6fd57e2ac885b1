// SPDX-License-Identifier: MIT
#include "evenmesh/plot/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "evenmesh/mesh/orientation.h"
#include "evenmesh/plot/palette.h"
#include "tests/plot/xml.h"
#include "tests/support/shapes.h"

namespace evenmesh {
namespace {

using testing::Element;
using testing::named;
using testing::parse_xml;
using testing::texts;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

CellQuality with_shapes(std::vector<double> values, std::vector<char> inverted) {
  CellQuality quality;
  quality.values[static_cast<std::size_t>(Metric::shape)] = std::move(values);
  quality.inverted = std::move(inverted);
  return quality;
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

TEST(CountBins, MatchesCountsByHand) {
  const CellQuality quality =
      with_shapes({0.0, 0.02, 0.03, 0.5, 0.52, 1.0, kNaN, 0.0}, {1, 0, 0, 0, 0, 0, 0, 0});
  const QualityBins bins = count_bins(quality, Metric::shape, {0.0, 1.0}, 40);
  EXPECT_EQ(bins.inverted, 1u);
  EXPECT_EQ(bins.beyond, 0u);
  EXPECT_EQ(bins.total, 7u);
  EXPECT_EQ(bins.counts[0], 2u);
  EXPECT_EQ(bins.counts[1], 1u);
  EXPECT_EQ(bins.counts[20], 2u);
  EXPECT_EQ(bins.counts[39], 1u);
  EXPECT_EQ(std::accumulate(bins.counts.begin(), bins.counts.end(), std::size_t{0}), 6u);
}

TEST(CountBins, KeepsWhatIsBeyondTheRangeApart) {
  const CellQuality quality =
      with_shapes({0.5, 2.0, 1.0 + 1e-12, std::numeric_limits<double>::infinity()}, {0, 0, 0, 0});
  const QualityBins bins = count_bins(quality, Metric::shape, {0.0, 1.0}, 4);
  EXPECT_EQ(bins.beyond, 2u);
  EXPECT_EQ(bins.counts, (std::vector<std::size_t>{0, 0, 1, 1}));
}

TEST(QualityHistogram, HasBarsInProportion) {
  // Three cells in one bin, one in another: 75 % and 25 %.
  const CellQuality quality = with_shapes({0.1, 0.11, 0.12, 0.9}, {0, 0, 0, 0});
  const std::string svg = quality_histogram({{"before", quality}}, {.bins = 10});
  std::vector<double> heights;
  for (const Element& bar : named(parse_xml(svg), "rect")) {
    if (bar["fill"] == "#b9c6d1" && bar.number("x") > 60.0) heights.push_back(bar.number("height"));
  }
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_NEAR(heights[0] / heights[1], 3.0, 1e-3);
}

TEST(QualityHistogram, CountsInvertedCellsInARedBinToTheLeft) {
  const CellQuality before = with_shapes({0.0, 0.5}, {1, 0});
  const CellQuality after = with_shapes({0.4, 0.5}, {0, 0});
  const std::string svg = quality_histogram({{"before", before}, {"after", after}});
  const std::vector<Element> all = named(parse_xml(svg), "rect");
  const auto is_red = [](const Element& r) { return r["fill"] == kInvertedColour; };
  ASSERT_EQ(std::count_if(all.begin(), all.end(), is_red), 1);
  const Element red = *std::find_if(all.begin(), all.end(), is_red);
  for (const Element& bar : all) {
    if (bar["fill"] != "#b9c6d1" || bar.number("x") < 60.0) continue;
    EXPECT_LT(red.number("x") + red.number("width"), bar.number("x"));
    EXPECT_DOUBLE_EQ(red.number("height"), bar.number("height"));  // one of two cells, either
  }
  EXPECT_TRUE(contains(texts(svg), "inverted"));
}

TEST(QualityHistogram, SaysWorstAndMean) {
  const CellQuality before = with_shapes({0.25, 0.75}, {0, 0});
  const std::vector<std::string> all = texts(quality_histogram({{"before", before}}));
  EXPECT_TRUE(contains(all, "worst 0.250"));
  EXPECT_TRUE(contains(all, "mean 0.500"));
  EXPECT_FALSE(contains(all, "inverted"));
}

TEST(QualityHistogram, EscapesNames) {
  const CellQuality quality = with_shapes({0.5}, {0});
  const std::string svg = quality_histogram({{"<script>", quality}}, {.title = "a & \"b\"\x02"});
  EXPECT_TRUE(contains(texts(svg), "<script>"));
  EXPECT_TRUE(contains(texts(svg), "a & \"b\"\uFFFD"));
}

TEST(QualityHistogram, IsSoundForEveryMetricAndShape) {
  Workers workers;
  for (const shapes::Named& shape : shapes::zoo()) {
    const Orientation orientation = find_orientation(shape.mesh);
    const CellQuality quality =
        measure_cells(workers, shape.mesh, shape.mesh.points(), orientation);
    for (const Metric metric : kMetrics) {
      const std::string svg =
          quality_histogram({{"before", quality}, {"after", quality}}, {.metric = metric});
      EXPECT_FALSE(parse_xml(svg).empty());
      EXPECT_EQ(svg.find("nan"), std::string::npos) << shape.name;
    }
  }
}

TEST(QualityHistogram, OfNoCellsSaysSo) {
  const CellQuality none;
  EXPECT_TRUE(contains(texts(quality_histogram({{"before", none}})), "no cell has this measure"));
}

}  // namespace
}  // namespace evenmesh
