// SPDX-License-Identifier: MIT
// `compare`: the differences between bundles in machine, build, accuracy and time.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/folder.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/comparison_text.hpp"
#include "experiments/cli/startup/damage.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/compare/comparison.hpp"
#include "experiments/echo.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::cli {
namespace {

struct CompareOptions {
  std::vector<std::string> bundles;
  std::string format = "text";
  std::string fail_on;
  std::string out;
  std::string method = "*";
  bool all = false;
  bool damaged = false;
};

struct Compared {
  compare::Side base;
  std::vector<compare::Side> others;
  std::vector<compare::Pair> pairs;
};

/// Leaves the rows of the methods that the glob matches.
void keep_methods(const std::string& glob, std::vector<compare::Pair>& pairs) {
  const auto is_other = [&](const auto& row) { return !suite::matches(glob, row.inputs.field("method")); };
  bool found = false;
  for (auto& pair : pairs) {
    std::erase_if(pair.timing.rows, is_other);
    std::erase_if(pair.accuracy.rows, is_other);
    // The counts of rows without a partner are of all methods; those by method say which of these have some.
    pair.timing.only_a = pair.timing.only_b = pair.accuracy.only_a = pair.accuracy.only_b = 0;
    std::erase_if(pair.accuracy.methods, [&](const auto& entry) { return !suite::matches(glob, entry.first.method); });
    found = found || pair.has_common_rows();
  }
  if (!found)
    throw Failure(Exit::usage, fmt::format("--method {}: no method that the bundles have in common matches; see "
                                           "`list methods`",
                                           echo(glob)));
}

Compared compared(const std::vector<std::string>& bundles, bundle::Damage damage) {
  if (bundles.size() < 2)
    throw Failure(Exit::usage, "compare: takes two bundles or more; name first the one to compare with");
  Compared all{.base = compare::read_side(bundles.front(), damage), .others = {}, .pairs = {}};
  for (std::size_t k = 1; k < bundles.size(); ++k) {
    all.others.push_back(compare::read_side(bundles[k], damage));
    all.pairs.push_back(compare::compare_pair(all.base, all.others.back()));
    if (!all.pairs.back().has_common_rows())
      throw Failure(
          Exit::usage,
          fmt::format("{}: does not have a row in common with {}; compare bundles of the same studies and seed",
                      bundles[k], bundles.front()));
  }
  compare::rank_in_all(all.pairs);
  return all;
}

void print_text(const Compared& all, bool every_row) {
  const bool two = all.pairs.size() == 1;
  for (std::size_t k = 0; k < all.pairs.size(); ++k)
    fmt::print("{}{}", pair_text(all.base, all.others[k], all.pairs[k], two, every_row), two ? "" : "\n");
  if (!two || (!all.pairs.front().same_machine && !all.pairs.front().timing.rows.empty()))
    fmt::print("{}", standings_text(compare::standings(all.base, all.others, all.pairs)));
}

void write_files(const Compared& all, const std::filesystem::path& out) {
  if (std::filesystem::exists(out / bundle::manifest_name))
    throw Failure(Exit::usage, fmt::format("{}: is a bundle itself; choose another --out", out.string()));
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error)
    throw Failure(Exit::input_output,
                  fmt::format("{}: cannot be created: {}; choose another --out", out.string(), error.message()));
  bundle::write_file(out / "facts.csv", compare::facts_table(all.pairs).text());
  bundle::write_file(out / "comparison.csv", compare::comparison_table(all.pairs).text());
  bundle::write_file(out / "standings.csv",
                     compare::standings_table(compare::standings(all.base, all.others, all.pairs)).text());
}

Exit judge(const Compared& all, bool slower_fails) {
  Exit exit = Exit::fine;
  for (const auto& pair : all.pairs) {
    if (const auto differing = pair.accuracy.differing(); differing > 0) {
      say(fmt::format("{}: accuracy differs from {} in {} of {} rows", pair.bundle, all.base.name, differing,
                      pair.accuracy.rows.size()));
      exit = Exit::finding;
    }
    const auto count = [&](bool certainly) {
      return std::ranges::count_if(pair.timing.rows, [&](const compare::TimingRow& row) {
        return !row.is_sentinel() && row.raw.verdict == metric::Verdict::slower &&
               row.is_certainly_slower() == certainly;
      });
    };
    if (slower_fails && count(true) > 0) {
      say(fmt::format("{}: {} times are slower than in {}, and {} more are unreliable; see their verdict and quality",
                      pair.bundle, count(true), all.base.name, count(false)));
      exit = Exit::finding;
    }
  }
  return exit;
}

Exit run_compare(const CompareOptions& options) {
  if (options.damaged && !options.out.empty())
    throw Failure(
        Exit::usage,
        "--damaged: not with --out, since the tables would not say that files were damaged; leave one of them out");
  Compared all = compared(options.bundles, damage_of(options.damaged));
  if (options.method != "*") keep_methods(options.method, all.pairs);
  auto damaged = all.base.damaged;
  for (const auto& other : all.others) damaged.insert(damaged.end(), other.damaged.begin(), other.damaged.end());
  print_damage(damaged);
  if (!options.out.empty()) write_files(all, options.out);
  if (options.format == "csv")
    fmt::print("{}", compare::comparison_table(all.pairs).text());
  else
    print_text(all, options.all);
  return judge(all, options.fail_on == "slower");
}

}  // namespace

void add_compare(Command program, Exit& exit) {
  auto options = std::make_shared<CompareOptions>();
  auto command = program.command("compare", "compare machines, accuracy and times of bundles with the first");
  command.option("BUNDLE", options->bundles, "folders that run wrote; two or more").required().takes(bundle_value);
  command.option("--format", options->format, "text or csv").one_of({"text", "csv"});
  command
      .option("--fail-on", options->fail_on, "slower: exit 1 where a method is, in all repetitions and with quality ok")
      .one_of({"slower"});
  command.option("--out", options->out, "folder for the tables that scripts/report --comparison renders")
      .takes(folder_value);
  command.option("--method", options->method, "only methods whose id matches this glob").takes("GLOB", all_methods());
  command.flag("--all", options->all, "every row, not only what changed");
  add_damaged(command, options->damaged);
  command.action([options, &exit] { exit = run_compare(*options); });
}

}  // namespace bezierbench::cli
