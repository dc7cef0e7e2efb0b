// SPDX-License-Identifier: MIT
#include "experiments/suite/keys.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/suite/nearest.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::suite {

Finding check_orders(const std::vector<int>& order) {
  return each("order", order, [](int value) {
    return value >= 0 && value <= max_degree ? "" : fmt::format("order must be 0 to {}", max_degree);
  });
}

Finding check_points(const std::vector<int>& points) {
  return each("points", points, [](int value) {
    return value >= 2 && value <= most_points ? "" : fmt::format("points must be 2 to {}", most_points);
  });
}

Finding check_grid_points(const std::vector<int>& points) {
  return each("points", points, [](int value) {
    const bool right = value >= 2 && value <= most_grid_points && std::has_single_bit(static_cast<unsigned>(value - 1));
    return right ? "" : fmt::format("points of a grid must be a power of two and one, 2 to {}", most_grid_points);
  });
}

Finding check_tolerances(const std::vector<double>& tolerance) {
  return each("tolerance", tolerance, [](double value) {
    return std::string(std::isfinite(value) && value > 0 ? "" : "tolerance must be finite and above 0");
  });
}

Finding check_budget(std::string_view kind, std::int64_t budget) {
  if (budget >= 1) return std::nullopt;
  return Fault{
      "budget",
      0,
      {},
      fmt::format("kind \"{}\" needs a budget of at least 1, how many inputs it may try; write budget = 20000", kind)};
}

Finding check_published(const std::string& published, const Vocabulary& known) {
  if (published.empty() || std::ranges::count(known.published_files, published) > 0) return std::nullopt;
  return Fault{
      "published",
      0,
      {},
      fmt::format("unknown published \"{}\"{}", echo(published), suggestion(published, known.published_files))};
}

}  // namespace bezierbench::suite
