// SPDX-License-Identifier: MIT
// The weights of Wozny and Chudy's geometric algorithm without a subtraction, which depend on degree and t only:
//   Q_k = c_k Q_(k-1) + h_k b_k, c_k = k (1-t)/D, h_k = (n-k+1) t h_(k-1)/D, D = k (1-t) + (n-k+1) t h_(k-1), h_0 = 1.
// Of t and 1-t the larger is divided out.
//
// Roundings, for 0 <= t <= 1: let h_(k-1) have e_(k-1). Either the numerator has at most e_(k-1) + 4 (quotient of t and
// the rounded 1-t, two products) and k (1-t) is exact, or it has e_(k-1) + 1 and k (1-t)/t has 2. x / (c + x) has no
// more than x and c together, and 2: so e_k = 6k for both weights, and 2 more in Q_k. The weight of b_i is a product
// over the later steps: at most sum over k of (6k + 2), below (3n + 2)(n + 1).
#pragma once

#include "core/vector/lane_choice.hpp"

namespace bezierbench {

template <class Scalar>
class WoznyChudyWeights {
 public:
  struct Step {
    Scalar point;    ///< c_k
    Scalar control;  ///< h_k
  };

  WoznyChudyWeights(int degree, const Scalar& t) : degree_(degree) {
    const Scalar s = Scalar(1) - t;
    const auto near_start = t + t <= Scalar(1);
    const Scalar ratio = select(near_start, t, s) / select(near_start, s, t);
    t_share_ = select(near_start, ratio, Scalar(1));
    rest_share_ = select(near_start, Scalar(1), ratio);
  }

  /// Of step k; to be called for k = 1, ..., n, one after the other.
  Step next(int k) {
    const Scalar numerator = h_ * t_share_ * static_cast<Scalar>(degree_ - k + 1);
    const Scalar complement = static_cast<Scalar>(k) * rest_share_;
    const Scalar denominator = complement + numerator;
    h_ = numerator / denominator;
    return {complement / denominator, h_};
  }

 private:
  int degree_;
  Scalar t_share_;  ///< the pair t : 1-t, over the larger of them
  Scalar rest_share_;
  Scalar h_ = Scalar(1);
};

}  // namespace bezierbench
