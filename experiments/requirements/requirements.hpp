// SPDX-License-Identifier: MIT
// What an evaluator must do, whatever it is. Its tests and the command `check` go through this one list.
//
// Each property is decided on inputs from a fixed seed: one that is broken is broken for certain, one that holds was
// not broken by these inputs.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench::requirements {

/// An evaluator or a converted path in every dimension and scalar type.
struct Evaluator {
  std::array<const Kernel<double>*, 3> in_double;  ///< by dimension - 1
  const Kernel<float>* in_float;                   ///< in the plane

  [[nodiscard]] const Kernel<double>& kernel(int dimension) const {
    return *in_double.at(static_cast<std::size_t>(dimension) - 1);
  }
  [[nodiscard]] const MethodInfo& info() const { return *kernel(2).info; }
};

/// All of them, in roster order.
std::vector<Evaluator> evaluators();

/// What became of the cases on which a property was decided.
class Outcome {
 public:
  /// Counts a case. `describe` returns the text that tells it from others; only the first broken case is described.
  template <class Describe>
  void expect(bool holds, const Describe& describe) {
    ++cases_;
    if (holds) return;
    if (broken_++ == 0) first_ = describe();
  }

  [[nodiscard]] std::size_t cases() const { return cases_; }
  [[nodiscard]] std::size_t broken() const { return broken_; }
  [[nodiscard]] const std::string& first() const { return first_; }  ///< the first broken case; empty without one

 private:
  std::size_t cases_ = 0;
  std::size_t broken_ = 0;
  std::string first_;
};

struct Property {
  std::string_view id;
  std::string_view statement;                ///< for people
  bool (*concerns)(const MethodInfo& info);  ///< whether the method must have it
  Outcome (*decide)(const Evaluator& method);
};

/// All properties.
std::span<const Property> properties();

}  // namespace bezierbench::requirements
