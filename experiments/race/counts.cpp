// SPDX-License-Identifier: MIT
#include "experiments/race/counts.hpp"

#include <fmt/format.h>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define BEZIERBENCH_CAN_COUNT true
#else
#define BEZIERBENCH_CAN_COUNT false
#define RUNNING_ON_VALGRIND 0
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#define CALLGRIND_TOGGLE_COLLECT
#define CALLGRIND_DUMP_STATS_AT(name) (void)(name)
#endif

#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "experiments/failure.hpp"

namespace bezierbench::race {
namespace {

std::string text(const Counted& counted) {
  return fmt::format("{} {} {} {} {}", counted.job, counted.part, counted.rival, counted.points, counted.target);
}

/// The frame begins at the start of a page, so that no address on the stack depends on the environment.
[[gnu::noinline]] void count_one(const Rival& rival, const std::string& name) {
  constexpr std::size_t page = 4096;
  alignas(page) volatile char start_of_page = 0;
  (void)start_of_page;
  rival.run();
  CALLGRIND_TOGGLE_COLLECT;
  rival.run();
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

/// What a file says.
struct Contents {
  std::optional<Counted> counted = {};
  std::map<std::string, double> totals = {};  ///< by event
  std::vector<Cycles> cycles = {};
};

Contents contents_of(const std::string& file) {
  std::istringstream lines(file);
  std::vector<std::string> events;
  Contents contents;
  for (std::string line; std::getline(lines, line);) {
    if (auto found = counted_of(line)) contents.counted = std::move(found);
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "events:")
      while (words >> word) events.push_back(word);
    else if (word == "totals:")
      for (const auto& event : events) words >> contents.totals[event];
    else if (word == cycles_heading)
      for (Cycles cycles; words >> cycles.throughput >> cycles.latency;) contents.cycles.push_back(cycles);
  }
  return contents;
}

}  // namespace

std::optional<Counted> counted_of(std::string_view line) {
  constexpr std::string_view before = "desc: Trigger: Client Request: ";
  if (!line.starts_with(before)) return std::nullopt;
  std::istringstream words{std::string(line.substr(before.size()))};
  Counted counted;
  words >> counted.job >> counted.part >> counted.rival >> counted.points;
  if (!words) return std::nullopt;
  words >> counted.target;
  return counted;
}

bool can_count() { return BEZIERBENCH_CAN_COUNT; }

bool runs_under_valgrind() { return RUNNING_ON_VALGRIND != 0; }

void count(std::span<const Rival> rivals, std::size_t job, std::size_t part) {
  CALLGRIND_START_INSTRUMENTATION;
  for (std::size_t k = 0; k < rivals.size(); ++k)
    count_one(rivals[k], text({job, part, k, rivals[k].points_per_batch, rivals[k].target}));
  CALLGRIND_STOP_INSTRUMENTATION;
}

std::vector<std::vector<Cost>> read_counts(std::span<const std::string> files, std::size_t job) {
  std::vector<std::vector<Cost>> all;
  for (const auto& file : files) {
    auto contents = contents_of(file);
    const auto& counted = contents.counted;
    auto& totals = contents.totals;
    if (!counted || counted->job != job) continue;  // another job's, or what Callgrind writes at the end
    if (!totals.contains("Ir") || !totals.contains("Dr") || !totals.contains("Bc"))
      throw Failure(Exit::environment,
                    "callgrind: its output does not have loads, stores and branches; install "
                    "Valgrind 3.15 or later");
    const auto per_point = [&](const char* event) { return totals[event] / static_cast<double>(counted->points); };
    if (all.size() <= counted->part) all.resize(counted->part + 1);
    auto& of_part = all[counted->part];
    if (of_part.size() <= counted->rival) of_part.resize(counted->rival + 1);
    of_part[counted->rival] = {per_point("Ir"), per_point("Dr"),
                               per_point("Dw"), per_point("Bc") + per_point("Bi"),
                               counted->target, std::move(contents.cycles)};
  }
  return all;
}

}  // namespace bezierbench::race
