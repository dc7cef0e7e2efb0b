// SPDX-License-Identifier: MIT
#include "experiments/run/progress_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/echo.hpp"

namespace bezierbench::run {
namespace {

using Json = nlohmann::ordered_json;

std::string_view word_of(Ending ending) {
  switch (ending) {
    case Ending::complete: return "complete";
    case Ending::partial: return "partial";
    case Ending::nothing_to_do: return "nothing_to_do";
  }
  return "";
}

/// "bounds violated 7 times, 2 proofs refuted"
std::string broken(const Outcome& outcome) {
  std::vector<std::string> parts;
  if (outcome.violations > 0) parts.push_back(fmt::format("bounds violated {} times", outcome.violations));
  if (outcome.broken_promises > 0) parts.push_back(fmt::format("promises broken {} times", outcome.broken_promises));
  if (outcome.refuted_proofs > 0)
    parts.push_back(fmt::format("{} proof{} refuted", outcome.refuted_proofs, outcome.refuted_proofs == 1 ? "" : "s"));
  return parts.empty() ? "no bound violated" : fmt::format("{}", fmt::join(parts, ", "));
}

/// Programs need no more digits of a share or of seconds.
double rounded(double number) {
  constexpr double thousand = 1000;
  return std::round(number * thousand) / thousand;
}

}  // namespace

std::string duration(double seconds) {
  constexpr std::int64_t minute = 60;
  constexpr std::int64_t hour = 3600;
  constexpr double longest = 1e15;
  const auto whole = static_cast<std::int64_t>(std::llround(std::fmin(seconds, longest)));
  if (whole < minute) return fmt::format("{} s", whole);
  if (whole < hour) return fmt::format("{} min {:02} s", whole / minute, whole % minute);
  return fmt::format("{} h {:02} min", whole / hour, whole % hour / minute);
}

std::string progress_line(const ProgressView& view) {
  constexpr double percent = 100;
  // 100 % is said by the end of the run: a last block may still be under way.
  return fmt::format("{:3.0f} %, about {} left, {} ({} of {} studies done)", std::floor(percent * view.share),
                     duration(view.left), view.study, view.studies_done, view.studies);
}

std::string progress_json(const ProgressView& view) {
  return Json{{"event", "progress"},
              {"study", printable(view.study)},
              {"study_share", rounded(view.study_share)},
              {"share", rounded(view.share)},
              {"studies_done", view.studies_done},
              {"studies", view.studies},
              {"elapsed_s", rounded(view.elapsed)},
              {"left_s", rounded(view.left)}}
      .dump();
}

std::string ending_line(const Outcome& outcome) {
  constexpr double percent = 100;
  auto line = fmt::format("{} in {}: {} cell{}, ", word_of(outcome.ending), duration(outcome.seconds), outcome.cells,
                          outcome.cells == 1 ? "" : "s");
  line += broken(outcome);
  if (outcome.times > 0)
    line += fmt::format(", {} of {} times noisy ({:.1f} %)", outcome.noisy, outcome.times,
                        percent * static_cast<double>(outcome.noisy) / static_cast<double>(outcome.times));
  return line;
}

std::string ending_json(const Outcome& outcome, const std::string& out, const std::vector<std::string>& next) {
  auto json = Json{{"event", "end"}, {"ending", word_of(outcome.ending)}, {"out", printable(out)}};
  if (outcome.ending == Ending::complete) {
    json["cells"] = outcome.cells;
    json["violations"] = outcome.violations;
    json["broken_promises"] = outcome.broken_promises;
    json["refuted_proofs"] = outcome.refuted_proofs;
    json["times"] = outcome.times;
    json["noisy"] = outcome.noisy;
  }
  json["seconds"] = rounded(outcome.seconds);
  json["findings"] = outcome.findings.size();
  for (const auto& command : next) json["next"].push_back(printable(command));
  return json.dump();
}

std::string beginning_json(std::size_t studies, std::size_t cells, std::uint64_t blocks, std::uint64_t blocks_done) {
  return Json{
      {"event", "begin"}, {"studies", studies}, {"cells", cells}, {"blocks", blocks}, {"blocks_done", blocks_done}}
      .dump();
}

std::string message_json(std::string_view text) { return Json{{"event", "message"}, {"text", printable(text)}}.dump(); }

}  // namespace bezierbench::run
