// SPDX-License-Identifier: MIT
#include "experiments/bundle/timing_fitness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "experiments/failure.hpp"

namespace bezierbench::bundle {
namespace {

using SortedJson = nlohmann::json;

/// Clocks that are read without a system call.
constexpr std::array<std::string_view, 4> quick_clocks{"tsc", "arch_sys_counter", "kvm-clock",
                                                       "hyperv_clocksource_tsc_page"};

/// A rival takes 50 microseconds or more in a round; 100 ns are 0.2 % of it.
constexpr double coarse_step_ns = 100;

/// This process should be the only load. A run under way raises the average by up to 1 itself.
constexpr double quiet_load = 1;

std::string clock_trouble(const SortedJson& machine) {
  const std::string source = machine.at("clock").at("source");
  const SortedJson& step = machine.at("clock").at("resolution_ns");
  if (std::ranges::find(quick_clocks, source) == quick_clocks.end())
    return fmt::format("source {} may need a call into the kernel for every reading", source);
  if (step.get<double>() > coarse_step_ns) return fmt::format("steps of {} ns are coarse", step.get<double>());
  return "";
}

std::string clock_words(const SortedJson& machine) {
  return fmt::format("{}, steps of {} ns", machine.at("clock").at("source").get<std::string>(),
                     machine.at("clock").at("resolution_ns").dump());
}

std::string governor_trouble(const SortedJson& machine) {
  const std::string governor = machine.at("frequency").at("governor");
  if (governor == "performance") return "";
  return fmt::format("{}; with anything but performance the frequency may follow the load", governor);
}

std::string boost_trouble(const SortedJson& machine) {
  const SortedJson& boost = machine.at("frequency").at("boost");
  if (boost == false) return "";
  return fmt::format("{}; the frequency may depend on temperature and on the other cores",
                     boost == true ? "on" : "unknown");
}

std::string load_trouble(const SortedJson& machine) {
  const SortedJson& load = machine.at("load_average");
  if (!load.is_array() || load.empty()) return "unknown";
  const auto last_minute = load.front().get<double>();
  if (last_minute <= quiet_load) return "";
  return fmt::format("{:.2f} over the last minute; other processes are running; wait for them or stop them",
                     last_minute);
}

std::string virtualised_trouble(const SortedJson& machine) {
  const SortedJson& virtualised = machine.at("cpu").at("virtualised");
  if (virtualised == false) return "";
  return virtualised == true ? "yes; the host's other guests take time that this machine cannot see" : "unknown";
}

std::string counters_trouble(const SortedJson& machine) {
  const std::string counters = machine.at("counters");
  constexpr std::string_view unavailable = "unavailable";
  return counters == "unknown" || counters.compare(0, unavailable.size(), unavailable) == 0 ? counters : "";
}

struct Aspect {
  std::string_view name;
  std::string (*trouble)(const SortedJson& machine);  ///< what is wrong; empty where nothing is
  std::string (*fine)(const SortedJson& machine);
};

constexpr std::array aspects{
    Aspect{"clock", clock_trouble, clock_words},
    Aspect{"governor", governor_trouble, [](const SortedJson&) { return std::string("performance"); }},
    Aspect{"boost", boost_trouble, [](const SortedJson&) { return std::string("off"); }},
    Aspect{"load", load_trouble,
           [](const SortedJson& machine) {
             return fmt::format("{:.2f} over the last minute", machine.at("load_average").front().get<double>());
           }},
    Aspect{"virtualised", virtualised_trouble, [](const SortedJson&) { return std::string("no"); }},
    Aspect{"counters", counters_trouble,
           [](const SortedJson& machine) { return machine.at("counters").get<std::string>(); }}};

}  // namespace

std::vector<Concern> timing_fitness(std::string_view machine_json) {
  try {
    const SortedJson machine = SortedJson::parse(machine_json);
    std::vector<Concern> concerns;
    for (const auto& aspect : aspects) {
      const std::string trouble = aspect.trouble(machine);
      concerns.push_back(
          {std::string(aspect.name), trouble.empty() ? aspect.fine(machine) : trouble, !trouble.empty()});
    }
    return concerns;
  } catch (const SortedJson::exception& error) {
    throw Failure(Exit::input_output, fmt::format("machine.json: {}; run the suite again", error.what()));
  }
}

}  // namespace bezierbench::bundle
