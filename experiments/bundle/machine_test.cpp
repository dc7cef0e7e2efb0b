// SPDX-License-Identifier: MIT
#include "experiments/bundle/machine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "experiments/bundle/scratch_folder_test.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using Json = nlohmann::ordered_json;

const BuildFacts facts{"GNU 12.2.0", "-O3 -DX=\"y\"", "Release", "-ffp-contract=off", "0.1.0"};

const std::string counters = "unavailable: this is a test";

// A machine that may run on processors 2, 3 and 5 only.
class Machine : public testing::Test {
 protected:
  Machine() {
    put("proc/cpuinfo",
        "processor\t: 0\nvendor_id\t: GenuineTest\ncpu family\t: 6\nmodel\t\t: 85\nmodel name\t: Test: CPU @ 2.00GHz\n"
        "stepping\t: 7\nmicrocode\t: 0x5003604\nflags\t\t: fpu sse2 fma hypervisor\n\nprocessor\t: 1\nmodel\t\t: 99\n");
    put("proc/self/status", "Name:\tt\nCpus_allowed:\t2c\nCpus_allowed_list:\t2-3,5\n");
    put("proc/meminfo", "MemTotal:       16318480 kB\nMemFree:  1 kB\n");
    put("proc/loadavg", "0.25 1.50 12.75 2/345 6789\n");
    put("proc/sys/kernel/osrelease", "6.1.0-test\n");
    put("proc/sys/kernel/hostname", "secret-host\n");
    put("proc/sys/kernel/randomize_va_space", "2\n");
    put("sys/devices/system/cpu/smt/active", "0\n");
    put("sys/devices/system/cpu/intel_pstate/no_turbo", "1\n");
    put("sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "wrong\n");
    put("sys/devices/system/cpu/cpu2/cpufreq/scaling_governor", "performance\n");
    put("sys/devices/system/clocksource/clocksource0/current_clocksource", "tsc\n");
    put_cache(0, "1", "Data", "48K");
    put_cache(1, "1", "Instruction", "32K");
    put_cache(2, "2", "Unified", "2M");
    put_cache(3, "3", "Unified", "36864K");
  }

  void put(const std::string& name, std::string_view text) { folder_.put(name, text); }

  void put_cache(int index, std::string_view level, std::string_view type, std::string_view size) {
    const std::string cache = "sys/devices/system/cpu/cpu2/cache/index" + std::to_string(index) + "/";
    put(cache + "level", std::string(level) + "\n");
    put(cache + "type", std::string(type) + "\n");
    put(cache + "size", std::string(size) + "\n");
  }

  void remove(const std::string& name) { std::filesystem::remove_all(folder_.path() / name); }

  [[nodiscard]] MachineRoots roots() const { return {folder_.path() / "proc", folder_.path() / "sys"}; }
  [[nodiscard]] Json read() const { return Json::parse(machine_json(facts, counters, HostName::left_out, roots())); }

 private:
  ScratchFolder folder_;
};

TEST_F(Machine, ReadsWhatTheKernelSays) {
  const Json json = read();
  const Json& cpu = json["cpu"];
  EXPECT_EQ(cpu["model_name"], "Test: CPU @ 2.00GHz");
  EXPECT_EQ(cpu["vendor"], "GenuineTest");
  EXPECT_EQ(cpu["family"], "6");
  EXPECT_EQ(cpu["model"], "85");
  EXPECT_EQ(cpu["stepping"], "7");
  EXPECT_EQ(cpu["microcode"], "0x5003604");
  EXPECT_EQ(cpu["logical_cores_available"], 3);
  EXPECT_EQ(cpu["smt"], false);
  EXPECT_EQ(cpu["virtualised"], true);
  EXPECT_EQ(json["caches"],
            Json({{"l1d_bytes", 49152}, {"l1i_bytes", 32768}, {"l2_bytes", 2097152}, {"l3_bytes", 37748736}}));
  EXPECT_EQ(json["frequency"], Json({{"governor", "performance"}, {"boost", false}}));
  EXPECT_EQ(json["memory"]["total_bytes"], 16710123520);
  EXPECT_EQ(json["system"]["kernel"], "6.1.0-test");
  EXPECT_EQ(json["system"]["aslr"], 2);
  EXPECT_EQ(json["load_average"], Json({0.25, 1.5, 12.75}));
  EXPECT_EQ(json["clock"]["source"], "tsc");
  EXPECT_EQ(json["counters"], counters);
  EXPECT_EQ(json["build"], Json({{"compiler", facts.compiler},
                                 {"flags", facts.flags},
                                 {"build_type", facts.build_type},
                                 {"fp_flags", facts.fp_flags},
                                 {"program_version", facts.program_version}}));
}

TEST_F(Machine, HostNameIsLeftOut) {
  EXPECT_EQ(machine_json(facts, counters, HostName::left_out, roots()).find("secret-host"), std::string::npos);
}

TEST_F(Machine, HostNameIsToldWhereAskedForAndTellsMachinesNotApart) {
  const auto told = machine_json(facts, counters, HostName::told, roots());
  EXPECT_EQ(Json::parse(told)["system"]["host_name"], "secret-host");
  EXPECT_EQ(machine_fingerprint(told), machine_fingerprint(machine_json(facts, counters, HostName::left_out, roots())));
}

TEST_F(Machine, BareMetalIsNotVirtualised) {
  put("proc/cpuinfo", "flags\t\t: fpu nohypervisor hypervisors\n");
  EXPECT_EQ(read()["cpu"]["virtualised"], false);
}

TEST_F(Machine, AnotherPlaceForBoost) {
  put("sys/devices/system/cpu/cpufreq/boost", "1\n");
  EXPECT_EQ(read()["frequency"]["boost"], true);
}

TEST_F(Machine, OddContentIsUnknown) {
  put("proc/self/status", "Cpus_allowed_list:\t3-x\n");
  put("proc/meminfo", "MemTotal: lots\n");
  put("proc/loadavg", "0.1 0.2\n");
  put("sys/devices/system/cpu/smt/active", "perhaps\n");
  put("proc/sys/kernel/osrelease", "\xff\xfe bad \n");
  put("proc/sys/kernel/randomize_va_space", "\n");
  const Json json = read();
  EXPECT_EQ(json["cpu"]["logical_cores_available"], "unknown");
  EXPECT_EQ(json["memory"]["total_bytes"], "unknown");
  EXPECT_EQ(json["load_average"], "unknown");
  EXPECT_EQ(json["cpu"]["smt"], "unknown");
  EXPECT_EQ(json["system"]["aslr"], "unknown");
  EXPECT_EQ(json["frequency"]["governor"], "wrong");  // processor 0 is used where there is no list
}

TEST_F(Machine, WithoutProcAndSysTheKeysStayAndSayUnknown) {
  const Json full = read();
  remove("proc");
  remove("sys");
  const Json json = Json::parse(machine_json({}, "", HostName::left_out, roots()));
  for (const auto& group : full.items()) {
    ASSERT_TRUE(json.contains(group.key()));
    if (!group.value().is_object()) {
      EXPECT_EQ(json[group.key()], "unknown");
      continue;
    }
    for (const auto& item : group.value().items()) {
      const bool from_elsewhere = item.key() == "architecture" || item.key() == "libc" || group.key() == "clock";
      ASSERT_TRUE(json[group.key()].contains(item.key())) << item.key();
      if (from_elsewhere) continue;
      EXPECT_EQ(json[group.key()][item.key()], "unknown") << item.key();
    }
  }
}

TEST_F(Machine, NamesTheLibrariesComparedWithIfThereAreAny) {
  EXPECT_FALSE(read().contains("peers"));
  BuildFacts with_peers = facts;
  with_peers.peers = {{"gsl", "2.7.1"}, {"sisl", ""}};
  const Json json = Json::parse(machine_json(with_peers, counters, HostName::left_out, roots()));
  EXPECT_EQ(json["peers"]["gsl"], "2.7.1");
  EXPECT_EQ(json["peers"]["sisl"], "unknown");
}

TEST(MachineHere, ClockIsMeasuredAndTextIsJson) {
  const Json json = Json::parse(machine_json(facts, counters));
  ASSERT_TRUE(json["clock"]["resolution_ns"].is_number_integer());
  EXPECT_GT(json["clock"]["resolution_ns"], 0);
  EXPECT_LT(json["clock"]["resolution_ns"], 20'000'000);
}

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
