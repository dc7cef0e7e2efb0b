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

std::optional<Shard> process_shard(const Environment& environment) {
  for (const auto& [rank, size] : process_launchers)
    if (environment(rank) != nullptr && environment(size) != nullptr)
      return Shard{number_in(environment, rank) + 1, number_in(environment, size)};
  return std::nullopt;
}

std::optional<Shard> array_shard(const Environment& environment) {
  if (environment("SLURM_ARRAY_TASK_ID") == nullptr || environment("SLURM_ARRAY_TASK_COUNT") == nullptr)
    return std::nullopt;
  const auto place = number_in(environment, "SLURM_ARRAY_TASK_ID") - number_in(environment, "SLURM_ARRAY_TASK_MIN");
  return Shard{place + 1, number_in(environment, "SLURM_ARRAY_TASK_COUNT")};
}

Shard automatic_shard(const Environment& environment) {
  const auto process = process_shard(environment);
  const auto array = array_shard(environment);
  if (!process && !array)
    throw Failure(Exit::usage,
                  "--shard auto: started neither by Open MPI, nor with PMI, nor by Slurm; give --shard i/N");
  const Shard inner = process.value_or(Shard());
  const Shard outer = array.value_or(Shard());
  return {(outer.number - 1) * inner.count + inner.number, outer.count * inner.count};
}

/// What `i/N` says; 0 of 0 for another text.
Shard given_shard(std::string_view text) {
  const auto slash = text.find('/');
  const auto number = number::parse_integer(text.substr(0, slash));
  const auto count = number::parse_integer(slash == std::string_view::npos ? "" : text.substr(slash + 1));
  if (!number || !count || *number < 0 || *count < 0) return {0, 0};
  return {static_cast<std::uint64_t>(*number), static_cast<std::uint64_t>(*count)};
}

}  // namespace

Shard shard_of(std::string_view text, const Environment& environment) {
  const bool is_automatic = text == "auto";
  const Shard shard = is_automatic ? automatic_shard(environment) : given_shard(text);
  if (shard.number < 1 || shard.number > shard.count || shard.count > most_shards)
    throw Failure(Exit::usage,
                  fmt::format("--shard {}: {}must be i/N with 1 <= i <= N <= {}, or auto", echo(text),
                              is_automatic ? fmt::format("the launcher gives {}/{}; ", shard.number, shard.count) : "",
                              most_shards));
  return shard;
}

}  // namespace bezierbench::cli
