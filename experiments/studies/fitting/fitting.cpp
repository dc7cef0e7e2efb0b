// SPDX-License-Identifier: MIT
// Studies of kind `fitting`: data of every kind in sample::data_kinds(), fitted to every tolerance and judged by their
// exact distance from the fitted curve. Writes fitting.csv, and to fitting_example.csv the first data set of each study
// in the plane with its fits.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "experiments/judge/methods.hpp"
#include "experiments/studies/fitting/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "experiments/suite/kind.hpp"
#include "reference/companion/polyline_departure.hpp"
#include "reference/error/norm.hpp"

namespace bezierbench::studies {
namespace {

std::vector<reference::NearPlace> near_places(const Fit& fit) {
  std::vector<reference::NearPlace> places;
  for (std::size_t i = 0; i < fit.t.size(); ++i) places.push_back({fit.segment[i], fit.t[i]});
  return places;
}

/// The square of the true distance. The parameters that the method returns shorten the search.
reference::Rational true_distance(int dimension, const std::vector<double>& data, const Fit& fit) {
  return reference::largest_squared_distance(dimension, data, fit.control_points, near_places(fit));
}

reference::Departure departure_of(const FittingKernel& method, const std::vector<double>& data, const Fit& fit,
                                  double tolerance) {
  return reference::departure_from_polyline(method.dimension, data, fit.control_points, near_places(fit), tolerance);
}

/// Whether the distance whose square is `squared` is larger than `distance`; computed without rounding.
bool exceeds(const reference::Rational& squared, double distance) {
  const auto other = reference::exactly(distance);
  return sgn((squared - other * other).numerator) > 0;
}

/// Whether a fit keeps what methods promise, given the square of its true distance.
bool right(const reference::Rational& squared, double tolerance, const reference::Departure& departure) {
  constexpr double max_handle = 3 * (1 + 0x1p-40);  // up to the roundings of both
  return !exceeds(squared, tolerance) && departure.over_limit <= 1 && departure.handle <= max_handle;
}

/// The number of data points whose place on the curve is before that of the point before.
std::uint64_t out_of_order(const Fit& fit) {
  std::uint64_t count = 0;
  for (std::size_t i = 1; i < fit.t.size(); ++i)
    count += std::pair(fit.segment[i], fit.t[i]) < std::pair(fit.segment[i - 1], fit.t[i - 1]) ? 1 : 0;
  return count;
}

}  // namespace

FittingProblem::FittingProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
    : cell_(part.cell),
      kind_(*std::ranges::find(sample::data_kinds(), part.values.data, &sample::DataKind::id)),
      sampler_(seed, study.id, sample::with_displacements(part.cell, *part.values.points)) {}

void FittingProblem::judge(const Kernel& method, const Drawn& data, double tolerance, const Answer& fit,
                           std::uint64_t number, Errors& errors) {
  const auto segments = static_cast<std::uint64_t>(fit.segments(method.dimension));
  errors.segments.add(segments);
  errors.one_segment += segments == 1 ? 1 : 0;
  errors.iterations.add(static_cast<std::uint64_t>(fit.iterations));
  errors.non_converged += fit.converged ? 0 : 1;
  if (!reference::all_finite(fit.control_points) || !std::isfinite(fit.max_error)) {
    ++errors.non_finite;
    return;
  }
  const auto truth = true_distance(method.dimension, data, fit);
  errors.error.add(reference::square_root(reference::error_format, truth));
  errors.claimed.add(metric::to_24_bits(fit.max_error));
  errors.understated += exceeds(truth, fit.max_error) ? 1 : 0;
  const auto departure = departure_of(method, data, fit, tolerance);
  errors.departure.add(departure.distance);
  errors.departure_over_limit.add(departure.over_limit);
  errors.handle_over_chords.add(departure.handle);
  errors.out_of_order += out_of_order(fit);
  if (fit.converged && !right(truth, tolerance, departure)) errors.broken.add(number);
}

bool FittingProblem::is_right(const Kernel& method, const Drawn& data, double tolerance, const Answer& fit) {
  return reference::all_finite(fit.control_points) &&
         right(true_distance(method.dimension, data, fit), tolerance, departure_of(method, data, fit, tolerance));
}

/// Adds trial 0 of the first cell in the plane, with the first number of points, at the first tolerance: for each kind
/// of data first the data points, without a method, then the control points of each method's fit.
void FittingProblem::write_example(tables::Tables& tables, const suite::Study& study, std::uint64_t seed) {
  constexpr int plane = 2;
  const auto parts = judge::parts_of(study, axes);
  const auto first = std::ranges::find_if(parts, [](const auto& part) { return part.cell.dimension == plane; });
  if (first == parts.end()) return;
  const double tolerance = study.tolerance.front();
  for (auto part = first;
       part != parts.end() && part->cell == first->cell && part->values.points == first->values.points; ++part) {
    Drawn data;
    FittingProblem(study, seed, *part).draw(0, data);
    const auto add = [&](std::string_view method, std::optional<std::size_t> segment, std::size_t index,
                         const double* point) {
      tables.add(tables::Row("fitting_example.csv")
                     .set("study", study.id)
                     .set("data", part->values.data)
                     .set("tolerance", tolerance)
                     .set("method", method)
                     .set("segment", segment)
                     .set("index", index)
                     .set("x", point[0])
                     .set("y", point[1]));
    };
    for (std::size_t i = 0; 2 * i < data.size(); ++i) add("", std::nullopt, i, &data[2 * i]);
    for (const auto* method : judge::chosen_trial_kernels<FittingProblem>(study, plane)) {
      const auto b = method->fit(data, tolerance, {}).control_points;
      for (std::size_t i = 0; 2 * i < b.size(); ++i) add(method->info->id, i / 4, i % 4, &b[2 * i]);
    }
  }
}

namespace {

constexpr std::array fitting_fields{suite::field<&suite::Study::points>(suite::points_key),
                                    suite::field<&suite::Study::tolerance>(suite::tolerance_key(
                                        "distances from the data that a fit may have", "[1e-2, 1e-4]"))};

}  // namespace

extern constexpr StudyKind fitting_kind =
    companion_kind<FittingProblem>({.id = "fitting",
                                    .about = "segments and errors of fits to data of random curves",
                                    .own = fitting_fields,
                                    .methods_example = "[\"schneider\"]",
                                    .inputs = {.forms = suite::bernstein_form,
                                               .forms_reason = "data are taken from polynomial Bezier curves",
                                               .double_only = true,
                                               .least_degree = 1,
                                               .least_degree_reason = "data are taken from curves of degree 1 or more",
                                               .parameters = suite::Parameters::whole,
                                               .parameters_reason = "data are taken from whole curves",
                                               .sets = suite::SetUse::none,
                                               .sets_reason = "the data are taken from drawn curves",
                                               .independent_points = true}});

}  // namespace bezierbench::studies
