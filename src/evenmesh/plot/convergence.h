// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "evenmesh/solver/report.h"

namespace evenmesh {

/// One value per iteration.
struct Curve {
  std::string name;  // in the legend; any bytes
  /// y[i] belongs to iteration first + i. A value that is not finite, or on a logarithmic axis not
  /// positive, leaves a gap.
  std::vector<double> y;
  int first = 0;
};

/// A vertical line at an iteration that is known beforehand, such as the number a paper reports.
struct Mark {
  double iteration = 0.0;
  std::string label;  // stands above the plot; marks with the same label need it only once
};

enum class Scale { linear, logarithmic };

struct ConvergenceOptions {
  std::string title = {};
  std::string x_title = "iteration";
  std::string y_title = "cost";
  Scale scale = Scale::logarithmic;
  double width = 640.0;   // of the picture, pixels
  double height = 420.0;  // a strip of counts adds to it
  std::vector<Mark> marks = {};
  /// Iterations from which on another function is minimised: curves begin anew there, and a thin
  /// line says so (of more than forty there are none).
  std::vector<double> restarts = {};
  std::string restarts_title = "function changes";  // in the legend
  /// Counts per iteration, drawn in a strip below with a linear axis of its own.
  std::vector<Curve> counts = {};
  std::string counts_title = {};
};

/// Curves over the iterations as a standalone SVG picture, told apart by colour, line style and
/// marker. The legend stands above the plot. No curves, curves without a value and curves of one
/// value are drawn for what they are; the picture never holds NaN.
std::string convergence_plot(std::span<const Curve> curves, const ConvergenceOptions& options = {});

/// What there is left to gain: values less the least of them. The last is 0, and with it a gap on a
/// logarithmic axis, if they fall all the way.
Curve above_least(std::string name, std::span<const double> values);

/// The standard plot of a run: per iteration the gradient relative to its start and the part of the
/// cost that is still to be lost, both on one logarithmic axis, and the inverted cells in a strip
/// below if there ever were any.
///
///   (f_i - f_least) / (f_first - f_least)    within each stage of equal Iteration::function
///
/// @param report   the history may be empty
/// @param options  title, size and marks; the rest is set here
std::string convergence_plot(const Report& report, ConvergenceOptions options = {});

}  // namespace evenmesh
