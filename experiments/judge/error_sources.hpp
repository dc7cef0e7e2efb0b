// SPDX-License-Identifier: MIT
// Where the error of a result comes from: an exact value after each step separates them.
//
//   conversion    from the true point to the exact point of the rounded, converted coefficients
//   one_minus_t   from there to the exact point with the rounded 1 - t in place of 1 - t (OneMinusT says how)
//   evaluation    from there to the computed point
// The three distances add up to at least the error (triangle inequality).
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/metric/tally.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::judge {

/// Euclidean distances, rounded to 24 bits.
struct ErrorSources {
  double conversion = 0;
  double one_minus_t = 0;
  double evaluation = 0;
};

struct SourceTallies {
  metric::Tally conversion;
  metric::Tally one_minus_t;
  metric::Tally evaluation;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.conversion, self.one_minus_t, self.evaluation);
  }

  void add(const ErrorSources& sources) {
    conversion.add(sources.conversion);
    one_minus_t.add(sources.one_minus_t);
    evaluation.add(sources.evaluation);
  }
};

/// Splits errors into their sources. Keeps its big integers between calls, so every thread needs its own object.
template <class Scalar>
class SourceMeter {
 public:
  /// `truth` is the exact point of `curve` at `t`, `computed` the result of `kernel` (finite). Empty where a converted
  /// coefficient is not finite, or where the weights of a rational curve sum to zero with the rounded 1 - t.
  std::optional<ErrorSources> measure(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve, Scalar t,
                                      std::span<const double> computed, const reference::ExactPoint& truth) {
    load(kernel, curve);
    for (const double value : coefficients_)
      if (!std::isfinite(value)) return std::nullopt;
    const CurveView<double> evaluated{kernel.evaluated_form, curve.dimension, curve.degree, coefficients_, weights_};
    const auto at = static_cast<double>(t);
    ErrorSources sources;
    before_ = exact_.point(evaluated, at);
    if (kernel.converted != nullptr) sources.conversion = reference::distance(before_, truth);
    if (kernel.info->one_minus_t != OneMinusT::unused) {
      const bool normalised = kernel.info->one_minus_t == OneMinusT::normalised;
      const auto complement = static_cast<double>(Scalar(1) - t);
      const auto& with_rounded = exact_.with_complement(evaluated, at, complement, normalised);
      if (!with_rounded.exists()) return std::nullopt;
      sources.one_minus_t = reference::distance(with_rounded, before_);
      before_ = with_rounded;
    }
    sources.evaluation = reference::Distance(before_).to(computed);
    return sources;
  }

 private:
  void load(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve) {
    weights_.assign(curve.weights.begin(), curve.weights.end());
    if (kernel.converted == nullptr) {
      coefficients_.assign(curve.coefficients.begin(), curve.coefficients.end());
    } else {
      kernel.converted(curve, converted_);
      coefficients_.assign(converted_.begin(), converted_.end());
    }
  }

  reference::ExactCurve exact_;
  reference::ExactPoint before_;
  std::vector<Scalar> converted_;
  std::vector<double> coefficients_;
  std::vector<double> weights_;
};

}  // namespace bezierbench::judge
