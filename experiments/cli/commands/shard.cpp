// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/shard.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "experiments/failure.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using run::Shard;

constexpr std::uint64_t most_shards = 1'000'000;

/// The environment variables in which a launcher passes the rank of this process, from 0, and the number of processes.
struct Launcher {
  const char* rank;
  const char* size;
};
constexpr std::array process_launchers{Launcher{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                       Launcher{"PMI_RANK", "PMI_SIZE"}, Launcher{"SLURM_PROCID", "SLURM_NTASKS"}};

std::uint64_t number_in(const Environment& environment, const char* name) {
  const char* text = environment(name);
  const auto number = number::parse_integer(text == nullptr ? "" : text);
  if (!number || *number < 0)
    throw Failure(Exit::usage, fmt::format("--shard auto: {} is \"{}\", not a whole number; give --shard i/N", name,
                                           text == nullptr ? "" : text));
  return static_cast<std::uint64_t>(*number);
}

/// The shard of this rank, which counts from 0. Throws Failure(usage) where the numbers do not fit.
Shard checked(std::uint64_t rank, std::uint64_t size, std::string_view where) {
  if (size > most_shards)
    throw Failure(Exit::usage,
                  fmt::format("--shard auto: {} give {} shards; at most {} can be distinguished, start fewer", where,
                              size, most_shards));
  if (rank >= size)
    throw Failure(Exit::usage,
                  fmt::format("--shard auto: {} give number {} of {}, from 0; give --shard i/N", where, rank, size));
  return {rank + 1, size};
}

std::optional<Shard> process_shard(const Environment& environment) {
  for (const auto& [rank, size] : process_launchers) {
    if (environment(rank) == nullptr || environment(size) == nullptr) continue;
    return checked(number_in(environment, rank), number_in(environment, size), fmt::format("{} and {}", rank, size));
  }
  return std::nullopt;
}

std::optional<Shard> array_shard(const Environment& environment) {
  if (environment("SLURM_ARRAY_TASK_ID") == nullptr || environment("SLURM_ARRAY_TASK_COUNT") == nullptr)
    return std::nullopt;
  const auto id = number_in(environment, "SLURM_ARRAY_TASK_ID");
  const auto first = number_in(environment, "SLURM_ARRAY_TASK_MIN");
  const auto count = number_in(environment, "SLURM_ARRAY_TASK_COUNT");
  if (id < first)
    throw Failure(Exit::usage,
                  fmt::format("--shard auto: SLURM_ARRAY_TASK_ID {} is below SLURM_ARRAY_TASK_MIN {}; give "
                              "--shard i/N",
                              id, first));
  return checked(id - first, count, "SLURM_ARRAY_TASK_ID less _MIN and _COUNT (use an array without gaps)");
}

Shard automatic_shard(const Environment& environment) {
  const auto process = process_shard(environment);
  const auto array = array_shard(environment);
  if (!process && !array)
    throw Failure(Exit::usage,
                  "--shard auto: started neither by Open MPI, nor with PMI, nor by Slurm; give --shard i/N");
  const Shard inner = process.value_or(Shard());
  const Shard outer = array.value_or(Shard());
  return checked((outer.number - 1) * inner.count + inner.number - 1, outer.count * inner.count,
                 "array and processes together");
}

}  // namespace

Shard shard_of(std::string_view text, const Environment& environment) {
  if (text == "auto") return automatic_shard(environment);
  const auto slash = text.find('/');
  const auto number = number::parse_integer(text.substr(0, slash));
  const auto count = number::parse_integer(slash == std::string_view::npos ? "" : text.substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count || static_cast<std::uint64_t>(*count) > most_shards)
    throw Failure(Exit::usage,
                  fmt::format("--shard {}: must be i/N with 1 <= i <= N <= {}, or auto", echo(text), most_shards));
  return {static_cast<std::uint64_t>(*number), static_cast<std::uint64_t>(*count)};
}

}  // namespace bezierbench::cli
