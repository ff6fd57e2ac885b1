// SPDX-License-Identifier: MIT
#include "apps/evenmesh/expression.h"

#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <muParser.h>

#include "evenmesh/base/error.h"

namespace evenmesh {
namespace {

constexpr std::string_view kTry = "three formulas in x, y, z are expected: '0, 0, 0.1 * sin(pi*x)'";

[[noreturn]] void fail(const std::string& text, std::string_view what) {
  throw InvalidOption(fmt::format("displacement '{}': {}", text, what));
}

[[noreturn]] void fail(const std::string& text, const mu::Parser::exception_type& error) {
  // The position counts from 0 and is -1 or the end where there is no better one.
  const auto place = static_cast<std::size_t>(error.GetPos());
  const std::string where = place < text.size() ? fmt::format("character {}: ", place + 1) : "";
  fail(text, fmt::format("{}{} ({})", where, error.GetMsg(), kTry));
}

/// muParser would take `x = 1`, meant as a comparison, for an assignment.
void check_for_assignments(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) {
      fail(text, fmt::format("character {}: '=' assigns; write '==' to compare", i + 1));
    }
  }
}

}  // namespace

struct Displacement::Formulas {
  std::string text;
  Vec3 p = Vec3::Zero();  // the parser reads x, y and z from here
  mu::Parser parser;
};

Displacement::Displacement(std::string text) : formulas_(std::make_unique<Formulas>()) {
  Formulas& its = *formulas_;
  its.text = std::move(text);
  if (its.text.find_first_not_of(" \t") == std::string::npos) fail(its.text, kTry);
  check_for_assignments(its.text);
  int count = 0;
  try {
    its.parser.DefineVar("x", &its.p.x());
    its.parser.DefineVar("y", &its.p.y());
    its.parser.DefineVar("z", &its.p.z());
    its.parser.DefineConst("pi", std::numbers::pi);
    its.parser.SetExpr(its.text);
    its.parser.Eval(count);
  } catch (const mu::Parser::exception_type& error) {
    fail(its.text, error);
  }
  if (count != 3) fail(its.text, fmt::format("{} given; {}", count, kTry));
}

Displacement::~Displacement() = default;
Displacement::Displacement(Displacement&&) noexcept = default;
Displacement& Displacement::operator=(Displacement&&) noexcept = default;

Vec3 Displacement::operator()(const Vec3& p) const {
  Formulas& its = *formulas_;
  its.p = p;
  int count = 0;
  try {
    const double* const values = its.parser.Eval(count);
    const Vec3 result(values[0], values[1], values[2]);
    if (result.allFinite()) return result;
  } catch (const mu::Parser::exception_type& error) {
    fail(its.text, error);
  }
  fail(its.text, fmt::format("not finite at ({}, {}, {})", p.x(), p.y(), p.z()));
}

}  // namespace evenmesh
