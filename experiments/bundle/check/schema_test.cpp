// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/schema.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bezierbench::bundle {
namespace {

bool holds(const char* schema, const char* value) {
  return !Schema(schema).fault(Schema::Json::parse(value)).has_value();
}

/// The meaning of each keyword in JSON Schema, draft 2020-12.
TEST(Schema, Keywords) {
  struct Case {
    const char* schema;
    const char* good;
    const char* bad;
  };
  for (const auto& [schema, good, bad] :
       {Case{R"({"type": "integer"})", "3", "3.5"},
        Case{R"({"type": "integer"})", "3.0", "\"3\""},
        Case{R"({"type": ["integer", "null"]})", "null", "\"\""},
        Case{R"({"type": "boolean"})", "false", "0"},
        Case{R"({"const": 1})", "1", "2"},
        Case{R"({"enum": ["a", null]})", "null", "\"b\""},
        Case{R"({"anyOf": [{"type": "null"}, {"minimum": 2}]})", "null", "1"},
        Case{R"({"minimum": 0})", "0", "-1"},
        Case{R"({"minimum": 0})", "\"-1\"", "-0.5"},
        Case{R"({"maximum": 18446744073709551615})", "18446744073709551615", "1e20"},
        Case{R"({"exclusiveMinimum": 0})", "0.1", "0"},
        Case{R"({"minLength": 1})", "\"a\"", "\"\""},
        Case{R"({"pattern": "^[a-f]+$"})", "\"abc\"", "\"abg\""},
        Case{R"({"pattern": "^a$"})", "\"a\"", "\"a\\u0000b\""},
        Case{R"({"minItems": 1, "maxItems": 2})", "[1, 2]", "[1, 2, 3]"},
        Case{R"({"minItems": 1})", "[1]", "[]"},
        Case{R"({"items": {"type": "string"}})", "[]", "[\"a\", 1]"},
        Case{R"({"minProperties": 1})", "{\"a\": 1}", "{}"},
        Case{R"({"required": ["a"]})", "{\"a\": null}", "{\"b\": 1}"},
        Case{R"({"properties": {"a": {"type": "null"}}})", "{\"b\": 1}", "{\"a\": 1}"},
        Case{R"({"properties": {"a": {}}, "additionalProperties": false})", "{\"a\": 1}", "{\"b\": 1}"},
        Case{R"({"additionalProperties": {"type": "null"}})", "{\"a\": null}", "{\"a\": 1}"},
        Case{R"({"$ref": "#/$defs/x", "$defs": {"x": {"const": 1}}})", "1", "2"}}) {
    EXPECT_TRUE(holds(schema, good)) << schema << ' ' << good;
    EXPECT_FALSE(holds(schema, bad)) << schema << ' ' << bad;
  }
}

TEST(Schema, SaysWhere) {
  const Schema schema(R"({"properties": {"a": {"items": {"required": ["b"]}}}})");
  EXPECT_EQ(schema.fault(Schema::Json::parse(R"({"a": [{"b": 1}, {}]})")), "a.1.b is missing");
}

TEST(Schema, KeywordsThatNobodyKnowsAreNotPassedOver) {
  EXPECT_THROW(Schema(R"({"properties": {"a": {"multipleOf": 2}}})"), std::invalid_argument);
  EXPECT_THROW(Schema(R"({"anyOf": [{"format": "date"}]})"), std::invalid_argument);
}

}  // namespace
}  // namespace bezierbench::bundle
