// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/share.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "experiments/failure.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::run {
namespace {

/// The first block such that the blocks before it have at least this share of the job's cost.
std::uint64_t boundary(const Job& job, double share) {
  const auto each = job.blocks_per_part();
  const double wanted = share * job.total_cost();
  double before = 0;
  for (std::size_t part = 0; part < job.parts(); ++part) {
    const double cost = job.cost(part);
    const double whole = cost * static_cast<double>(each);
    if (before + whole > wanted) {
      const double blocks = std::ceil((wanted - before) / cost);
      return part * each + std::min<std::uint64_t>(each, static_cast<std::uint64_t>(std::max(0.0, blocks)));
    }
    before += whole;
  }
  return job.blocks();
}

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
    throw Failure(Exit::usage, "--shard auto: {} is \"{}\", not a whole number; give --shard i/N", name,
                  text == nullptr ? "" : text);
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

BlockSet::Run dealt(const Job& job, std::size_t job_number, const Shard& shard) {
  if (shard.count == 1) return {0, job.blocks()};
  if (job.exclusive()) return {0, shard.number == 1 ? job.blocks() : 0};
  const auto slice = (shard.number - 1 + job_number) % shard.count;
  const auto end_of = [&](std::uint64_t slices) -> std::uint64_t {
    if (slices == 0) return 0;
    if (slices == shard.count) return job.blocks();
    return boundary(job, static_cast<double>(slices) / static_cast<double>(shard.count));
  };
  return {end_of(slice), end_of(slice + 1)};
}

std::vector<BlockOfJob> exclusive_order(const Jobs& jobs, std::span<const BlockSet::Run> blocks) {
  std::size_t most = 0;
  for (const auto& job : jobs) most = std::max(most, job->exclusive() ? job->blocks_per_part() : 0);
  std::vector<BlockOfJob> order;
  for (std::size_t k = 0; k < most; ++k)
    for (std::size_t job = 0; job < jobs.size(); ++job) {
      const auto each = jobs[job]->blocks_per_part();
      if (!jobs[job]->exclusive() || k >= each) continue;
      for (auto block = blocks[job].first + k; block < blocks[job].second; block += each) order.push_back({job, block});
    }
  return order;
}

Share::Share(const Jobs& jobs, const Checkpoints& checkpoints, const Shard& shard)
    : jobs_(jobs), checkpoints_(checkpoints) {
  for (std::size_t job = 0; job < jobs.size(); ++job) blocks_.push_back(dealt(*jobs[job], job, shard));
}

std::uint64_t Share::count() const {
  std::uint64_t sum = 0;
  for (std::size_t job = 0; job < jobs_.size(); ++job) sum += count(job);
  return sum;
}

std::uint64_t Share::count_done() const {
  std::uint64_t sum = 0;
  for (std::size_t job = 0; job < jobs_.size(); ++job) sum += count_done(job);
  return sum;
}

double Share::cost_left(std::size_t number) const {
  const Job& job = *jobs_[number];
  const auto each = job.blocks_per_part();
  const auto [first, end] = blocks(number);
  double sum = 0;
  for (std::uint64_t at = first; at < end;) {
    const auto part = job.part_of(at);
    const BlockSet::Run run{at, std::min<std::uint64_t>(end, (part + 1) * each)};
    sum += job.cost(part) * static_cast<double>(run.second - run.first - checkpoints_.done(number).within(run).size());
    at = run.second;
  }
  return sum;
}

Shard shard_of(std::string_view text, const Environment& environment) {
  const bool is_automatic = text == "auto";
  const Shard shard = is_automatic ? automatic_shard(environment) : given_shard(text);
  if (shard.number < 1 || shard.number > shard.count || shard.count > most_shards)
    throw Failure(Exit::usage, "--shard {}: {}must be i/N with 1 <= i <= N <= {}, or auto", echo(text),
                  is_automatic ? fmt::format("the launcher gives {}/{}; ", shard.number, shard.count) : "",
                  most_shards);
  return shard;
}

}  // namespace bezierbench::run
