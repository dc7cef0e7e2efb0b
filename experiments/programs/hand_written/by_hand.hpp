// SPDX-License-Identifier: MIT
// ByHand<Evaluator> is an evaluator as one writes it by hand: `evaluate` takes what the evaluator prepared for a curve,
// as plain arrays of a degree known at compile time, and a parameter. Operations, their order and so the bits are those
// of the evaluator; no code of core is in a coding. Each coding is whole, as one writes it for one method: loops that two
// related methods have in common are written twice. An evaluator without a specialisation has no coding.
#pragma once

namespace hand_written {

template <class Evaluator>
struct ByHand;

template <class Evaluator>
concept HasCoding = requires {
  sizeof(ByHand<Evaluator>);
};

}  // namespace hand_written
