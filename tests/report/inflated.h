// SPDX-License-Identifier: MIT
//
// Reads what a report holds as its description says, with nothing of what wrote it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace evenmesh::testing {

/// Undoes one array.
/// @param rule  "unsigned", "signed", "delta" or "highwater"
std::vector<std::int64_t> unpacked(std::string_view stream, std::size_t count,
                                   std::size_t components, int planes, const std::string& rule);

/// A report taken apart.
struct ReportFile {
  nlohmann::json json;  // of #evenmesh-report
  std::string data;     // of #evenmesh-data
  std::string script;   // the last element
  std::string style;
  std::string main;    // what stands in <main>
  std::string policy;  // Content-Security-Policy

  bool has(const std::string& array) const { return json["arrays"].contains(array); }
  std::vector<std::int64_t> array(const std::string& name) const;
};

/// @throws std::runtime_error  it is not one
ReportFile parse_report(const std::string& html);

/// SHA-256 in base64, as policies have it (FIPS 180-4).
std::string sha256_base64(std::string_view text);

}  // namespace evenmesh::testing
