// SPDX-License-Identifier: MIT
// The kernel's files are read here, and not through hwloc, for three reasons. hwloc (2.9) knows the model of the
// processor, the caches and the memory; microcode, virtualisation, governor, boost, clock and load it does not know, so
// that /proc and /sys would be read beside it. For what it knows, its calls take as many lines as the two functions
// below. And its memory is the sum over the nodes of NUMA, on a virtual machine 4.6 % less than MemTotal: bundles so
// far and bundles to come would be of different machines.

#include "experiments/bundle/machine.hpp"

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif
#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/manifest.hpp"
#include "experiments/failure.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::bundle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Text = std::optional<std::string>;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

// The content of one of the kernel's files without blanks around it; empty where it is absent, unreadable or empty.
Text content(const fs::path& path) {
  try {
    const std::string bytes = read_file(path);
    const std::string_view text = trimmed(bytes);
    return text.empty() ? Text() : Text(text);
  } catch (const Failure&) {
    return std::nullopt;
  }
}

// The value of the first "key : value" line.
Text field(const Text& lines, std::string_view key) {
  std::string_view rest = lines ? std::string_view(*lines) : std::string_view();
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || trimmed(line.substr(0, colon)) != key) continue;
    const std::string_view value = trimmed(line.substr(colon + 1));
    return value.empty() ? Text() : Text(value);
  }
  return std::nullopt;
}

std::optional<std::uint64_t> integer(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Bytes from "48K", "2M" (cache sizes) or "16318480 kB" (memory).
std::optional<std::uint64_t> bytes(const Text& text) {
  if (!text) return std::nullopt;
  std::string_view unit = *text;
  unit.remove_prefix(std::min(unit.find_first_not_of("0123456789"), unit.size()));
  const auto count = integer(std::string_view(*text).substr(0, text->size() - unit.size()));
  unit = trimmed(unit);
  constexpr std::array<std::pair<std::string_view, int>, 5> shifts{
      {{"", 0}, {"K", 10}, {"kB", 10}, {"M", 20}, {"G", 30}}};
  const auto* shift = std::ranges::find(shifts, unit, &std::pair<std::string_view, int>::first);
  if (!count || shift == shifts.end()) return std::nullopt;
  return *count << shift->second;
}

// The processors of a kernel list such as "0-3,8": the first one and their number.
struct Processors {
  std::uint64_t first;
  std::uint64_t count;
};

std::optional<Processors> processors(const Text& list) {
  if (!list) return std::nullopt;
  std::optional<Processors> result;
  std::string_view rest = *list;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    const std::size_t dash = part.find('-');
    const auto low = integer(part.substr(0, dash));
    const auto high = dash == std::string_view::npos ? low : integer(part.substr(dash + 1));
    if (!low || !high || *high < *low) return std::nullopt;
    if (!result) result = Processors{*low, 0};
    result->count += *high - *low + 1;
  }
  return result;
}

std::optional<bool> flag(const Text& text) {
  if (text == "1") return true;
  if (text == "0") return false;
  return std::nullopt;
}

std::optional<bool> contains_word(const Text& words, std::string_view word) {
  if (!words) return std::nullopt;
  return (' ' + *words + ' ').find(fmt::format(" {} ", word)) != std::string::npos;
}

template <typename Value>
Json known(const std::optional<Value>& value) {
  return value ? Json(*value) : Json("unknown");
}

Json known(const std::string& value) { return value.empty() ? Json("unknown") : Json(value); }

Json cpu(const Text& information, const Text& allowed, const MachineRoots& roots) {
  utsname names{};
  const auto available = processors(allowed);
  Json json;
  json["model_name"] = known(field(information, "model name"));
  json["vendor"] = known(field(information, "vendor_id"));
  json["family"] = known(field(information, "cpu family"));
  json["model"] = known(field(information, "model"));
  json["stepping"] = known(field(information, "stepping"));
  json["microcode"] = known(field(information, "microcode"));
  json["architecture"] = known(uname(&names) == 0 ? std::string(names.machine) : std::string());
  json["logical_cores_available"] = available ? Json(available->count) : Json("unknown");
  json["smt"] = known(flag(content(roots.sys / "devices/system/cpu/smt/active")));
  // Only x86 has a line of flags; on other processors the answer is "unknown".
  json["virtualised"] = known(contains_word(field(information, "flags"), "hypervisor"));
  return json;
}

Json caches(const fs::path& folder) {
  Json json{{"l1d_bytes", "unknown"}, {"l1i_bytes", "unknown"}, {"l2_bytes", "unknown"}, {"l3_bytes", "unknown"}};
  constexpr int most_indices = 16;  // more than any processor has; absent ones are skipped
  for (int index = 0; index < most_indices; ++index) {
    const fs::path cache = folder / fmt::format("cache/index{}", index);
    const Text level = content(cache / "level");
    const Text type = content(cache / "type");
    if (!level || !type) continue;
    const std::string kind = *type == "Data" ? "d" : (*type == "Instruction" ? "i" : "");
    const std::string key = fmt::format("l{}{}_bytes", *level, level == "1" ? kind : "");
    if (json.contains(key)) json[key] = known(bytes(content(cache / "size")));
  }
  return json;
}

