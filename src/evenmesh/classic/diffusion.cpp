// SPDX-License-Identifier: MIT
#include "evenmesh/classic/diffusion.h"

#include <algorithm>
#include <cmath>

namespace evenmesh {
namespace {

constexpr double kPart = 0.2;      // of the force that is followed
constexpr double kNearest = 0.01;  // 1e26 is still far from the end of the range of doubles

}  // namespace

double force(Force kind, double d) {
  d = std::max(d, kNearest);
  switch (kind) {
    case Force::lennard_jones:
      return std::pow(d, -13) - std::pow(d, -7);
    case Force::lennard_jones_printed:
      return std::pow(d, -13) - std::pow(d, -4);
    case Force::pliant:
      break;
  }
  const double power = d * d * d * d;
  // Far away the power overflows and the exponential vanishes first.
  return power < 700.0 ? (1.0 - power) * std::exp(-power) : 0.0;
}

Vec3 Diffusion::move(const Star& star, Points x) const {
  if (!(length_ > 0.0)) return Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (const Link& link : star.links) {
    const Vec3 r = x[link.to] - x[link.from];
    const double distance = r.norm();
    if (distance > 0.0) sum -= (force(kind_, distance / length_) / distance) * r;
  }
  const double part = kPart * sum.norm();
  return (part > 1.0 ? length_ * kPart / part : length_ * kPart) * sum;
}

}  // namespace evenmesh
