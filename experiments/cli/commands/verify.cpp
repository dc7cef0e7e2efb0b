// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/verify.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/run/plan.hpp"
#include "experiments/suite/text/reader.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

/// The sum of a column of counts, in a bundle that was verified.
std::int64_t sum(const bundle::CsvDocument& table, std::string_view column) {
  std::int64_t all = 0;
  for (std::size_t row = 0; row < table.row_count(); ++row)
    all += number::parse_integer(table.at(row, column)).value_or(0);
  return all;
}

void print_fine(const std::string& path) {
  fmt::print("{}: fine\n", printable(path));
  const auto bundle = bundle::BundleDirectory::open(path);
  if (const auto reference = bundle.table("reference.csv"))
    fmt::print("{}", wrapped("",
                             fmt::format("of {} evaluations that accuracy studies judged, {} went through the kernels "
                                         "that are timed, the others through kernels for many curves at once",
                                         sum(*reference, "trials"), sum(*reference, "own_kernel")),
                             4));
  if (const auto digests = bundle.table(bundle::digests_name))
    fmt::print("{} digests by table, study and method, each that of its rows\n", digests->row_count());
}

/// What a bundle must contain. Its build may have had other libraries than this one, so all known methods are allowed.
bundle::Expected expected_of(const std::string& suite_text, const std::string& file_name) {
  return run::expected_of(suite::parse_suites(suite_text, file_name, vocabulary_of_all_builds()));
}

}  // namespace

void add_verify(Command program, Exit& exit) {
  auto path = std::make_shared<std::string>();
  auto command = program.command("verify", "check a bundle: checksums, digests, bounds");
  command.option("BUNDLE", *path, "folder of the bundle").required();
  command.action([path, &exit] {
    const auto findings = bundle::verify(*path, expected_of);
    if (findings.empty()) print_fine(*path);
    exit = say_findings(findings);
  });
}

}  // namespace bezierbench::cli
