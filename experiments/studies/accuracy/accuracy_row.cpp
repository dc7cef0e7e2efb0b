// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy/accuracy_row.hpp"

#include "experiments/number/number.hpp"
#include "experiments/tables/statistics.hpp"

namespace bezierbench::studies {
namespace {

using tables::field;
using tables::largest;
using tables::mean;
using tables::median;
using tables::p99;
using tables::root_mean_square;
using tables::Statistic;

struct Column {
  const char* name;
  std::string (*field)(const Statistics& of);
};

template <auto Member, Statistic Of>
constexpr auto of_judgement = [](const Statistics& s) { return field(s.judgement.*Member, Of); };
template <auto Member, Statistic Of>
constexpr auto of_sources = [](const Statistics& s) { return field(s.judgement.sources.*Member, Of); };
template <Statistic Of>
constexpr auto of_condition = [](const Statistics& s) { return s.exact ? field(s.condition, Of) : std::string(); };

constexpr Column columns[]{
    {"mean_error", of_judgement<&judge::Judgement::error, mean>},
    {"rms_error", of_judgement<&judge::Judgement::error, root_mean_square>},
    {"p50_error", of_judgement<&judge::Judgement::error, median>},
    {"p99_error", of_judgement<&judge::Judgement::error, p99>},
    {"max_error", of_judgement<&judge::Judgement::error, largest>},
    {"mean_error_u", of_judgement<&judge::Judgement::error_u, mean>},
    {"max_error_u", of_judgement<&judge::Judgement::error_u, largest>},
    {"bound_u",
     [](const Statistics& s) { return s.bounded() ? number::decimal(s.judgement.bound_u.value) : std::string(); }},
    {"bound_violations",
     [](const Statistics& s) { return s.bounded() ? std::to_string(s.judgement.violations.count) : std::string(); }},
    {"non_finite", [](const Statistics& s) { return std::to_string(s.judgement.non_finite); }},
    {"mean_error_ulp", of_judgement<&judge::Judgement::error_ulp, mean>},
    {"max_error_ulp", of_judgement<&judge::Judgement::error_ulp, largest>},
    {"mean_relative", of_judgement<&judge::Judgement::relative, mean>},
    {"p50_relative", of_judgement<&judge::Judgement::relative, median>},
    {"max_relative", of_judgement<&judge::Judgement::relative, largest>},
    {"p50_condition", of_condition<median>},
    {"max_condition", of_condition<largest>},
    {"mean_conversion_error", of_sources<&judge::SourceTallies::conversion, mean>},
    {"max_conversion_error", of_sources<&judge::SourceTallies::conversion, largest>},
    {"mean_one_minus_t_error", of_sources<&judge::SourceTallies::one_minus_t, mean>},
    {"max_one_minus_t_error", of_sources<&judge::SourceTallies::one_minus_t, largest>},
    {"mean_evaluation_error", of_sources<&judge::SourceTallies::evaluation, mean>},
    {"max_evaluation_error", of_sources<&judge::SourceTallies::evaluation, largest>},
    {"max_bound",
     [](const Statistics& s) { return s.bounded() ? number::decimal(s.judgement.bound.value) : std::string(); }},
    {"unbounded_trials", [](const Statistics& s) {
       return s.exact ? std::to_string(s.trials - static_cast<std::int64_t>(s.judgement.bounded)) : std::string();
     }}};

}  // namespace

void set_statistics(tables::Row& row, const Statistics& statistics) {
  for (const Column& column : columns) row.set(column.name, column.field(statistics));
}

}  // namespace bezierbench::studies
