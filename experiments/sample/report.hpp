// SPDX-License-Identifier: MIT
// Generator `report`: the inputs of the source report, a lattice of 20001 coordinates and 32768 parameters.
#pragma once

#include "experiments/sample/generator.hpp"

namespace bezierbench::sample {

/// Takes one word per value. Its leading 15 bits are r, a result of the C library's rand() in the source report. The
/// expressions are those of the source report, in its order of operations, each operation rounded to double.
struct Report {
  static constexpr GeneratorInfo info{.id = "report",
                                      .coordinates = "R * ((r % 20001 - 10000) / 10000.0), r of 15 bits",
                                      .t = "t_min + (t_max - t_min) * (r / 32767.0), r of 15 bits",
                                      .limits = {.finite_width = true}};

  static double coordinate(Words& words, double range) {
    const int r = fifteen_bits(words);
    return range * ((r % 20001 - 10000) / 10000.0);
  }

  static double parameter(Words& words, suite::Interval t) {
    const int r = fifteen_bits(words);
    return t.min + (t.max - t.min) * (r / 32767.0);
  }

 private:
  static int fifteen_bits(Words& words) { return static_cast<int>(words.next() >> 49U); }
};

}  // namespace bezierbench::sample
