// SPDX-License-Identifier: MIT
#include "experiments/race/peak_rival.hpp"

#include <algorithm>
#include <memory>

namespace bezierbench::race {

template <class Scalar>
Rival peak_rival(const batch::PeakWork<Scalar>& work) {
  auto values = std::make_shared<std::vector<Scalar>>(work.multiplied + work.added, Scalar(0));
  // x <- x/2 + 1/2 ends at 1 within a run.
  const auto run = [values, work] { work.run(Scalar(0.5), Scalar(0.5), values->data()); };
  const auto check = [values, work] {
    const auto ends = std::span(*values).first(work.multiplied);
    const bool right = std::ranges::all_of(ends, [](Scalar x) { return x == 1; });
    std::ranges::fill(*values, Scalar(0));
    return right;
  };
  return {"peak", static_cast<std::size_t>(work.flops), run, check};
}

template Rival peak_rival(const batch::PeakWork<float>&);
template Rival peak_rival(const batch::PeakWork<double>&);

}  // namespace bezierbench::race
