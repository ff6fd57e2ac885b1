// SPDX-License-Identifier: MIT
//
// The validator that the report is tested with must itself reject what is wrong.
#include "tests/report/schema.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

using nlohmann::json;
using testing::schema_violations;
using Lines = std::vector<std::string>;

const json kSchema = json::parse(R"({
  "type": "object", "required": ["a"], "additionalProperties": false,
  "properties": {
    "a": { "type": ["integer", "null"], "minimum": 0 },
    "b": { "type": "string", "enum": ["x", "y"] },
    "c": { "type": "array", "items": { "$ref": "#/$defs/one" } },
    "d": { "type": "string", "pattern": "^1\\.[0-9]+$" }
  },
  "$defs": { "one": { "type": "object", "required": ["k"], "additionalProperties": { "type": "number" } } }
})");

Lines violations(const char* document) { return schema_violations(kSchema, json::parse(document)); }

TEST(Schema, AcceptsWhatIsValid) {
  EXPECT_EQ(violations(R"({"a": 0})"), Lines{});
  EXPECT_EQ(
      violations(R"({"a": null, "b": "y", "c": [{"k": 1.5}, {"k": 2, "l": 3}], "d": "1.20"})"),
      Lines{});
}

TEST(Schema, RejectsWrongTypes) {
  EXPECT_EQ(violations("[]"), Lines{": [] is not of type \"object\""});
  EXPECT_EQ(violations(R"({"a": 1.5})"), Lines{"/a: 1.5 is not of type [\"integer\",\"null\"]"});
  EXPECT_EQ(violations(R"({"a": 1, "c": {}})"), Lines{"/c: {} is not of type \"array\""});
}

TEST(Schema, RejectsMissingAndSurplusMembers) {
  EXPECT_EQ(violations("{}"), Lines{": 'a' is missing"});
  EXPECT_EQ(violations(R"({"a": 1, "z": 1})"), Lines{"/z: is not allowed"});
}

TEST(Schema, RejectsValuesOutsideEnumMinimumAndPattern) {
  EXPECT_EQ(violations(R"({"a": 1, "b": "z"})"), Lines{"/b: \"z\" is not one of [\"x\",\"y\"]"});
  EXPECT_EQ(violations(R"({"a": -1})"), Lines{"/a: -1 is less than 0"});
  EXPECT_EQ(violations(R"({"a": 1, "d": "2.0"})").size(), 1u);
}

TEST(Schema, FollowsReferencesIntoItems) {
  EXPECT_EQ(violations(R"({"a": 1, "c": [{"k": 1}, {"k": "no"}, {}]})"),
            (Lines{"/c/1/k: \"no\" is not of type \"number\"", "/c/2: 'k' is missing"}));
}

TEST(Schema, DoesNotPassOverWordsItDoesNotKnow) {
  EXPECT_THROW(schema_violations(json::parse(R"({"maximum": 1})"), 2), std::invalid_argument);
}

}  // namespace
}  // namespace evenmesh
