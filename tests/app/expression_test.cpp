// SPDX-License-Identifier: MIT
#include "apps/evenmesh/expression.h"

#include <cmath>
#include <locale>
#include <numbers>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

std::string complaint(const std::string& text, const Vec3& p = Vec3(1, 2, 3)) {
  try {
    Displacement displacement(text);
    displacement(p);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "";
}

void expect_says(const std::string& text, const std::string& part) {
  const std::string message = complaint(text);
  EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "'";
  EXPECT_EQ(message.find("displacement '" + text + "'"), 0u) << message;
}

TEST(Displacement, EvaluatesThreeFormulas) {
  const Displacement d("x + 0.5, -2 * y, z^2 / 3");
  EXPECT_EQ(d(Vec3(1, 2, 3)), Vec3(1.5, -4, 3));
  EXPECT_EQ(d(Vec3(0, 1, 6)), Vec3(0.5, -2, 12));
}

TEST(Displacement, KnowsFunctionsAndPi) {
  const Displacement d("sin(pi * x), atan2(y, x), sqrt(abs(z))");
  const Vec3 value = d(Vec3(0.5, -0.5, -9));
  EXPECT_DOUBLE_EQ(value.x(), 1.0);
  EXPECT_DOUBLE_EQ(value.y(), -std::numbers::pi / 4.0);
  EXPECT_DOUBLE_EQ(value.z(), 3.0);
}

TEST(Displacement, LeavesCommasInsideCallsAlone) {
  EXPECT_EQ(Displacement("min(x, y, z), max(x, min(y, z)), (x)")(Vec3(3, 1, 2)), Vec3(1, 3, 3));
}

TEST(Displacement, Compares) {
  const Displacement d("x > 0 ? 1 : 0, y <= 2 && y != 1, z == 3");
  EXPECT_EQ(d(Vec3(1, 2, 3)), Vec3(1, 1, 1));
  EXPECT_EQ(d(Vec3(-1, 1, 4)), Vec3(0, 0, 0));
}

TEST(Displacement, CanBeMoved) {
  Displacement first("x, y, z");
  Displacement second = std::move(first);
  EXPECT_EQ(second(Vec3(1, 2, 3)), Vec3(1, 2, 3));
}

TEST(Displacement, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint("0, 0, 0"), "");
  expect_says("", "three formulas");
  expect_says("  ", "three formulas");
  expect_says("x", "1 given");
  expect_says("x, y", "2 given");
  expect_says("x, y, z, x", "4 given");
  expect_says("x, y, ", "three formulas");
  expect_says("x, foo, z", "character 4: ");
  expect_says("x, foo, z", "foo");
  expect_says("x, sin(y, z", "three formulas");
  expect_says("x, y z, z", "three formulas");
  expect_says("0, x = 5, 0", "character 6: '=' assigns");
}

TEST(Displacement, MustBeFinite) {
  EXPECT_EQ(complaint("1 / x, 0, 0"), "");  // it is at 1, although not at 0
  EXPECT_NE(complaint("1 / (x - 1), 0, 0").find("not finite at (1, 2, 3)"), std::string::npos);
  EXPECT_NE(complaint("sqrt(-x), 0, 0").find("not finite"), std::string::npos);
}

class Comma final : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Displacement, DoesNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const Vec3 value = Displacement("1.5, 2e-3 * x, 1234.25")(Vec3(1, 0, 0));
  std::locale::global(before);
  EXPECT_EQ(value, Vec3(1.5, 2e-3, 1234.25));
}

}  // namespace
}  // namespace evenmesh
