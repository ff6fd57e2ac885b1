// SPDX-License-Identifier: MIT
#include "evenmesh/plot/convergence.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/plot/xml.h"

namespace evenmesh {
namespace {

using testing::Element;
using testing::named;
using testing::parse_xml;
using testing::texts;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

std::vector<std::vector<double>> numbers(const std::vector<Element>& polylines) {
  std::vector<std::vector<double>> result;
  for (const Element& line : polylines) {
    std::string points = line["points"];
    std::replace(points.begin(), points.end(), ',', ' ');
    std::istringstream in(points);
    result.emplace_back(std::istream_iterator<double>(in), std::istream_iterator<double>());
  }
  return result;
}

void expect_sound(const std::string& svg) {
  parse_xml(svg);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(ConvergencePlot, PutsDecadesAtEqualDistances) {
  const std::vector<Curve> curves = {{"f", {1.0, 0.1, 0.01, 0.001}}};
  const auto lines = numbers(named(parse_xml(convergence_plot(curves)), "polyline"));
  ASSERT_EQ(lines.size(), 1u);
  const std::vector<double>& p = lines[0];
  ASSERT_EQ(p.size(), 8u);
  for (std::size_t i = 2; i < 8; i += 2) {
    EXPECT_NEAR(p[i] - p[i - 2], p[2] - p[0], 0.011);
    EXPECT_NEAR(p[i + 1] - p[i - 1], p[3] - p[1], 0.011);
  }
  EXPECT_GT(p[3], p[1]);  // less is lower
}

TEST(ConvergencePlot, LeavesGapsWhereALogarithmHasNoValue) {
  const std::vector<Curve> curves = {{"f", {1.0, 0.5, 0.0, 0.2, 0.1, -1.0, kNaN, 0.05}}};
  const std::string svg = convergence_plot(curves);
  expect_sound(svg);
  EXPECT_EQ(named(parse_xml(svg), "polyline").size(), 2u);
  // Five values and the sample in the legend; the lone one at the end is marked once more.
  EXPECT_EQ(named(parse_xml(svg), "circle").size(), 7u);
}

TEST(ConvergencePlot, DrawsZerosOnALinearAxis) {
  const std::vector<Curve> curves = {{"f", {1.0, 0.0, -0.5}}};
  const auto lines =
      numbers(named(parse_xml(convergence_plot(curves, {.scale = Scale::linear})), "polyline"));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), 6u);
}

TEST(ConvergencePlot, TellsCurvesApartWithoutColour) {
  std::vector<Curve> curves;
  for (int i = 0; i < 7; ++i) curves.push_back({std::to_string(i), {1.0 + i, 0.5}});
  const std::vector<Element> lines = named(parse_xml(convergence_plot(curves)), "polyline");
  ASSERT_EQ(lines.size(), 7u);
  std::set<std::string> colours;
  for (const Element& line : lines) colours.insert(line["stroke"]);
  EXPECT_EQ(colours.size(), 7u);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    EXPECT_NE(lines[i]["stroke-dasharray"], lines[i + 1]["stroke-dasharray"]) << i;
  }
}

TEST(ConvergencePlot, EscapesNames) {
  const std::vector<Curve> curves = {{"<script>&\"'\x01\xff", {1.0, 0.5}}};
  const std::string svg =
      convergence_plot(curves, {.title = "<a>", .y_title = "a & b", .marks = {{1.0, "<!--"}}});
  expect_sound(svg);
  const std::vector<std::string> all = texts(svg);
  EXPECT_TRUE(contains(all, "<script>&\"'\uFFFD\uFFFD"));
  EXPECT_TRUE(contains(all, "<a>"));
  EXPECT_TRUE(contains(all, "a & b"));
  EXPECT_TRUE(contains(all, "<!--"));
}

TEST(ConvergencePlot, PutsAMarkWhereTheIterationIs) {
  const std::vector<Curve> curves = {{"f", {1.0, 0.5, 0.25, 0.2, 0.1}}};
  const std::vector<Element> all =
      parse_xml(convergence_plot(curves, {.marks = {{3.0, "paper: 3"}}}));
  const auto lines = numbers(named(all, "polyline"));
  const std::vector<Element> straight = named(all, "line");
  const auto mark = std::find_if(straight.begin(), straight.end(), [](const Element& line) {
    return line["stroke-dasharray"] == "5 3";
  });
  ASSERT_NE(mark, straight.end());
  EXPECT_NEAR(mark->number("x1"), lines[0][6], 0.011);
}

