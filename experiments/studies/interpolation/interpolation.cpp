// SPDX-License-Identifier: MIT
// Studies of kind `interpolation`: random points joined by the cubic Bezier segments of a C2 natural spline, whose
// control points are judged against the exact ones and by the conditions that they must meet. Writes interpolation.csv,
// with a row for each number of points and method.

#include "experiments/judge/methods.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/interpolation/problem.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/trial/trial_study.hpp"
#include "experiments/suite/keys.hpp"

namespace bezierbench::studies {

namespace {

constexpr std::array interpolation_fields{suite::field<&suite::Study::points>(suite::points_key)};

suite::Finding check_interpolation(const suite::Study& study, const suite::Vocabulary& /*known*/) {
  return suite::check_points(study.points);
}

}  // namespace

extern constexpr StudyKind interpolation_kind{
    .asks = {.id = "interpolation",
             .about = "errors of splines through random points",
             .own = interpolation_fields,
             .methods_example = "[\"c2_natural\"]",
             .inputs = {.forms = suite::bernstein_form,
                        .forms_reason = "splines are of polynomial Bezier curves",
                        .double_only = true,
                        .degree = suite::DegreeUse::not_a_key,
                        .degree_reason = "degree is that of the segments, 3",
                        .parameters = suite::Parameters::whole,
                        .parameters_reason = "points are joined whole",
                        .independent_points = true},
             .problem = Problem::interpolation,
             .check = check_interpolation},
    .make = trial_job<InterpolationProblem>,
    .tables = {"interpolation"},
    .timed = race::timed_companion<InterpolationProblem>(race::Size::points)};

}  // namespace bezierbench::studies
