// SPDX-License-Identifier: MIT
#include "experiments/studies/roster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "experiments/studies/accuracy/accuracy.hpp"
#include "experiments/studies/arc_length/arc_length.hpp"
#include "experiments/studies/bspline/bspline.hpp"
#include "experiments/studies/conversion/conversion.hpp"
#include "experiments/studies/derivative/derivative.hpp"
#include "experiments/studies/exhaustive/exhaustive.hpp"
#include "experiments/studies/fitting/fitting.hpp"
#include "experiments/studies/grid/grid.hpp"
#include "experiments/studies/guarantees/guarantees.hpp"
#include "experiments/studies/hard_cases/hard_cases.hpp"
#include "experiments/studies/interpolation/interpolation.hpp"
#include "experiments/studies/inverse_arc_length/inverse_arc_length.hpp"
#include "experiments/studies/projection/projection.hpp"
#include "experiments/studies/roofline/roofline.hpp"
#include "experiments/studies/search/search.hpp"
#include "experiments/studies/subdivision/subdivision.hpp"
#include "experiments/studies/timing/timing.hpp"
#include "experiments/suite/kinds.hpp"

namespace bezierbench::studies {
namespace {

struct StudyKind {
  const suite::Kind& (*kind)();
  std::unique_ptr<run::Job> (*make)(const suite::Study& study, const run::JobContext& context);
  /// Names of the tables that its rows go to, without .csv; `a|b` where the methods decide which.
  std::array<std::string_view, 2> tables;
};

constexpr std::array kinds{
    StudyKind{suite::AccuracyKeys::kind, accuracy_job, {"accuracy|unstable", "reference"}},
    StudyKind{suite::SearchKeys::kind, search_job, {"search"}},
    StudyKind{suite::ConversionKeys::kind, conversion_job, {"conversion"}},
    StudyKind{suite::TimingKeys::kind, timing_job, {"timing"}},
    StudyKind{suite::RooflineKeys::kind, roofline_job, {"roofline"}},
    StudyKind{suite::DerivativeKeys::kind, derivative_job, {"derivative"}},
    StudyKind{suite::ArcLengthKeys::kind, arc_length_job, {"arc_length|arc_length_unstable"}},
    StudyKind{suite::InverseArcLengthKeys::kind, inverse_arc_length_job, {"inverse_arc_length", "spacing"}},
    StudyKind{suite::ProjectionKeys::kind, projection_job, {"projection|projection_unstable"}},
    StudyKind{suite::InterpolationKeys::kind, interpolation_job, {"interpolation"}},
    StudyKind{suite::FittingKeys::kind, fitting_job, {"fitting"}},
    StudyKind{suite::SubdivisionKeys::kind, subdivision_job, {"subdivision"}},
    StudyKind{suite::HardCasesKeys::kind, hard_cases_job, {"hard_cases"}},
    StudyKind{suite::GuaranteesKeys::kind, guarantees_job, {"guarantees|guarantees_unstable"}},
    StudyKind{suite::ExhaustiveKeys::kind, exhaustive_job, {"exhaustive"}},
    StudyKind{suite::GridKeys::kind, grid_job, {"grid"}},
    StudyKind{suite::BsplineKeys::kind, bspline_job, {"bspline"}}};

const StudyKind& find(const suite::Study& study) {
  const auto found =
      std::ranges::find_if(kinds, [&](const StudyKind& one) { return &one.kind() == &suite::kind_of(study); });
  if (found != kinds.end()) return *found;
  suite::refuse(
      study, {"kind",
              0,
              {},
              fmt::format("kind \"{}\" is not available yet; leave the study out (--only)", suite::kind_of(study).id)});
}

}  // namespace

std::unique_ptr<run::Job> make_job(const suite::Study& study, const run::JobContext& context) {
  return find(study).make(study, context);
}

std::vector<std::vector<std::string>> tables_of(const suite::Study& study) {
  std::vector<std::vector<std::string>> all;
  for (std::string_view rest : find(study).tables) {
    if (rest.empty()) continue;
    auto& one_of = all.emplace_back();
    for (std::size_t bar = 0; bar != std::string_view::npos; rest.remove_prefix(std::min(bar, rest.size() - 1) + 1)) {
      bar = rest.find('|');
      one_of.push_back(fmt::format("{}.csv", rest.substr(0, bar)));
    }
  }
  return all;
}

}  // namespace bezierbench::studies
