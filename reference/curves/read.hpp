// SPDX-License-Identifier: MIT
// Reads a file of curves by its kind: CSV, SVG, fonts, JSON.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "reference/curves/curve_set.hpp"

namespace bezierbench::curves {

/// A file that cannot be read as curves: what() is one line that names the file, the line and column where there is
/// one, and what to do.
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Limits of every reader; a file beyond them is Unreadable.
inline constexpr std::size_t most_bytes = std::size_t{256} << 20U;
inline constexpr std::size_t most_curves = 10'000'000;
inline constexpr int most_nesting = 256;

struct Read {
  CurveSet set;
  std::map<std::string, std::size_t> left_out;  ///< how many things of a kind were not read, by the reason
};

/// The form of polynomial coefficients in files that do not state it: CSV without a column `form`, and JSON.
struct ReadOptions {
  Form form = Form::bernstein;
};

/// Whether `name` ends with an extension that decides the kind of a file for read().
bool has_known_extension(const std::string& name);

/// Reads the contents of a file. `name` decides the kind by its extension (.csv, .svg, .ttf, .otf, .ttc, .woff, .woff2,
/// .json, .txt for bare path data) and is named in messages; without a known extension the contents decide. Throws
/// Unreadable.
Read read(std::string_view contents, const std::string& name, const ReadOptions& options = {});

}  // namespace bezierbench::curves
