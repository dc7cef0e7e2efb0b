// SPDX-License-Identifier: MIT
#include "experiments/sample/draw.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <tuple>

#include "experiments/failure.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/sample/roster.hpp"

namespace bezierbench::sample {
namespace {

template <CoordinateGenerator G>
void fill(Words& words, const Cell& cell, Trial& out) {
  static_assert(WeightGenerator<G> == G::info.limits.weights, "suites know whether weights are drawn");
  out.t = G::parameter(words, cell.t_interval);
  for (double& coordinate : out.coefficients) coordinate = G::coordinate(words, cell.coordinate_range);
  out.weights.clear();
  if constexpr (WeightGenerator<G>) {
    if (cell.form != Form::rational) return;
    out.weights.resize(static_cast<std::size_t>(cell.degree) + 1);
    for (double& weight : out.weights) weight = G::weight(words);
  }
}

template <PolynomialGenerator G>
void fill(Words& words, const Cell& cell, Trial& out) {
  static_assert(!G::info.limits.weights && G::info.limits.whole_curve && G::info.limits.exact_coefficients);
  out.t = G::parameter(words, cell.t_interval);
  out.weights.clear();
  const auto d = static_cast<std::size_t>(cell.dimension);
  const auto count = static_cast<std::size_t>(cell.degree) + 1;
  G::polynomial(words, cell.form, std::span(out.coefficients).first(count));
  for (std::size_t i = count; i-- > 0;) {  // backwards, so that no coefficient is overwritten before it is copied
    const double coordinate = cell.coordinate_range * out.coefficients[i];
    for (std::size_t axis = 0; axis < d; ++axis) out.coefficients[i * d + axis] = coordinate;
  }
}

template <CurveGenerator G>
void fill(Words& words, const Cell& cell, Trial& out) {
  static_assert(!G::info.limits.weights && G::info.limits.whole_curve && G::info.limits.exact_coefficients);
  out.t = G::parameter(words, cell.t_interval);
  out.weights.clear();
  G::curve(words, cell.dimension, out.coefficients);
  for (double& coordinate : out.coefficients) coordinate *= cell.coordinate_range;
}

template <RoundedCurveGenerator G>
void fill(Words& words, const Cell& cell, Trial& out) {
  static_assert(!G::info.limits.weights && G::info.limits.whole_curve && !G::info.limits.exact_coefficients);
  out.t = G::parameter(words, cell.t_interval);
  out.weights.clear();
  G::rounded_curve(words, cell.dimension, cell.coordinate_range, out.coefficients);
}

using Fill = void (*)(Words&, const Cell&, Trial&);

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
      cell_(cell),
      fill_(cell.slice ? nullptr : find(cell.generator)) {}

void Sampler::draw(std::uint64_t trial, Trial& out) const {
  if (cell_.slice) {
    const int further = cell_.degree - cell_.slice->curve(0).degree;
    cell_.slice->draw(seed_, study_key_, cell_key_, trial, further, out);
    return;
  }
  Words words(seed_, study_key_, cell_key_, trial);
  out.coefficients.resize(static_cast<std::size_t>(cell_.degree + 1) * static_cast<std::size_t>(cell_.dimension));
  fill_(words, cell_, out);
}

void draw(std::uint64_t seed, std::uint64_t study_key, const Cell& cell, std::uint64_t trial, Trial& out) {
  Sampler(seed, study_key, cell).draw(trial, out);
}

std::span<const GeneratorInfo> generators() { return infos; }

}  // namespace bezierbench::sample
