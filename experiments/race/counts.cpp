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

#include "experiments/failure.hpp"

namespace bezierbench::race {
namespace {

/// What a file says of the rival whose counts it holds.
struct Counted {
  std::size_t job = 0;
  std::size_t part = 0;
  std::size_t rival = 0;
  std::size_t points = 0;  ///< of the batch
  std::string target = {};
};

std::string text(const Counted& counted) {
  return fmt::format("{} {} {} {} {}", counted.job, counted.part, counted.rival, counted.points, counted.target);
}

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

/// The numbers after `totals:`, by the names after `events:`.
std::map<std::string, double> totals_of(const std::string& file, std::optional<Counted>& counted) {
  std::istringstream lines(file);
  std::vector<std::string> events;
  std::map<std::string, double> totals;
  for (std::string line; std::getline(lines, line);) {
    if (auto found = counted_of(line)) counted = std::move(found);
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "events:")
      while (words >> word) events.push_back(word);
    else if (word == "totals:")
      for (const auto& event : events) words >> totals[event];
  }
  return totals;
}

}  // namespace

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
    std::optional<Counted> counted;
    auto totals = totals_of(file, counted);
    if (!counted || counted->job != job) continue;  // another job's, or what Callgrind writes at the end
    if (!totals.contains("Ir") || !totals.contains("Dr") || !totals.contains("Bc"))
      throw Failure(Exit::environment,
                    "callgrind: its output does not have loads, stores and branches; install "
                    "Valgrind 3.15 or later");
    const auto per_point = [&](const char* event) { return totals[event] / static_cast<double>(counted->points); };
    if (all.size() <= counted->part) all.resize(counted->part + 1);
    auto& of_part = all[counted->part];
    if (of_part.size() <= counted->rival) of_part.resize(counted->rival + 1);
    of_part[counted->rival] = {per_point("Ir"), per_point("Dr"), per_point("Dw"), per_point("Bc") + per_point("Bi"),
                               counted->target};
  }
  return all;
}

}  // namespace bezierbench::race
