// SPDX-License-Identifier: MIT
#include "experiments/sample/draw.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <tuple>

#include "experiments/failure.hpp"
#include "experiments/sample/roster.hpp"

namespace bezierbench::sample {
namespace {

template <Generator G>
void fill(Words& words, double range, suite::Interval t, Trial& out) {
  out.t = G::parameter(words, t);
  for (double& coordinate : out.coefficients) coordinate = G::coordinate(words, range);
}

using Fill = void (*)(Words&, double, suite::Interval, Trial&);

constexpr auto infos = []<class... Gs>(const std::tuple<Gs...>*) {
  return std::array{Gs::info...};
}(static_cast<Generators*>(nullptr));

constexpr auto fills = []<class... Gs>(const std::tuple<Gs...>*) {
  return std::array<Fill, sizeof...(Gs)>{&fill<Gs>...};
}(static_cast<Generators*>(nullptr));

Fill find(std::string_view generator) {
  for (std::size_t i = 0; i < infos.size(); ++i) {
    if (infos[i].id == generator) return fills[i];
  }
  throw Failure(Exit::usage, fmt::format("unknown generator \"{}\"; see `bezierbench list generators`", generator));
}

}  // namespace

Sampler::Sampler(std::uint64_t seed, std::string_view study_id, const Cell& cell)
    : Sampler(seed, key(study_id), cell) {}

Sampler::Sampler(std::uint64_t seed, std::uint64_t study_key, const Cell& cell)
    : seed_(seed),
      study_key_(study_key),
      cell_key_(key(cell)),
      size_(static_cast<std::size_t>(cell.degree + 1) * static_cast<std::size_t>(cell.dimension)),
      range_(cell.coordinate_range),
      t_interval_(cell.t_interval),
      fill_(find(cell.generator)) {}

void Sampler::draw(std::uint64_t trial, Trial& out) const {
  Words words(seed_, study_key_, cell_key_, trial);
  out.coefficients.resize(size_);
  fill_(words, range_, t_interval_, out);
}

void draw(std::uint64_t seed, std::uint64_t study_key, const Cell& cell, std::uint64_t trial, Trial& out) {
  Sampler(seed, study_key, cell).draw(trial, out);
}

std::span<const GeneratorInfo> generators() { return infos; }

}  // namespace bezierbench::sample
