// SPDX-License-Identifier: MIT
#include "experiments/bundle/timing_fitness.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/bundle/machine.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using Json = nlohmann::ordered_json;

Json quiet_machine() {
  return {{"cpu", {{"virtualised", false}}},
          {"frequency", {{"governor", "performance"}, {"boost", false}}},
          {"load_average", {0.25, 0.5, 9.0}},
          {"clock", {{"source", "tsc"}, {"resolution_ns", 20}}},
          {"counters", "cycles, instructions"}};
}

std::vector<std::string> warnings(const Json& machine) {
  std::vector<std::string> aspects;
  for (const auto& concern : timing_fitness(machine.dump()))
    if (concern.warning) aspects.push_back(concern.aspect);
  return aspects;
}

TEST(TimingFitness, AQuietMachineIsFit) {
  EXPECT_THAT(warnings(quiet_machine()), testing::IsEmpty());
  EXPECT_EQ(timing_fitness(quiet_machine().dump()).size(), 6U);
  EXPECT_EQ(timing_fitness(quiet_machine().dump()).front().text, "tsc, steps of 20 ns");
}

TEST(TimingFitness, EachTroubleIsNamed) {
  const auto changed = [](const char* pointer, const Json& value) {
    Json machine = quiet_machine();
    machine[Json::json_pointer(pointer)] = value;
    return warnings(machine);
  };
  using testing::ElementsAre;
  EXPECT_THAT(changed("/clock/source", "hpet"), ElementsAre("clock"));
  EXPECT_THAT(changed("/clock/resolution_ns", 1'000'000), ElementsAre("clock"));
  EXPECT_THAT(changed("/frequency/governor", "powersave"), ElementsAre("governor"));
  EXPECT_THAT(changed("/frequency/governor", "unknown"), ElementsAre("governor"));
  EXPECT_THAT(changed("/frequency/boost", true), ElementsAre("boost"));
  EXPECT_THAT(changed("/frequency/boost", "unknown"), ElementsAre("boost"));
  EXPECT_THAT(changed("/load_average", Json({3.5, 0, 0})), ElementsAre("load"));
  EXPECT_THAT(changed("/load_average", "unknown"), ElementsAre("load"));
  EXPECT_THAT(changed("/cpu/virtualised", true), ElementsAre("virtualised"));
  EXPECT_THAT(changed("/cpu/virtualised", "unknown"), ElementsAre("virtualised"));
  EXPECT_THAT(changed("/counters", "unavailable: none"), ElementsAre("counters"));
  EXPECT_THAT(changed("/counters", "unknown"), ElementsAre("counters"));
}

TEST(TimingFitness, ReadsWhatThisMachineWrites) { EXPECT_EQ(timing_fitness(machine_json({}, "")).size(), 6U); }

TEST(TimingFitness, RefusesOtherText) {
  EXPECT_THROW(static_cast<void>(timing_fitness("{")), Failure);
  EXPECT_THROW(static_cast<void>(timing_fitness("{}")), Failure);
  EXPECT_THROW(static_cast<void>(timing_fitness("[]")), Failure);
}

}  // namespace
}  // namespace bezierbench::bundle
