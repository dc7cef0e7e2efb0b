// SPDX-License-Identifier: MIT
#include "experiments/suite/external.hpp"

#include <gtest/gtest.h>

#include "experiments/failure.hpp"

namespace bezierbench::suite {
namespace {

const ExternalMethod program{.id = "program_mine",
                             .kind = ExternalKind::program,
                             .label = "",
                             .form = Form::power,
                             .min_degree = 1,
                             .max_degree = 20,
                             .scalars = {ScalarKind::float32, ScalarKind::float64},
                             .problems = {Problem::projection, Problem::evaluation},
                             .source = "python3 'a \"b\".py'",
                             .sha256 = std::string(64, 'a')};
const ExternalMethod plugin{.id = "plugin_mine",
                            .kind = ExternalKind::plugin,
                            .label = "Mine",
                            .form = Form::rational,
                            .source = "mine.so",
                            .sha256 = ""};

TEST(External, ReadsBackItsOwnText) {
  const std::vector<ExternalMethod> methods{program, plugin};
  EXPECT_EQ(parse_external("schema_version = 1\n" + to_toml(methods), "f.toml"), methods);
  EXPECT_TRUE(parse_external("schema_version = 1\n", "f.toml").empty());
  EXPECT_EQ(to_toml(std::span<const ExternalMethod>()), "");
}

TEST(External, RefusesInvalidRecords) {
  const auto text = to_toml(std::vector{program});
  const auto with = [&](const std::string& from, const std::string& to) {
    auto changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  };
  for (const auto& wrong :
       {with("program_mine", "plugin_mine"), with("program_mine", "program_Mine"), with("\"program\"", "\"magic\""),
        with("min_degree = 1", "min_degree = 21"), with("max_degree = 20", "max_degree = 2000"), with("label", "lable"),
        with("projection", "fitting"), text + text, std::string("external = 1\n"), std::string("external = [1]\n")})
    EXPECT_THROW(parse_external(wrong, "f.toml"), Failure) << wrong;
}

TEST(External, IdBeginsWithTheKind) {
  for (const auto* id : {"own_a", "plugin_a", "program_a", "answers_a"}) EXPECT_TRUE(is_external(id)) << id;
  for (const auto* id : {"horner", "peer_gsl", "programs", "plugin", "owner_a"}) EXPECT_FALSE(is_external(id)) << id;
  EXPECT_EQ(external_id_problem("plugin_a1_b", ExternalKind::plugin), "");
  for (const auto* id : {"plugin_", "plugin_A", "plugin_a,b", "program_a", ""})
    EXPECT_NE(external_id_problem(id, ExternalKind::plugin), "") << id;
  EXPECT_NE(external_id_problem("plugin_" + std::string(60, 'a'), ExternalKind::plugin), "");
}

}  // namespace
}  // namespace bezierbench::suite
