// SPDX-License-Identifier: MIT
#include "experiments/studies/roster.hpp"

#include <fmt/format.h>

#include <array>

#include "experiments/failure.hpp"
#include "experiments/studies/accuracy.hpp"
#include "experiments/studies/arc_length.hpp"
#include "experiments/studies/conversion.hpp"
#include "experiments/studies/derivative.hpp"
#include "experiments/studies/fitting.hpp"
#include "experiments/studies/interpolation.hpp"
#include "experiments/studies/inverse_arc_length.hpp"
#include "experiments/studies/projection.hpp"
#include "experiments/studies/roofline.hpp"
#include "experiments/studies/search.hpp"
#include "experiments/studies/timing.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::studies {
namespace {

struct StudyKind {
  suite::Kind kind;
  std::unique_ptr<Job> (*make)(const suite::Study& study, const JobContext& context);
};

constexpr std::array kinds{StudyKind{suite::Kind::accuracy, accuracy_job},      //
                           StudyKind{suite::Kind::search, search_job},          //
                           StudyKind{suite::Kind::conversion, conversion_job},  //
                           StudyKind{suite::Kind::timing, timing_job},          //
                           StudyKind{suite::Kind::roofline, roofline_job},
                           StudyKind{suite::Kind::derivative, derivative_job},  //
                           StudyKind{suite::Kind::arc_length, arc_length_job},  //
                           StudyKind{suite::Kind::inverse_arc_length, inverse_arc_length_job},
                           StudyKind{suite::Kind::projection, projection_job},        //
                           StudyKind{suite::Kind::interpolation, interpolation_job},  //
                           StudyKind{suite::Kind::fitting, fitting_job}};

}  // namespace

std::unique_ptr<Job> make_job(const suite::Study& study, const JobContext& context) {
  try {
    for (const auto& [kind, make] : kinds)
      if (kind == study.kind) return make(study, context);
    throw Failure(Exit::usage,
                  fmt::format("study \"{}\": kind \"{}\" is not available yet; leave the study out (--only)", study.id,
                              suite::name(study.kind)));
  } catch (const Failure& failure) {
    if (study.place.empty()) throw;
    throw Failure(failure.exit(), fmt::format("{}: {}", study.place, failure.what()));
  }
}

}  // namespace bezierbench::studies
