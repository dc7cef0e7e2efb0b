// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/model_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>

#include "experiments/external/child.hpp"
#include "experiments/failure.hpp"
#include "experiments/peers/models.hpp"
#include "experiments/run/interruption.hpp"
#include "reference/curves/csv.hpp"

namespace bezierbench::cli {
namespace {

constexpr external::Limits limits{.seconds = 300, .megabytes = 8192};
constexpr std::size_t most_answer = std::size_t{1} << 31U;

/// In the child, whose standard input is the model: a line `COUNT WHY` for all that is left out, an empty one, and the
/// curves; or why there are none, and a failure.
void answer(const std::string& name) {
  const int file = external::keep_output_for_answer();
  try {
    const auto read = peers::model_reader()("/proc/self/fd/0", name);
    for (const auto& [why, count] : read.left_out) external::write_all(file, fmt::format("{} {}\n", count, why));
    external::write_all(file, "\n");
    if (!read.set.empty()) external::write_all(file, curves::to_csv(read.set));
  } catch (const curves::Unreadable& error) {
    external::write_all(file, error.what());
    _exit(EXIT_FAILURE);
  } catch (const std::exception& error) {  // which must not reach the caller of run_in_child in this process
    external::write_all(
        file, fmt::format("{}: its curves cannot be made ({}); split or scale the model", name, error.what()));
    _exit(EXIT_FAILURE);
  }
}

}  // namespace

curves::Read read_model(std::string_view contents, const std::string& name) {
  const auto ended = external::run_in_child([&] { answer(name); }, contents, most_answer, limits, run::interrupted);
  if (ended.end == external::End::interrupted) throw Failure(Exit::interrupted, "{}: interrupted; read it again", name);
  if (ended.end == external::End::timed_out)
    throw curves::Unreadable(
        fmt::format("{}: Open CASCADE takes more than {} s; split the model", name, limits.seconds));
  if (ended.end == external::End::signalled)
    throw curves::Unreadable(
        fmt::format("{}: Open CASCADE ends by signal {} or requires more than {} MB; write the "
                    "model again, or in parts",
                    name, ended.code, limits.megabytes));
  std::string_view text = ended.output;
  if (ended.code != EXIT_SUCCESS)
    throw curves::Unreadable(
        text.empty() ? fmt::format("{}: Open CASCADE ends with exit code {}; split the model", name, ended.code)
                     : std::string(text));
  std::map<std::string, std::size_t> left_out;
  while (!text.starts_with('\n')) {
    const auto end = text.find('\n');
    const auto blank = text.find(' ');
    if (end == std::string_view::npos || blank > end)
      throw curves::Unreadable(fmt::format("{}: Open CASCADE ends before its answer does; split the model", name));
    left_out[std::string(text.substr(blank + 1, end - blank - 1))] = std::stoull(std::string(text.substr(0, blank)));
    text.remove_prefix(end + 1);
  }
  text.remove_prefix(1);
  curves::Read read;
  if (!text.empty()) read = curves::read_csv(text, name, Form::bernstein);
  read.left_out = std::move(left_out);
  return read;
}

}  // namespace bezierbench::cli
