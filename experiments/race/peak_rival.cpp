// SPDX-License-Identifier: MIT
#include "experiments/race/peak_rival.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace bezierbench::race {

template <class Scalar>
Rival peak_rival(const batch::OperationWork<Scalar>& work) {
  auto values = std::make_shared<std::vector<Scalar>>(work.chains[0].values + work.chains[1].values, Scalar(0));
  const auto run = [values, work] { work.run(work.operand, values->data()); };
  // x <- x/2 + 1/2 ends at 1 within a run and stays there.
  const auto check = [values, work] {
    const auto ends = std::span(*values).first(work.chains[0].values);
    const bool right = std::ranges::all_of(ends, [](Scalar x) { return x == 1; });
    std::ranges::fill(*values, Scalar(0));
    return right;
  };
  return {"peak", static_cast<std::size_t>(work.flops), run, check};
}

template Rival peak_rival(const batch::OperationWork<float>&);
template Rival peak_rival(const batch::OperationWork<double>&);

}  // namespace bezierbench::race
