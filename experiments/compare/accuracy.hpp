// SPDX-License-Identifier: MIT
// Whether two bundles agree bit for bit in everything that suite and seed determine.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/compare/row_match.hpp"
#include "experiments/compare/side.hpp"

namespace bezierbench::compare {

/// One result of two rows, as the files say it.
struct ResultPair {
  std::string column;
  std::string a;
  std::string b;
};

/// Two rows, one of each bundle, with the same inputs.
struct AccuracyRow {
  std::string file;
  Inputs inputs;
  bool identical;
  std::string column;  ///< the first that differs; for identical rows the largest error or, without one, the first
  std::string a;       ///< the text in the file
  std::string b;
  std::size_t line_a;
  std::size_t line_b;
  std::optional<ResultPair> largest = std::nullopt;  ///< the largest error, in units of u p~ where both tables have it
};

/// How the rows of each method in each study compare, by the digest of the columns that are digested in both bundles.
struct MethodComparison {
  std::vector<bundle::Rows> agreeing;
  std::vector<bundle::Rows> differing;   ///< the same inputs, but other results
  std::vector<bundle::Rows> other_rows;  ///< other cells or other numbers of trials; rows that were paired agree
  std::vector<bundle::Rows> only_a;
  std::vector<bundle::Rows> only_b;
};

struct AccuracyComparison {
  std::vector<AccuracyRow> rows;  ///< by file, and in a file in a's order
  std::size_t differing = 0;
  std::size_t only_a = 0;  ///< rows without a partner
  std::size_t only_b = 0;
  std::vector<std::string> left_out;  ///< files of both bundles whose rows do not say enough about their inputs
  MethodComparison methods;           ///< of all deterministic files, also those left out; empty where the seeds differ
};

/// Compares the deterministic tables. Bundles with different seeds have different inputs, so that no row has a partner.
/// For different suites only tables with a column `trials` are compared: the rows of any other table do not say how
/// many trials they are about.
[[nodiscard]] AccuracyComparison compare_accuracy(const Side& a, const Side& b);

/// A recorded input that can be replayed.
struct RecordedInput {
  std::string id;  ///< worst_id
  std::string trial;
  std::string t;
  std::string coefficients;
};

/// The worst input that `side` recorded for the cell and method of `inputs`; empty where it recorded none.
[[nodiscard]] std::optional<RecordedInput> recorded_input(const Side& side, const Inputs& inputs);

}  // namespace bezierbench::compare
