// SPDX-License-Identifier: MIT
// Keys that several kinds have, and the checks of their values.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/field.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

inline constexpr Field order_key{.key = "order",
                                 .meaning = "orders of the derivatives, 0 to 1023",
                                 .example = "[1, 2]",
                                 .required = true,
                                 .axis = Axis::of_cases};
static_assert(max_degree == 1023, "the meaning of order states it");

inline constexpr int most_points = 1000000;
inline constexpr Field points_key{.key = "points",
                                  .meaning = "numbers of data points, 2 to 1000000",
                                  .example = "[10, 100]",
                                  .required = true,
                                  .axis = Axis::of_cases};
static_assert(most_points == 1000000, "the meaning of points states it");

/// Of grids: the largest power of two and one that is no more.
inline constexpr int most_grid_points = static_cast<int>(std::bit_floor(static_cast<unsigned>(most_points - 1))) + 1;

constexpr Field tolerance_key(std::string_view meaning, std::string_view example) {
  return {.key = "tolerance", .meaning = meaning, .example = example, .required = true, .axis = Axis::of_cases};
}

constexpr Field budget_key(std::string_view meaning) {
  return {
      .key = "budget", .meaning = meaning, .example = "20000", .left_out = "nothing: it is required", .required = true};
}

inline constexpr Field published_key{
    .key = "published",
    .meaning = "file of printed values in reference/published that the results are compared with",
    .example = "\"report_tables.csv\"",
    .left_out = "none",
    .settable = false};

/// A copy of `key` for a kind that does not require it. `left_out` says what applies without it.
constexpr Field optional(Field key, std::string_view left_out) {
  key.required = false;
  key.left_out = left_out;
  return key;
}

Finding check_orders(const std::vector<int>& order);
Finding check_points(const std::vector<int>& points);
/// Of grids: a power of two and one.
Finding check_grid_points(const std::vector<int>& points);
Finding check_tolerances(const std::vector<double>& tolerance);
/// `kind` is the id of the kind, for the message.
Finding check_budget(std::string_view kind, std::int64_t budget);
Finding check_published(const std::string& published, const Vocabulary& known);

}  // namespace bezierbench::suite
