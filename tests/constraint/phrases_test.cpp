// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/phrases.h"

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

template <typename Parse>
std::string message_of(const Parse& parse) {
  try {
    parse();
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "";
}

TEST(SlidePhrase, SplitsAtTheLastOn) {
  const SlidePhrase phrase = parse_slide("  group:put on it on circle ");
  EXPECT_EQ(phrase.selector, "group:put on it");
  EXPECT_EQ(phrase.on, SlideOn::circle);
  EXPECT_TRUE(phrase.numbers.empty());
}

TEST(SlidePhrase, KnowsEveryFigureByItsName) {
  for (const SlideOn on :
       {SlideOn::line, SlideOn::plane, SlideOn::circle, SlideOn::cylinder, SlideOn::sphere,
        SlideOn::features, SlideOn::boundary, SlideOn::surface}) {
    EXPECT_EQ(parse_slide("all on " + std::string(name(on))).on, on);
  }
}

TEST(SlidePhrase, TakesNumbersInTheOrderOfTheForm) {
  EXPECT_EQ(parse_slide("all on circle:1, -2,+3, 0,0,1, 0.5").numbers,
            (std::vector<double>{1, -2, 3, 0, 0, 1, 0.5}));
  EXPECT_EQ(parse_slide("all on sphere:0,0,0,2").numbers.size(), 4u);
  EXPECT_EQ(parse_slide("all on plane:y=-1.5").numbers, (std::vector<double>{0, -1.5, 0, 0, 1, 0}));
  EXPECT_EQ(parse_slide("all on plane:0,0,0,0,0,2").numbers,
            (std::vector<double>{0, 0, 0, 0, 0, 1}));
}

TEST(SlidePhrase, TakesAFileForASurfaceOnly) {
  EXPECT_EQ(parse_slide("all on surface=a b/scan.stl").file, "a b/scan.stl");
  EXPECT_NE(message_of([] { parse_slide("all on circle=scan.stl"); }).find("circle:cx"),
            std::string::npos);
}

TEST(SlidePhrase, SaysWhatIsWrong) {
  const auto expect = [](const std::string& text, const std::string& part) {
    const std::string message = message_of([&] { parse_slide(text); });
    EXPECT_NE(message.find(part), std::string::npos) << text << ": " << message;
  };
  expect("boundary", "'on' is missing");
  expect("boundary on", "'on' is missing");
  expect("boundary on circel", "did you mean 'circle'?");
  expect("boundary on torus", "known are line plane circle cylinder sphere");
  expect("all on circle:1,2", "write circle:cx,cy,cz,nx,ny,nz,r");
  expect("all on circle:0,0,0,0,0,0,1", "direction is zero");
  expect("all on sphere:0,0,0,0", "radius must be positive");
  expect("all on line:0,0,0,nan,0,0", "write line");
  expect("all on features:1", "write features");
}

TEST(PlanePhrase, IsAnAxisOrSixNumbers) {
  const Plane x = parse_plane("x=2");
  EXPECT_EQ(x.point, Vec3(2, 0, 0));
  EXPECT_EQ(x.normal, Vec3(1, 0, 0));
  EXPECT_EQ(parse_plane(" 1,2,3, 0,0,-4").normal, Vec3(0, 0, -1));
  for (const char* bad :
       {"", "x", "x=", "x=a", "w=1", "1,2,3", "0,0,0,0,0,0", "x=inf", "group:x=1"}) {
    EXPECT_THROW(parse_plane(bad), InvalidOption) << bad;
    EXPECT_FALSE(try_plane(bad)) << bad;
  }
}

TEST(LengthPhrase, HasTheUnitThatIsAllowed) {
  using Unit = Length::Unit;
  EXPECT_EQ(parse_length("0.1", "", Unit::of_edges).unit, Unit::absolute);
  EXPECT_EQ(parse_length("0.2h", "", Unit::of_edges).unit, Unit::of_edges);
  EXPECT_DOUBLE_EQ(parse_length("0.5%", "", Unit::of_diagonal).value, 0.005);
  EXPECT_DOUBLE_EQ(parse_length(" 2 m", "", Unit::of_mean_size).value, 2.0);
  for (const char* bad : {"", "0", "0h", "-1", "nan", "inf", "h", "0.2%", "0.2m", "1x"}) {
    EXPECT_THROW(parse_length(bad, "--max-move", Unit::of_edges), InvalidOption) << bad;
  }
}

TEST(LimitPhrase, HasASelectorAndADistance) {
  const LimitPhrase phrase = parse_limit("boundary + corners max-move 0.2h");
  EXPECT_EQ(phrase.selector, "boundary + corners");
  EXPECT_DOUBLE_EQ(phrase.distance.value, 0.2);
  EXPECT_THROW(parse_limit("boundary 0.2h"), InvalidOption);
  EXPECT_THROW(parse_limit("boundary max-move"), InvalidOption);
}

TEST(PeriodicPhrase, SplitsBetweenTheSidesAndNotWithinThem) {
  const auto expect = [](const std::string& text, const std::string& a, const std::string& b) {
    const PeriodicPhrase phrase = parse_periodic(text);
    EXPECT_EQ(phrase.first, a) << text;
    EXPECT_EQ(phrase.second, b) << text;
  };
  expect("x=0 x=1", "x=0", "x=1");
  expect("  x=0    x=1 ", "x=0", "x=1");
  expect("group:a + group:b group:c", "group:a + group:b", "group:c");
  expect("box: 0, 0,0,1,1,1 x=1", "box: 0, 0,0,1,1,1", "x=1");
  for (const char* bad : {"", "x=0", "x=0 +", "a b c"}) {
    EXPECT_THROW(parse_periodic(bad), InvalidOption) << bad;
  }
}

TEST(KeepPhrase, IsOfAllOrOfAGroup) {
  EXPECT_EQ(parse_keep("area").what, KeepPhrase::What::area);
  EXPECT_EQ(parse_keep("volume").what, KeepPhrase::What::volume);
  EXPECT_EQ(parse_keep("area of left side").group, "left side");
  EXPECT_EQ(parse_keep("area of group:left").group, "left");
  EXPECT_EQ(parse_keep("area of 'left side'").group, "left side");
  EXPECT_EQ(parse_keep("volume of group:\"left\"").group, "left");
  EXPECT_EQ(parse_keep("area of 'left").group, "'left");
  for (const char* bad : {"", "length", "area left", "area of", "areas", "area of ''"}) {
    EXPECT_THROW(parse_keep(bad), InvalidOption) << bad;
  }
}

TEST(PrescribePhrase, HasFormulasOrAFile) {
  const PrescribePhrase formulas = parse_prescribe("boundary = 0, max(x, y), z == 0 ? 1 : 2");
  EXPECT_EQ(formulas.selector, "boundary");
  EXPECT_EQ(formulas.formulas, "0, max(x, y), z == 0 ? 1 : 2");
  const PrescribePhrase table = parse_prescribe("boundary = moves.csv");
  EXPECT_EQ(table.file, "moves.csv");
  const PrescribePhrase mesh = parse_prescribe("moved.obj");
  EXPECT_EQ(mesh.selector, "");
  EXPECT_EQ(mesh.file, "moved.obj");
  for (const char* bad : {"", "boundary", "boundary = 1,2", "= 1,2,3", "1,2,3", "boundary = 0.5"}) {
    EXPECT_THROW(parse_prescribe(bad), InvalidOption) << bad;
  }
}

}  // namespace
}  // namespace evenmesh
