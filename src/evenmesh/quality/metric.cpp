// SPDX-License-Identifier: MIT
#include "evenmesh/quality/metric.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "evenmesh/quality/angles.h"
#include "evenmesh/quality/aspect_ratio.h"
#include "evenmesh/quality/dihedral_angles.h"
#include "evenmesh/quality/edge_ratio.h"
#include "evenmesh/quality/inverted.h"
#include "evenmesh/quality/scaled_jacobian.h"
#include "evenmesh/quality/shape.h"

namespace evenmesh {
namespace {

struct Row {
  std::string_view name;
  bool larger_is_better;
  bool for_volume_cells;
};

constexpr std::array<Row, kMetricCount> kTable = {{{"shape", true, true},
                                                   {"scaled_jacobian", true, true},
                                                   {"min_angle", true, true},
                                                   {"max_angle", false, true},
                                                   {"aspect_ratio", false, true},
                                                   {"edge_ratio", false, true}}};

const Row& row(Metric metric) { return kTable[static_cast<std::size_t>(metric)]; }

template <typename Cell>
double measure_one(Metric metric, const Cell& cell) {
  switch (metric) {
    case Metric::shape:
      return shape(cell);
    case Metric::scaled_jacobian:
      return scaled_jacobian(cell);
    case Metric::min_angle:
      return angle_range(cell).min;
    case Metric::max_angle:
      return angle_range(cell).max;
    case Metric::aspect_ratio:
      return aspect_ratio(cell);
    case Metric::edge_ratio:
      return edge_ratio(cell);
  }
  return std::numeric_limits<double>::quiet_NaN();  // not a metric
}

}  // namespace

std::string_view name(Metric metric) { return row(metric).name; }

bool larger_is_better(Metric metric) { return row(metric).larger_is_better; }

bool applies(Metric metric, CellKind kind) {
  return traits(kind).dimension == 2 || row(metric).for_volume_cells;
}

bool worse(Metric metric, double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && !std::isnan(b);
  return larger_is_better(metric) ? a < b : a > b;
}

double measure(Metric metric, CellKind kind, std::span<const Vec3> corners, const Vec3& up,
               double sign) {
  assert(applies(metric, kind));
  if (traits(kind).dimension == 3) {
    VolumeCell cell;
    cell.set(kind, corners, sign);
    return measure_one(metric, cell);
  }
  SurfaceCell cell;
  cell.set(corners, up);
  return measure_one(metric, cell);
}

bool is_inverted(CellKind kind, std::span<const Vec3> corners, const Vec3& up, double sign) {
  if (traits(kind).dimension == 3) {
    VolumeCell cell;
    cell.set(kind, corners, sign);
    return is_inverted(cell);
  }
  SurfaceCell cell;
  cell.set(corners, up);
  return is_inverted(kind, cell);
}

}  // namespace evenmesh
