// SPDX-License-Identifier: MIT
// De Casteljau's algorithm with a + t (b - a), as a method of a bezierbench of one's own.
#include <bezierbench/harness.hpp>

struct Mine : bezierbench::TakenAsGiven<bezierbench::Form::bernstein> {
  static constexpr bezierbench::MethodInfo info{.id = "own_lerp", .label = "My own", .flops = "", .citation = ""};

  template <class Scalar, int Dimension, int Degree>
  static bezierbench::Point<Scalar, Dimension> evaluate(
      const bezierbench::Curve<bezierbench::Form::bernstein, Scalar, Dimension, Degree>& curve, Scalar t) {
    auto b = bezierbench::working_copy(curve);
    for (int last = curve.degree(); last > 0; --last)
      for (int i = 0; i < last; ++i)
        for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = b(axis, i) + t * (b(axis, i + 1) - b(axis, i));
    bezierbench::Point<Scalar, Dimension> point;
    for (int axis = 0; axis < Dimension; ++axis) point[axis] = b(axis, 0);
    return point;
  }
};

int main(int argc, char** argv) { return bezierbench::harness::main<Mine>(argc, argv); }
