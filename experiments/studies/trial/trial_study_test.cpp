// SPDX-License-Identifier: MIT
// The common study of companion problems, with a problem made for the test: derivatives whose truth, answers and
// verdicts are plain numbers.
#include "experiments/studies/trial/trial_study.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "core/arc_length/kernel.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::uint64_t wrong_trial = 13;  ///< the first trial with wrong answers
constexpr std::uint64_t uncertain_trial = 1000;

/// Calls that the test observes; they come from one thread.
struct Calls {
  std::vector<std::uint64_t> drawn;
  std::size_t asked = 0;
  std::optional<std::uint64_t> interrupted_at;
} calls;

struct CountedErrors {
  metric::Tally error;
  metric::TrialCount off;
  metric::Total tolerances;  ///< in units of 1/8

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.off, self.tolerances);
  }
};

class CountedProblem {
 public:
  static constexpr Problem problem = Problem::arc_length;
  static constexpr judge::CaseAxes axes{.tolerance = true};
  static constexpr std::string_view table = "arc_length";  // one that the schema declares
  static constexpr std::int64_t block_trials = 4;

  using Kernel = ArcLengthKernel;
  using Answer = std::vector<double>;
  using Errors = CountedErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn {
    std::uint64_t number = 0;
  };

  static constexpr std::array case_columns{judge::case_column::tolerance};
  static constexpr std::array columns{
      TrialColumn<Row>{"max_error", column::statistic<tables::largest, &Errors::error>},
      TrialColumn<Row>{"broken_promises", column::count<&Errors::off>},
      TrialColumn<Row>{"max_evaluations", column::count<&Errors::tolerances, &metric::Total::sum>},
  };
  static constexpr std::array failures{TrialFailure<Row>{"numbers", column::trials<&Errors::off>}};

  static std::span<const Kernel> kernels(int dimension) { return arc_length_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 3; }
  static double trial_nanoseconds(const judge::TrialPart& /*part*/, std::size_t methods) {
    return 10.0 * static_cast<double>(methods);
  }

  CountedProblem(const suite::Study& /*study*/, std::uint64_t /*seed*/, const judge::TrialPart& part)
      : degree_(part.cell.degree) {}

  void draw(std::uint64_t number, Drawn& drawn) const {
    if (number == uncertain_trial) throw reference::NotCertain(1, 1);
    if (number == calls.interrupted_at) raise(SIGINT);
    calls.drawn.push_back(number);
    drawn.number = number;
  }
  /// Answers 1, and from the wrong trial on 1 + degree.
  void ask(const Kernel& /*method*/, const Drawn& drawn, double /*tolerance*/, Answer& answer) const {
    ++calls.asked;
    answer = {drawn.number < wrong_trial ? 1.0 : 1.0 + degree_};
  }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {answer}; }
  static void judge(const Kernel& /*method*/, const Drawn& /*drawn*/, double tolerance, const Answer& answer,
                    std::uint64_t number, Errors& errors) {
    errors.error.add(answer[0] - 1);
    errors.tolerances.add(static_cast<std::uint64_t>(8 * tolerance));
    if (answer[0] != 1) errors.off.add(number);
  }
  static bool is_right(const Kernel& /*method*/, const Drawn& /*drawn*/, double /*tolerance*/, const Answer& answer) {
    return answer[0] == 1;
  }

 private:
  int degree_;
};

suite::Study small_study() {
  calls = {};
  suite::Study study;
  study.id = "counted";
  study.kind = &kind("arc_length");
  study.tolerance = {0.5, 0.125};
  study.degree = {2, 5};
  study.methods = {"gauss_legendre_24", "adaptive_simpson38"};
  study.trials = 5;
  study.replicates = 2;  // three blocks, the last one short
  return study;
}

std::vector<std::uint64_t> first_trials(std::uint64_t count) {
  std::vector<std::uint64_t> all(count);
  for (std::uint64_t k = 0; k < count; ++k) all[k] = k;
  return all;
}

TEST(TrialStudy, AsksEveryMethodAtEveryToleranceOfEachTrialOnce) {
  auto study = small_study();
  study.degree = {2};
  const auto job = trial_job<CountedProblem>(study, {1});
  ASSERT_EQ(job->parts(), 1U);
  ASSERT_EQ(job->blocks_per_part(), 3U);
  EXPECT_EQ(job->cost(0), 4 * 10 * 2);
  EXPECT_EQ(job->extent().rows, 4U);
  EXPECT_EQ(job->extent().evaluations, 4U * 10);
  run::run_all(*job);
  EXPECT_EQ(calls.drawn, first_trials(10)) << "a trial is drawn once for all methods and tolerances";
  EXPECT_EQ(calls.asked, 4U * 10);
}