Json frequency(const fs::path& folder, const MachineRoots& roots) {
  const fs::path all = roots.sys / "devices/system/cpu";
  auto boost = flag(content(all / "cpufreq/boost"));
  if (const auto no_turbo = flag(content(all / "intel_pstate/no_turbo")); !boost && no_turbo) boost = !*no_turbo;
  Json json;
  json["governor"] = known(content(folder / "cpufreq/scaling_governor"));
  json["boost"] = known(boost);
  return json;
}

std::string libc() {
#ifdef __GLIBC__
  return fmt::format("glibc {}", gnu_get_libc_version());
#else
  return {};
#endif
}

Json system_facts(HostName host_name, const MachineRoots& roots) {
  const Text aslr = content(roots.proc / "sys/kernel/randomize_va_space");  // 0 none, 1 all but the heap, 2 all
  Json json;
  json["kernel"] = known(content(roots.proc / "sys/kernel/osrelease"));
  json["libc"] = known(libc());
  json["aslr"] = known(aslr ? integer(*aslr) : std::nullopt);
  if (host_name == HostName::told) json["host_name"] = known(content(roots.proc / "sys/kernel/hostname"));
  return json;
}

Json load_average(const MachineRoots& roots) {
  const Text text = content(roots.proc / "loadavg");
  std::string_view rest = text ? std::string_view(*text) : std::string_view();
  Json json = Json::array();
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    const auto value = number::parse_number(word);
    if (!value) return "unknown";
    json.push_back(*value);
  }
  return json;
}

// The smallest difference seen between two readings of the clock, in nanoseconds. It combines the resolution and the
// cost of a reading, and so limits a measurement.
std::int64_t measured_step_ns() {
  using Clock = std::chrono::steady_clock;
  constexpr int enough_steps = 10'000;
  constexpr auto patience = std::chrono::milliseconds(20);
  auto smallest = std::numeric_limits<std::int64_t>::max();
  const auto start = Clock::now();
  auto last = start;
  for (int steps = 0; steps < enough_steps && last - start <= patience;) {
    const auto now = Clock::now();
    const std::int64_t step = std::chrono::duration_cast<std::chrono::nanoseconds>(now - last).count();
    last = now;
    if (step <= 0) continue;
    smallest = std::min(smallest, step);
    ++steps;
  }
  return smallest;
}

Json clock_facts(const MachineRoots& roots) {
  const fs::path source = roots.sys / "devices/system/clocksource/clocksource0/current_clocksource";
  Json json;
  json["name"] = "std::chrono::steady_clock";
  json["source"] = known(content(source));
  json["resolution_ns"] = measured_step_ns();
  return json;
}

Json build_facts(const BuildFacts& build) {
  Json json;
  json["compiler"] = known(build.compiler);
  json["flags"] = known(build.flags);
  json["build_type"] = known(build.build_type);
  json["fp_flags"] = known(build.fp_flags);
  json["program_version"] = known(build.program_version);
  return json;
}

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

std::string machine_json(const BuildFacts& build, const std::string& counters, HostName host_name,
                         const MachineRoots& roots) {
  const Text information = content(roots.proc / "cpuinfo");
  const Text allowed = field(content(roots.proc / "self/status"), "Cpus_allowed_list");
  const auto available = processors(allowed);
  const fs::path folder =
      roots.sys / fmt::format("devices/system/cpu/cpu{}", available ? available->first : std::uint64_t{0});
  Json json;
  json["cpu"] = cpu(information, allowed, roots);
  json["caches"] = caches(folder);
  json["frequency"] = frequency(folder, roots);
  json["memory"] = {{"total_bytes", known(bytes(field(content(roots.proc / "meminfo"), "MemTotal")))}};
  json["system"] = system_facts(host_name, roots);
  json["load_average"] = load_average(roots);
  json["clock"] = clock_facts(roots);
  json["counters"] = known(counters);
  json["build"] = build_facts(build);
  for (const auto& [library, version] : build.peers) json["peers"][library] = known(version);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string machine_fingerprint(const std::string& machine_json) {
  Json json;
  try {
    json = parse_json_object(machine_json, "");
  } catch (const Failure&) {
    return sha256_hex(machine_json);
  }
  json.erase("load_average");
  if (json.contains("clock") && json["clock"].is_object()) json["clock"].erase("resolution_ns");
  if (json.contains("system") && json["system"].is_object()) json["system"].erase("host_name");
  return sha256_hex(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

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
    throw Failure(Exit::input_output, "machine.json: {}; run the suite again", error.what());
  }
}

}  // namespace bezierbench::bundle
