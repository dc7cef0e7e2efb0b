// SPDX-License-Identifier: MIT
// The inputs of a trial: a random curve and a parameter.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/sample/cell.hpp"
#include "experiments/sample/generator.hpp"

namespace bezierbench::sample {

struct Trial {
  std::vector<double> coefficients;  ///< point by point, ascending: x0 y0 x1 y1 ...; (degree + 1) * dimension values
  double t = 0;
  std::vector<double> weights{};  ///< degree + 1 positive values for a rational curve, else none
};

/// Draws the trials of one cell; those of a slice beyond its last one begin again with the first. A trial is a pure
/// function of (seed, study id, cell, trial number). t is drawn first, then the coefficients point by point, then the weights, each from the next words (words.hpp). So t does not depend
/// on the number of coefficients, nor do these depend on the weights. Values are doubles; for float, the caller rounds
/// them.
class Sampler {
 public:
  /// Throws Failure(Exit::usage) for a generator that is not in the roster; suites are checked when they are read.
  Sampler(std::uint64_t seed, std::string_view study_id, const Cell& cell);
  Sampler(std::uint64_t seed, std::uint64_t study_key, const Cell& cell);

  /// Draws trial `trial` into `out`, whose memory is reused. Trials count from 0 on through all replicates. Safe to
  /// call from several threads.
  void draw(std::uint64_t trial, Trial& out) const;

 private:
  using Fill = void (*)(Words&, const Cell&, Trial&);

  std::uint64_t seed_;
  std::uint64_t study_key_;
  std::uint64_t cell_key_;
  Cell cell_;
  Fill fill_;
};

/// Draws one trial. For many trials of one cell a Sampler is faster.
void draw(std::uint64_t seed, std::uint64_t study_key, const Cell& cell, std::uint64_t trial, Trial& out);

/// The info of every generator, in the order of the roster.
std::span<const GeneratorInfo> generators();

}  // namespace bezierbench::sample
