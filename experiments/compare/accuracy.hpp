// SPDX-License-Identifier: MIT
// Do two bundles agree bit for bit in everything that suite and seed determine?
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/compare/row_match.hpp"
#include "experiments/compare/side.hpp"

namespace bezierbench::compare {

/// A row that both have.
struct AccuracyRow {
  std::string file;
  Inputs inputs;
  bool identical;
  std::string column;  ///< the first that differs; of identical rows the largest error or, failing that, the first
  std::string a;       ///< as the file says it
  std::string b;
  std::size_t line_a;
  std::size_t line_b;
};

/// Which rows of one method in one study both have, by the digest of the columns that are digested in both.
struct MethodComparison {
  std::size_t agreeing = 0;
  std::vector<bundle::Rows> differing;   ///< of the same inputs, with other results
  std::vector<bundle::Rows> other_rows;  ///< of other cells or numbers of trials: what they have in common agrees
  std::vector<bundle::Rows> only_a;
  std::vector<bundle::Rows> only_b;
};

struct AccuracyComparison {
  std::vector<AccuracyRow> rows;  ///< file by file, each in a's order
  std::size_t differing = 0;
  std::size_t only_a = 0;  ///< rows without a partner
  std::size_t only_b = 0;
  std::vector<std::string> left_out;  ///< files that both have and whose rows say too little of their inputs
  MethodComparison methods;           ///< of these files, too; of none where the seeds differ

  /// The first differing one.
  [[nodiscard]] const AccuracyRow* first_difference() const;
};

/// Compares the deterministic tables. With different seeds the inputs were others and no row has a partner; of
/// different suites only tables with a column `trials` are compared, since no other row says of how many it is.
[[nodiscard]] AccuracyComparison compare_accuracy(const Side& a, const Side& b);

/// A recorded input that can be replayed.
struct RecordedInput {
  std::string id;  ///< worst_id
  std::string trial;
  std::string t;
  std::string coefficients;
};

/// The worst input that a side recorded for the cell and method of such a row.
[[nodiscard]] std::optional<RecordedInput> recorded_input(const Side& side, const Inputs& inputs);

}  // namespace bezierbench::compare
