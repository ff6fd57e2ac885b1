// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace evenmesh::testing {

/// Where a document breaks a JSON Schema, one line each ("/quality/before: 'shape' is missing");
/// empty if it is valid. Knows the words that docs/report.schema.json uses: type, enum, minimum,
/// pattern, required, properties, additionalProperties, items and $ref into the schema itself.
/// @throws std::invalid_argument  the schema uses another word that constrains
std::vector<std::string> schema_violations(const nlohmann::json& schema,
                                           const nlohmann::json& document);

}  // namespace evenmesh::testing