TEST(ConvergencePlot, MakesRoomForMarksBeyondTheCurves) {
  const std::vector<Curve> curves = {{"f", {1.0, 0.5}}};
  const std::string svg = convergence_plot(curves, {.marks = {{40.0, "paper"}, {kNaN, "none"}}});
  expect_sound(svg);
  EXPECT_TRUE(contains(texts(svg), "40"));
  EXPECT_FALSE(contains(texts(svg), "none"));
}

TEST(ConvergencePlot, KeepsLabelsOfMarksApart) {
  const std::vector<Curve> curves = {{"f", {1.0, 0.5, 0.1, 0.1}}};
  const std::string svg = convergence_plot(
      curves, {.marks = {{2.0, "one label"}, {2.0, "another label"}, {3.0, "the last"}}});
  std::map<std::string, double> rows;
  for (const Element& text : named(parse_xml(svg), "text")) rows[text.text] = text.number("y");
  EXPECT_NE(rows.at("one label"), rows.at("another label"));
}

TEST(ConvergencePlot, OfNothingSaysSo) {
  expect_sound(convergence_plot(std::span<const Curve>()));
  EXPECT_TRUE(contains(texts(convergence_plot(std::span<const Curve>())), "no iterations"));
  const std::vector<Curve> zeros = {{"f", {0.0, 0.0, 0.0}}};
  expect_sound(convergence_plot(zeros));
  EXPECT_TRUE(contains(texts(convergence_plot(zeros)), "no values above zero"));
}

TEST(ConvergencePlot, OfOneIterationShowsAPoint) {
  const std::vector<Curve> curves = {{"f", {3.0}}};
  const std::string svg = convergence_plot(curves);
  expect_sound(svg);
  EXPECT_TRUE(named(parse_xml(svg), "polyline").empty());
  EXPECT_GE(named(parse_xml(svg), "circle").size(), 2u);
}

TEST(ConvergencePlot, OfExtremeValuesStaysSound) {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const std::vector<Curve> curves = {{"f", {most, least, std::numeric_limits<double>::infinity()}},
                                     {"g", {-most, most}}};
  expect_sound(convergence_plot(curves));
  expect_sound(convergence_plot(curves, {.scale = Scale::linear}));
}

TEST(AboveLeast, SubtractsTheLeastFiniteValue) {
  const std::vector<double> values = {5.0, kNaN, 2.0, 3.0};
  const Curve curve = above_least("f", values);
  EXPECT_EQ(curve.y[0], 3.0);
  EXPECT_TRUE(std::isnan(curve.y[1]));
  EXPECT_EQ(curve.y[2], 0.0);
  EXPECT_EQ(curve.y[3], 1.0);
}

// Iterates with cost, gradient, inverted cells and the number of the function.
Report report_of(std::initializer_list<Iteration> history) {
  Report report;
  report.history = history;
  return report;
}

TEST(ReportPlot, OfAnEmptyHistoryAndOfTheInputAlone) {
  expect_sound(convergence_plot(Report{}));
  expect_sound(convergence_plot(report_of({{.cost = 0.0, .gradient = 0.0}})));
  expect_sound(convergence_plot(report_of({{.cost = kNaN, .gradient = kNaN}})));
}

TEST(ReportPlot, ComparesCostsOnlyWithinAFunction) {
  // Costs fall by nine tenths of what is left in each step of either stage.
  const Report report = report_of({{.cost = 110, .gradient = 1, .function = 0},
                                   {.cost = 20, .gradient = 0.5, .function = 0},
                                   {.cost = 10, .gradient = 0.1, .function = 0},
                                   {.cost = 1010, .gradient = 0.2, .function = 1},
                                   {.cost = 110, .gradient = 0.1, .function = 1},
                                   {.cost = 10, .gradient = 0.05, .function = 1}});
  const auto lines = numbers(named(parse_xml(convergence_plot(report)), "polyline"));
  ASSERT_EQ(lines.size(), 4u);  // two pieces of either curve
  EXPECT_EQ(lines[0].size(), 6u);
  EXPECT_EQ(lines[2].size(), 4u);  // the least is a gap
  EXPECT_DOUBLE_EQ(lines[2][1], lines[3][1]);
  EXPECT_DOUBLE_EQ(lines[2][3], lines[3][3]);
}

TEST(ReportPlot, CountsInvertedCellsIfThereEverWereAny) {
  const Report valid = report_of({{.cost = 2, .gradient = 1}, {.cost = 1, .gradient = 0.5}});
  Report tangled = valid;
  tangled.history[0].inverted = 7;
  EXPECT_FALSE(contains(texts(convergence_plot(valid)), "inverted cells"));
  EXPECT_TRUE(contains(texts(convergence_plot(tangled)), "inverted cells"));
}

}  // namespace
}  // namespace evenmesh
