// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/completion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/cli/command.hpp"
#include "experiments/cli/terminal/manual.hpp"

namespace bezierbench::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Completion : public testing::Test {
 protected:
  Completion() {
    auto root = program_.command();
    auto run = root.command("run", "runs");
    run.option("suites", words_, "which").takes(suite_value, [] { return std::vector<std::string>{"report", "rest"}; });
    run.option("--out", word_, "where").takes(folder_value);
    run.option("--set", words_, "what").takes("KEY=V", [] {
      return std::vector<std::string>{"degree=", "generator=dyadic", "generator=integer"};
    });
    run.flag("--quick", flag_, "faster");
    auto list = root.command("list", "lists");
    list.option("--format", word_, "how").one_of({"text", "csv"});
    auto methods = list.command("methods", "all");
    methods.takes_options_of_its_parent();
    root.hidden_command("hidden", [](const auto& /*words*/) {});
  }

  std::vector<std::string> after(const std::vector<std::string>& words) { return completions(program_.tree(), words); }

  std::vector<std::string> words_;
  std::string word_;
  bool flag_ = false;
  Program program_{"program", "a program", "1"};
};

TEST_F(Completion, Commands) {
  EXPECT_THAT(after({""}), ElementsAre("run\truns", "list\tlists"));
  EXPECT_THAT(after({"l"}), ElementsAre("list\tlists"));
  EXPECT_THAT(after({"h"}), IsEmpty());
  EXPECT_THAT(after({"list", "m"}), ElementsAre("methods\tall"));
}

TEST_F(Completion, Options) {
  EXPECT_THAT(after({"run", "--o"}), ElementsAre("--out\twhere"));
  EXPECT_THAT(after({"run", "x.toml", "--q"}), ElementsAre("--quick\tfaster"));
  EXPECT_THAT(after({"list", "methods", "--f"}), ElementsAre("--format\thow"));
}

TEST_F(Completion, Values) {
  EXPECT_THAT(after({"run", "re"}), ElementsAre("report", "rest", ":files"));
  EXPECT_THAT(after({"run", "--quick", "rep"}), ElementsAre("report", ":files"));
  EXPECT_THAT(after({"run", "--out", "re"}), ElementsAre(":folders"));
  EXPECT_THAT(after({"run", "--out=re"}), ElementsAre(":folders"));
  EXPECT_THAT(after({"list", "--format", ""}), ElementsAre("text", "csv"));
  EXPECT_THAT(after({"list", "--format=c"}), ElementsAre("--format=csv"));
  EXPECT_THAT(after({"list", "--format", "csv", "m"}), ElementsAre("methods\tall"));
  EXPECT_THAT(after({"run", "--set", "gen"}), ElementsAre("generator=dyadic", "generator=integer"));
  EXPECT_THAT(after({"run", "--set", "generator=dyadic,i"}), ElementsAre("generator=dyadic,integer"));
  EXPECT_THAT(after({"run", "--set=d"}), ElementsAre("--set=degree="));
}

TEST_F(Completion, ManualPages) {
  const auto tree = program_.tree();
  const auto page = manual_page(tree, tree.commands.front());
  EXPECT_THAT(page, HasSubstr(".B \"program run [SUITE...] [OPTION...]\"\n"));
  EXPECT_THAT(page, HasSubstr(".B \"\\-\\-quick\"\nfaster\n"));
  EXPECT_THAT(page, HasSubstr(".B \"\\-\\-out FOLDER\"\nwhere\n"));
  EXPECT_THAT(manual_page(tree, tree), Not(HasSubstr("hidden")));
}

}  // namespace
}  // namespace bezierbench::cli
