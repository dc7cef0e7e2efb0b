// SPDX-License-Identifier: MIT
#include "experiments/studies/roster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "experiments/failure.hpp"
#include "experiments/studies/accuracy/accuracy.hpp"
#include "experiments/studies/arc_length/arc_length.hpp"
#include "experiments/studies/conversion/conversion.hpp"
#include "experiments/studies/derivative/derivative.hpp"
#include "experiments/studies/fitting/fitting.hpp"
#include "experiments/studies/interpolation/interpolation.hpp"
#include "experiments/studies/inverse_arc_length/inverse_arc_length.hpp"
#include "experiments/studies/projection/projection.hpp"
#include "experiments/studies/roofline/roofline.hpp"
#include "experiments/studies/search/search.hpp"
#include "experiments/studies/subdivision/subdivision.hpp"
#include "experiments/studies/timing/timing.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::studies {
namespace {

struct StudyKind {
  suite::Kind kind;
  std::unique_ptr<run::Job> (*make)(const suite::Study& study, const run::JobContext& context);
  /// Names of the tables that its rows go to, without .csv; `a|b` where the methods decide which.
  std::array<std::string_view, 2> tables;
};

constexpr std::array kinds{
    StudyKind{suite::Kind::accuracy, accuracy_job, {"accuracy|unstable", "reference"}},
    StudyKind{suite::Kind::search, search_job, {"search"}},
    StudyKind{suite::Kind::conversion, conversion_job, {"conversion"}},
    StudyKind{suite::Kind::timing, timing_job, {"timing"}},
    StudyKind{suite::Kind::roofline, roofline_job, {"roofline"}},
    StudyKind{suite::Kind::derivative, derivative_job, {"derivative"}},
    StudyKind{suite::Kind::arc_length, arc_length_job, {"arc_length|arc_length_unstable"}},
    StudyKind{suite::Kind::inverse_arc_length, inverse_arc_length_job, {"inverse_arc_length", "spacing"}},
    StudyKind{suite::Kind::projection, projection_job, {"projection|projection_unstable"}},
    StudyKind{suite::Kind::interpolation, interpolation_job, {"interpolation"}},
    StudyKind{suite::Kind::fitting, fitting_job, {"fitting"}},
    StudyKind{suite::Kind::subdivision, subdivision_job, {"subdivision"}}};

}  // namespace

std::unique_ptr<run::Job> make_job(const suite::Study& study, const run::JobContext& context) {
  try {
    for (const auto& one : kinds)
      if (one.kind == study.kind) return one.make(study, context);
    throw Failure(Exit::usage,
                  fmt::format("study \"{}\": kind \"{}\" is not available yet; leave the study out (--only)", study.id,
                              suite::name(study.kind)));
  } catch (const Failure& failure) {
    if (study.place.empty()) throw;
    throw Failure(failure.exit(), fmt::format("{}: {}", study.place, failure.what()));
  }
}

std::vector<std::vector<std::string>> tables_of(suite::Kind kind) {
  std::vector<std::vector<std::string>> all;
  for (const auto& one : kinds)
    for (std::string_view rest : one.tables) {
      if (one.kind != kind || rest.empty()) continue;
      auto& one_of = all.emplace_back();
      for (std::size_t bar = 0; bar != std::string_view::npos; rest.remove_prefix(std::min(bar, rest.size() - 1) + 1)) {
        bar = rest.find('|');
        one_of.push_back(fmt::format("{}.csv", rest.substr(0, bar)));
      }
    }
  return all;
}

}  // namespace bezierbench::studies
