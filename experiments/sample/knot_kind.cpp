// SPDX-License-Identifier: MIT
#include "experiments/sample/knot_kind.hpp"

#include <array>
#include <cmath>

#include "experiments/sample/words.hpp"

namespace bezierbench::sample {
namespace {

using Place = KnotKind::Place;

double zero(double /*drawn*/) { return 0; }
double anywhere(double drawn) { return drawn; }
double whole(double drawn) { return std::floor(64 * drawn); }

double equal(Place /*place*/, double /*drawn*/) { return 1; }

/// At least 2^-10, so that the ends of a span differ as doubles.
double random(Place /*place*/, double drawn) { return 0x1p-10 + drawn; }

double clamped(Place place, double drawn) { return place == Place::before_span ? 0 : random(place, drawn); }

/// Up to m knots coincide on either side of the span.
double often_zero(Place place, double drawn) { return place == Place::span || drawn >= 0.5 ? random(place, drawn) : 0; }

/// From 2^-41 to 1, every binade as often as any other.
double graded(Place /*place*/, double drawn) {
  const double binade = std::floor(40 * drawn);
  return std::ldexp(1 + (40 * drawn - binade), -1 - static_cast<int>(binade));
}

constexpr std::array all{KnotKind{"uniform", "whole numbers; the span begins at one of 0 to 64", whole, equal},
                         KnotKind{"clamped", "the first span after an m-fold knot 0, random distances", zero, clamped},
                         KnotKind{"random", "random distances of 2^-10 to 1 + 2^-10", anywhere, random},
                         KnotKind{"multiple", "random distances, half of them 0", anywhere, often_zero},
                         KnotKind{"uneven", "random distances from 40 binades", anywhere, graded}};

}  // namespace

std::span<const KnotKind> knot_kinds() { return all; }

std::vector<double> draw_knots(const KnotKind& kind, int degree, Words& words) {
  const auto first = static_cast<std::size_t>(degree) - 1;  // of the span
  const auto drawn = [&words] { return affine(0, 1, words.next_uniform()); };
  const double begin = kind.first(drawn());
  std::vector<double> distances;
  for (std::size_t k = 0; k <= 2 * first; ++k)
    distances.push_back(kind.distance(k < first    ? Place::before_span
                                      : k == first ? Place::span
                                                   : Place::after_span,
                                      drawn()));
  std::vector<double> knots(2 * first + 2, begin);
  for (std::size_t k = first; k-- > 0;) knots[k] = knots[k + 1] - distances[k];
  for (std::size_t k = first; k < distances.size(); ++k) knots[k + 1] = knots[k] + distances[k];
  return knots;
}

}  // namespace bezierbench::sample