TEST(TrialStudy, HasARowForEachPartToleranceAndMethod) {
  const auto job = trial_job<CountedProblem>(small_study(), {1});
  run::run_all(*job);
  const auto csv = bundle::parse_csv(run::text_of(*job).at("arc_length.csv"), "arc_length.csv");
  ASSERT_EQ(csv.row_count(), 2U * 2 * 2);
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "degree"), row < 4 ? "2" : "5");
    EXPECT_EQ(csv.at(row, "tolerance"), row % 4 < 2 ? "0.5" : "0.125");
    EXPECT_EQ(csv.at(row, "method"), row % 2 == 0 ? "adaptive_simpson38" : "gauss_legendre_24") << "in roster order";
    EXPECT_EQ(csv.at(row, "max_evaluations"), row % 4 < 2 ? "40" : "10") << "ten trials";
    EXPECT_EQ(csv.at(row, "trials"), "10");
    EXPECT_EQ(csv.at(row, "status"), "ok");
    EXPECT_EQ(csv.at(row, "max_error"), "0");
  }
}

TEST(TrialStudy, SaysWhatFailedAndWhereFirst) {
  auto study = small_study();
  study.trials = 20;
  study.replicates = 1;
  study.degree = {5};
  study.tolerance = {0.5};
  study.methods = {"gauss_legendre_24"};
  const auto job = trial_job<CountedProblem>(study, {1});
  for (std::size_t block = job->blocks(); block-- > 0;) job->add(0, job->run_block(block));  // in reverse order
  const auto violations = job->violations();
  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0].count, 20 - wrong_trial);
  EXPECT_TRUE(violations[0].where.ends_with(
      ", generator continuous, tolerance 0.5, method gauss_legendre_24, numbers, first at trial 13"))
      << violations[0].where;
}

/// A part whose degree no method takes draws nothing, but has rows.
TEST(TrialStudy, LeavesOutWhatTheMethodsDoNotTake) {
  auto study = small_study();
  study.degree = {bezierbench::max_degree + 1};
  const auto job = trial_job<CountedProblem>(study, {1});
  run::run_all(*job);
  EXPECT_TRUE(calls.drawn.empty());
  const auto csv = bundle::parse_csv(run::text_of(*job).at("arc_length.csv"), "arc_length.csv");
  ASSERT_EQ(csv.row_count(), 4U);
  EXPECT_EQ(csv.at(0, "status"), "degree_unsupported");
  EXPECT_EQ(csv.at(0, "broken_promises"), "");
}

TEST(TrialStudy, SaysWhichTrialHasNoCertainTruth) {
  auto study = small_study();
  study.trials = uncertain_trial + 1;
  study.replicates = 1;
  const auto job = trial_job<CountedProblem>(study, {1});
  EXPECT_NO_THROW((void)job->run_block(249));
  try {
    (void)job->run_block(250);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::usage);
    EXPECT_NE(std::string(failure.what()).find("trial 1000"), std::string::npos) << failure.what();
  }
}

/// Runs in a child process, since an interruption cannot be undone.
TEST(TrialStudy, EndsABlockAtTheTrialInWhichItIsInterrupted) {
  const auto job = trial_job<CountedProblem>(small_study(), {1});
  calls.interrupted_at = 1;
  const pid_t child = fork();
  if (child == 0) {
    alarm(10);
    run::watch_for_interruption();
    run::work_begins("b: interrupted");
    (void)job->run_block(0);
    _exit(calls.drawn == first_trials(2) ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

/// The race draws the same trials and uses the same functions to solve and judge them.
TEST(TrialStudy, ItsProblemIsTimedAsItStands) {
  auto study = small_study();
  study.kind = &kind("timing");
  study.modes = {suite::Mode::one_shot};
  constexpr auto timed = race::timed_companion<CountedProblem>();
  const auto races = timed.races(study);
  ASSERT_EQ(races.size(), 2U * 2);
  std::shared_ptr<const void> trials;
  const auto judged = timed.rivals(races.front(), study, 1, trials);
  EXPECT_EQ(calls.drawn, first_trials(3));
  (void)timed.rivals(races.front(), study, 1, trials);
  EXPECT_EQ(calls.drawn, first_trials(3)) << "another repetition draws no trial again";
  ASSERT_EQ(judged.rivals.size(), 2U);
  EXPECT_TRUE(judged.judged[0].right);
  EXPECT_FALSE(judged.rivals[0].check()) << "nothing ran yet";
  judged.rivals[0].run();
  EXPECT_TRUE(judged.rivals[0].check());
}

}  // namespace
}  // namespace bezierbench::studies
