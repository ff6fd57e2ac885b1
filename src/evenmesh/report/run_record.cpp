// SPDX-License-Identifier: MIT
#include "evenmesh/report/run_record.h"

#include <algorithm>
#include <numeric>

#include <nlohmann/json.hpp>

#include "evenmesh/base/version.h"

namespace evenmesh {
namespace {

using Json = nlohmann::ordered_json;  // keys in the order they are written here

Json to_json(const Distribution& d, Metric metric) {
  const bool larger = larger_is_better(metric);
  return {{"min", larger ? d.worst : d.best},
          {"max", larger ? d.best : d.worst},
          {"worst", d.worst},
          {"p1", d.p1},
          {"p5", d.p5},
          {"median", d.median},
          {"mean", d.mean},
          {"count", d.count}};
}

Json to_json(const QualitySummary& quality) {
  Json json = Json::object();
  for (const Metric metric : kMetrics) {
    json[std::string(name(metric))] = to_json(quality.of(metric), metric);
  }
  return json;
}

Json to_json(const Iteration& iteration) {
  Json json = {{"iteration", iteration.number},
               {"function", iteration.function},
               {"cost", iteration.cost},
               {"gradient", iteration.gradient},
               {"plain_gradient", iteration.plain_gradient},
               {"step", iteration.step},
               {"max_move", iteration.max_move},
               {"limited", iteration.limited},
               {"inverted", iteration.inverted},
               {"evaluations", iteration.evaluations},
               {"seconds", iteration.seconds}};
  const StopMeasure& eta = iteration.eta;
  if (eta.sum() > 0.0) {
    json["eta"] = {{"sum", eta.sum()},
                   {"model", eta.model},
                   {"active", eta.active},
                   {"inactive", eta.inactive}};
  }
  return json;
}

Json to_json(const NamedCell& cell) {
  return {{"cell", cell.name},
          {"kind", traits(cell.kind).name},
          {"shape_before", cell.shape_before},
          {"shape_after", cell.shape_after},
          {"inverted", cell.inverted},
          {"fixed_vertices", cell.fixed_vertices},
          {"held_by", cell.held_by}};
}

Json to_json(const InvertedCell& cell) { return {{"cell", cell.name}, {"held_by", cell.held_by}}; }

Json to_json(const HoldingConstraint& holding) {
  return {{"kind", holding.kind},
          {"count", holding.count},
          {"multiplier", holding.multiplier},
          {"strongest", holding.strongest}};
}

Json to_json(const ConstraintSummary& constraint) {
  return {{"kind", constraint.kind},   {"text", constraint.text}, {"entry", name(constraint.entry)},
          {"count", constraint.count}, {"unit", constraint.unit}, {"note", constraint.note}};
}

template <typename T>
Json list_of(const std::vector<T>& items) {
  Json json = Json::array();
  for (const T& item : items) json.push_back(to_json(item));
  return json;
}

Json input_of(const RunRecord& record) {
  Json cells = Json::object();
  for (int k = 0; k < kCellKinds; ++k) {
    const auto count = record.cells[static_cast<std::size_t>(k)];
    if (count > 0) cells[std::string(traits(static_cast<CellKind>(k)).name)] = count;
  }
  return {{"file", record.input},
          {"format", record.format},
          {"bytes", record.input_bytes},
          {"vertices", record.vertices},
          {"cells", cells},
          {"type", name(record.type)},
          {"components", record.components},
          {"cells_against_majority", record.cells_against_majority}};
}

}  // namespace

std::string to_json(const RunRecord& record) {
  const Report& report = record.report;
  Json options = Json::object();
  for (const auto& [key, value] : record.options) options[key] = value;
  const bool failed = record.status == "failed";  // perhaps before there was anything to stop
  const bool classic = report.method != Method::lagrange_newton;
  const std::size_t fixed = report.vertices - report.movable;
  const int iterations = report.history.empty() ? 0 : static_cast<int>(report.history.size()) - 1;
  const Json json = {
      {"schema_version", kReportSchemaVersion},
      {"tool", {{"name", "evenmesh"}, {"version", kVersion}}},
      {"status", record.status},
      {"exit_code", record.exit_code},
      {"message", record.message},
      {"command", record.command},
      {"input", input_of(record)},
      {"output", record.output.empty() ? Json(nullptr) : Json(record.output)},
      {"options", options},
      {"constraints", list_of(record.constraints)},
      {"stop_reason", failed ? Json(nullptr) : Json(name(report.stop))},
      {"promise", failed ? Json(nullptr) : Json(name(report.promise))},
      {"method", failed ? Json(nullptr) : Json(name(report.method))},
      {"solver", failed || classic ? Json(nullptr) : Json(name(report.solver))},
      {"iterations", iterations},
      {"milder_cost", report.milder_cost},
      {"cost_before", report.cost_before},
      {"cost_after", report.cost_after},
      {"inverted_before", report.quality_before.inverted},
      {"inverted_unguarded", report.inverted_unguarded},
      {"inverted_after", report.quality_after.inverted},
      {"quality",
       {{"before", to_json(report.quality_before)}, {"after", to_json(report.quality_after)}}},
      {"geometry",
       {{"moved", report.moved},
        {"movable", report.movable},
        {"fixed", fixed},
        {"held", report.held},
        {"pulled_back", report.pulled_back},
        {"lifted_cells", report.lifting.cells},
        {"max_move", report.max_move},
        {"mean_move", report.mean_move},
        {"deviation", report.deviation},
        {"target_steps", report.target_steps}}},
      {"unmet", report.unmet},
      {"still_inverted", list_of(record.still_inverted)},
      {"holding", list_of(record.holding)},
      {"worst", list_of(record.worst)},
      {"time",
       {{"read_seconds", record.read_seconds},
        {"setup_seconds", report.setup_seconds},
        {"solve_seconds", report.solve_seconds},
        {"check_seconds", report.check_seconds},
        {"write_seconds", record.write_seconds},
        {"total_seconds", record.total_seconds},
        {"cpu_seconds", record.cpu_seconds}}},
      {"peak_memory_bytes", record.peak_memory_bytes},
      {"history", list_of(report.history)},
      {"notes", record.notes}};
  // File and group names may be in any encoding; what is not UTF-8 is replaced, not refused.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::size_t> worst_cells(const CellQuality& quality, std::size_t count) {
  const std::vector<double>& shape = quality.of(Metric::shape);
  const std::vector<char>& inverted = quality.inverted;
  std::vector<std::size_t> cells(shape.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  count = std::min(count, cells.size());
  std::partial_sort(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(count), cells.end(),
                    [&](std::size_t a, std::size_t b) {
                      if (inverted[a] != inverted[b]) return inverted[a] > inverted[b];
                      return shape[a] != shape[b] ? shape[a] < shape[b] : a < b;
                    });
  cells.resize(count);
  return cells;
}

}  // namespace evenmesh
