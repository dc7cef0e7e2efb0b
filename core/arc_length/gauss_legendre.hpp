// SPDX-License-Identifier: MIT
// Nodes and weights of the Gauss-Legendre rules with 8, 16 and 24 points on [-1, 1]: the nodes x > 0 in descending
// order, each of which also stands for -x. A rule of m points is exact for polynomials up to degree 2m - 1 (tested).
//
// Source: [Davis and Rabinowitz 1984], section 2.7.
#pragma once

#include <array>
#include <cstddef>

namespace bezierbench {

struct GaussNode {
  double x;
  double weight;
};

template <int Points>
inline constexpr std::array<GaussNode, Points / 2> gauss_legendre{};

template <>
inline constexpr std::array<GaussNode, 4> gauss_legendre<8>{{{0.96028985649753629, 0.10122853629037626},
                                                             {0.79666647741362673, 0.22238103445337448},
                                                             {0.52553240991632899, 0.31370664587788727},
                                                             {0.18343464249564981, 0.36268378337836199}}};

template <>
inline constexpr std::array<GaussNode, 8> gauss_legendre<16>{{{0.98940093499164994, 0.027152459411754096},
                                                              {0.9445750230732326, 0.062253523938647894},
                                                              {0.86563120238783176, 0.095158511682492786},
                                                              {0.755404408355003, 0.12462897125553388},
                                                              {0.61787624440264377, 0.14959598881657674},
                                                              {0.45801677765722737, 0.16915651939500254},
                                                              {0.28160355077925892, 0.18260341504492358},
                                                              {0.095012509837637441, 0.1894506104550685}}};

template <>
inline constexpr std::array<GaussNode, 12> gauss_legendre<24>{{{0.99518721999702131, 0.0123412297999872},
                                                               {0.97472855597130947, 0.028531388628933663},
                                                               {0.9382745520027328, 0.044277438817419808},
                                                               {0.88641552700440107, 0.059298584915436783},
                                                               {0.82000198597390295, 0.0733464814110803},
                                                               {0.74012419157855436, 0.086190161531953274},
                                                               {0.64809365193697555, 0.097618652104113884},
                                                               {0.54542147138883956, 0.10744427011596563},
                                                               {0.43379350762604513, 0.1155056680537256},
                                                               {0.3150426796961634, 0.12167047292780339},
                                                               {0.19111886747361631, 0.1258374563468283},
                                                               {0.06405689286260563, 0.12793819534675216}}};

/// A rule on [0, 1], in the order in which its terms are summed; the weights sum to 1.
template <int Points>
struct UnitRule {
  std::array<double, Points> t;
  std::array<double, Points> weight;
};

template <int Points>
inline constexpr UnitRule<Points> unit_rule = [] {
  UnitRule<Points> rule{};
  std::size_t k = 0;
  for (const auto& [x, weight] : gauss_legendre<Points>)
    for (const double signed_x : {-x, x}) {
      rule.t[k] = (1 + signed_x) / 2;
      rule.weight[k++] = weight / 2;
    }
  return rule;
}();

/// The integral of f over [0, 1].
template <int Points, class Function>
double gauss_integral(Function&& f) {
  double sum = 0;
  for (std::size_t k = 0; k < Points; ++k) sum += unit_rule<Points>.weight[k] * f(unit_rule<Points>.t[k]);
  return sum;
}

}  // namespace bezierbench
