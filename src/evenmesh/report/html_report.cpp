// SPDX-License-Identifier: MIT
#include "evenmesh/report/html_report.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "evenmesh/base/base64.h"
#include "evenmesh/base/version.h"
#include "evenmesh/report/html_text.h"
#include "evenmesh/report/packed_mesh.h"
#include "evenmesh/report/page_bundle.h"
#include "evenmesh/report/static_page.h"

namespace evenmesh {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDataFormat = 1;
constexpr std::size_t kForArrays = 6'000;  // bytes of the list of arrays, notes and the like

std::string_view unit(Metric metric) {
  return metric == Metric::min_angle || metric == Metric::max_angle ? "\u00B0" : "";
}

std::string_view better(Metric metric) { return larger_is_better(metric) ? "higher" : "lower"; }

// Of a cell with all edges equal; angles differ from kind to kind.
Json ideal(Metric metric) {
  const bool angle = metric == Metric::min_angle || metric == Metric::max_angle;
  return angle ? Json(nullptr) : Json(1.0);
}

Json quality_of(const Distribution& d) {
  return {{"worst", d.worst}, {"p1", d.p1}, {"p5", d.p5}, {"median", d.median}, {"mean", d.mean}};
}

Json quality_list(const ReportPage& page) {
  Json list = Json::array();
  for (const Metric metric : kMetrics) {
    if (page.before.of(metric).count == 0) continue;
    Json entry = {{"metric", name(metric)},
                  {"better", better(metric)},
                  {"ideal", ideal(metric)},
                  {"unit", unit(metric)},
                  {"before", quality_of(page.before.of(metric))}};
    if (page.after) entry["after"] = quality_of(page.after->of(metric));
    list.push_back(std::move(entry));
  }
  return list;
}

Json verdict_list(const ReportPage& page) {
  Json list = Json::array();
  for (const Verdict& v : page.verdicts) {
    list.push_back(
        {{"name", v.name}, {"pass", v.pass ? Json(*v.pass) : Json(nullptr)}, {"text", v.text}});
  }
  return list;
}

Json ledger_list(const ReportPage& page) {
  Json list = Json::array();
  for (const LedgerLine& line : page.ledger) {
    list.push_back({{"name", line.name}, {"value", line.value}});
  }
  return list;
}

Json worst_list(const ReportPage& page, const PackedMesh& packed) {
  std::unordered_map<std::size_t, std::size_t> places;
  for (const ListedCell& listed : page.worst) {
    const auto found = std::find(packed.cells.begin(), packed.cells.end(), listed.number);
    if (found == packed.cells.end()) continue;
    places[listed.number] = static_cast<std::size_t>(found - packed.cells.begin());
  }
  Json list = Json::array();
  for (const auto& [cell, number] : page.worst) {
    Json entry = {{"name", cell.name},
                  {"kind", traits(cell.kind).name},
                  {"cell", places.contains(number) ? Json(places[number]) : Json(-1)},
                  {"shape_before", cell.shape_before}};
    if (page.after) entry["shape_after"] = cell.shape_after;
    entry["inverted"] = cell.inverted;
    entry["held_by"] = cell.held_by;
    list.push_back(std::move(entry));
  }
  return list;
}

Json history_list(const ReportPage& page) {
  Json list = Json::array();
  if (page.run == nullptr) return list;
  for (const Iteration& i : page.run->report.history) {
    list.push_back({{"iteration", i.number},
                    {"cost", i.cost},
                    {"gradient", i.gradient},
                    {"max_move", i.max_move},
                    {"inverted", i.inverted},
                    {"function", i.function}});
  }
  return list;
}

Json mesh_of(const ShownMesh& mesh, const PackedMesh& packed) {
  Json metrics = Json::array();
  for (const auto& [metric, range] : packed.metrics) {
    metrics.push_back({{"name", name(metric)},
                       {"better", better(metric)},
                       {"unit", unit(metric)},
                       {"low", range.low},
                       {"high", range.high}});
  }
  const Vec3& origin = packed.grid.origin;
  return {{"dimension", packed.is_flat ? 2 : 3},
          {"type", name(mesh.orientation.type)},
          {"cells", {{"shown", packed.cells.size()}, {"of", mesh.before.cells().size()}}},
          {"points",
           {{"count", packed.vertices},
            {"scale", packed.grid.step},
            {"origin", {origin.x(), origin.y(), origin.z()}}}},
          {"has_after", mesh.has_after()},
          {"metrics", metrics},
          {"iterates", packed.iterates}};
}

Json arrays_of(const PackedMesh& packed) {
  Json arrays = Json::object();
  std::size_t offset = 0;
  for (const auto& [array_name, array] : packed.arrays) {
    arrays[array_name] = {{"offset", offset},       {"bytes", array.bytes.size()},
                          {"count", array.count},   {"components", array.components},
                          {"planes", array.planes}, {"rule", name(array.rule)}};
    offset += array.bytes.size();
  }
  return arrays;
}

std::vector<std::string> all_notes(const ReportPage& page, const PackedMesh& packed) {
  std::vector<std::string> notes = page.notes;
  notes.insert(notes.end(), packed.notes.begin(), packed.notes.end());
  return notes;
}

// Without groups that cells have no number of.
Json group_list(const ShownMesh& mesh) {
  Json list = Json::array();
  for (std::size_t g = 1; g < mesh.group_names.size(); ++g) list.push_back(mesh.group_names[g]);
  return list;
}

std::string report_json(const ReportPage& page, const ShownMesh& mesh, const PackedMesh& packed) {
  Json json = {{"format", kDataFormat},   {"title", page.title},
               {"kind", name(page.kind)}, {"program", std::string("evenmesh ") + kVersion},
               {"status", page.status},   {"message", page.message}};
  if (page.run != nullptr) json["run"] = Json::parse(to_json(*page.run));
  json["verdicts"] = verdict_list(page);
  json["ledger"] = ledger_list(page);
  json["quality"] = quality_list(page);
  json["worst"] = worst_list(page, packed);
  json["history"] = history_list(page);
  json["command"] = page.command;
  json["notes"] = all_notes(page, packed);
  json["groups"] = group_list(mesh);
  json["mesh"] = mesh_of(mesh, packed);
  json["arrays"] = arrays_of(packed);
  // Names may be in any encoding; what is not UTF-8 is replaced.
  return script_json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string data_of(const PackedMesh& packed) {
  std::string bytes;
  bytes.reserve(packed.bytes());
  for (const NamedArray& one : packed.arrays) bytes += one.array.bytes;
  return to_base64(bytes);
}

std::string document(const ReportPage& page, const std::string& main, const std::string& json,
                     const std::string& data) {
  const PageBundle& bundle = page_bundle();
  std::string text = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n";
  text += fmt::format(
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "script-src 'sha256-{}'; style-src 'sha256-{}'; img-src data:; base-uri 'none'; "
      "form-action 'none'\">\n",
      bundle.script_sha256, bundle.style_sha256);
  text += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  text += fmt::format("<title>evenmesh: {}</title><style>", html_escaped(page.title));
  text += bundle.style;
  text += "</style></head>\n<body>\n<main id=\"evenmesh-static\">\n";
  text += main;
  text += "</main>\n<div id=\"evenmesh-app\" hidden></div>\n";
  text += "<script type=\"application/json\" id=\"evenmesh-report\">";
  text += json;
  text += "</script>\n<script type=\"application/octet-stream\" id=\"evenmesh-data\">";
  text += data;
  text += "</script>\n<script>";
  text += bundle.script;
  text += "</script>\n</body></html>\n";
  return text;
}

}  // namespace

std::string html_report(const ReportPage& page, const ShownMesh& mesh, std::size_t most_bytes) {
  constexpr std::size_t kPictureShare = 20;  // of the file one part at most
  constexpr std::size_t kLeastPicture = 60'000;
  const std::string pictures =
      report_pictures(page, mesh, std::max(kLeastPicture, most_bytes / kPictureShare));
  const std::string empty =
      document(page, static_page(page, {}, pictures), report_json(page, mesh, PackedMesh{}), "");
  const std::size_t taken = empty.size() + kForArrays;
  const std::size_t budget = taken < most_bytes ? (most_bytes - taken) / 4 * 3 : 0;
  const PackedMesh packed = pack_mesh(mesh, budget);
  return document(page, static_page(page, packed.notes, pictures), report_json(page, mesh, packed),
                  data_of(packed));
}

}  // namespace evenmesh
