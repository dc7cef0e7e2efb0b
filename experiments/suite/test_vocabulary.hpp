// SPDX-License-Identifier: MIT
// Known ids for tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "experiments/failure.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

inline const Vocabulary& test_vocabulary() {
  static const Vocabulary known{
      {"direct", "de_casteljau", "horner_bernstein", "power_sum", "horner", "factorial:power_sum", "factorial:horner",
       "forward_substitution:de_casteljau", "forward_substitution:direct", "positive_sum:de_casteljau"},
      {"factorial", "differences", "forward_substitution", "positive_sum", "exact"},
      {"continuous", "dyadic", "integer", "report"},
      {"report_tables.csv"}};
  return known;
}

/// The line that `action` fails with, which must be a Failure(Exit::usage) of one line; empty where it does not fail.
template <class Action>
std::string failure_of(Action action) {
  try {
    action();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::usage);
    const std::string line = failure.what();
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    return line;
  }
  return {};
}

}  // namespace bezierbench::suite
