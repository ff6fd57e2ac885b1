// SPDX-License-Identifier: MIT
#include "evenmesh/classic/laplacian.h"

namespace evenmesh {

Vec3 Laplacian::move(const Star& star, Points x) const {
  if (star.links.empty()) return Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (const Link& link : star.links) sum += x[link.to] - x[link.from];
  return sum / static_cast<double>(star.links.size());
}

}  // namespace evenmesh
