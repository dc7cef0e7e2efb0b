// SPDX-License-Identifier: MIT
// One study of a run, as work that can be cut into blocks and rows that can be written when all blocks are done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/number/bytes.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/tables.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::run {

/// What results can contradict: a proved bound of an error, what a method said of its own answer, or a property that
/// is stated as proved.
enum class Broken { bound, promise, proof };

/// Trials with an error beyond a proved bound or a broken promise, or a proof that an input refutes.
struct Violation {
  std::string where;    ///< study, method, cell and trial
  std::uint64_t count;  ///< of trials, or of proofs
  Broken what = Broken::bound;
};

/// The size of a study, known before it runs.
struct Extent {
  std::size_t cells = 0;
  std::size_t rows = 0;           ///< of CSV
  std::uint64_t evaluations = 0;  ///< of methods or conversions

  Extent& operator+=(const Extent& other) {
    cells += other.cells;
    rows += other.rows;
    evaluations += other.evaluations;
    return *this;
  }
};

/// Settings that all studies of a run share.
struct JobContext {
  std::uint64_t seed = 1;
  reference::Tier tier = reference::Tier::exact;
  std::int64_t audited_trials = 200;  ///< of replicate 0 of each cell of an accuracy study, for audit.csv
  std::size_t number = 0;             ///< of the job in its plan
  /// Runs Job::count() of every job in a child under Callgrind, once, and returns the files that it wrote.
  std::function<std::vector<std::string>()> count_jobs = {};
};

/// The result of blocks of one part of a job. The order of merging changes nothing, and bytes keep it between
/// processes.
class Result {
 public:
  Result() = default;
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
  Result(Result&&) = delete;
  Result& operator=(Result&&) = delete;
  virtual ~Result() = default;

  /// `other` is of the same part of the same job, and of other blocks.
  virtual void merge(const Result& other) = 0;
  virtual void save(number::ByteWriter& bytes) const = 0;
};

/// The work is divided into parts (for example cells) of equally many blocks, which are numbered part by part. Blocks
/// are independent of each other; the results of a part's blocks are merged.
class Job {
 public:
  Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  Job(Job&&) = delete;
  Job& operator=(Job&&) = delete;
  virtual ~Job() = default;

  [[nodiscard]] virtual std::size_t parts() const = 0;
  [[nodiscard]] virtual std::size_t blocks_per_part() const { return 1; }
  [[nodiscard]] std::size_t blocks() const { return parts() * blocks_per_part(); }
  [[nodiscard]] std::size_t part_of(std::size_t block) const { return block / blocks_per_part(); }

  /// Runs a block, on any thread unless `exclusive`. If an interruption arrives meanwhile, the result must be
  /// discarded.
  [[nodiscard]] virtual std::unique_ptr<Result> run_block(std::size_t block) const = 0;
  /// Throws number::MalformedBytes for bytes that no result of this kind writes.
  [[nodiscard]] virtual std::unique_ptr<Result> read_result(number::ByteReader& bytes) const = 0;

  /// Counts what the study asks to be counted. Called in a process under Callgrind, whose files are the result.
  virtual void count() const {}

  /// Adds a result to those that write() writes. To be called by one thread at a time.
  void add(std::size_t part, std::unique_ptr<Result> result) {
    if (totals_.empty()) totals_.resize(parts());
    auto& total = totals_[part];
    if (total)
      total->merge(*result);
    else
      total = std::move(result);
  }
  /// The sum of what was added so far; null before the first.
  [[nodiscard]] const Result* total(std::size_t part) const {
    return part < totals_.size() ? totals_[part].get() : nullptr;
  }

  /// Nanoseconds of one thread for a block of this part, to an order of magnitude and equal on every machine. Shards,
  /// the progress line and --dry-run use it.
  [[nodiscard]] virtual double cost(std::size_t part) const = 0;
  [[nodiscard]] double total_cost() const {
    double sum = 0;
    for (std::size_t part = 0; part < parts(); ++part) sum += cost(part) * static_cast<double>(blocks_per_part());
    return sum;
  }
  /// True for timings, beside which nothing else may run.
  [[nodiscard]] virtual bool exclusive() const { return false; }
  /// Whether the work follows from the study. It does not for a search that ends when it has found something; --dry-run
  /// then has no estimate.
  [[nodiscard]] virtual bool is_estimable() const { return true; }
  /// For --dry-run.
  [[nodiscard]] virtual Extent extent() const = 0;

  /// Appends this study's rows. To be called when the results of all blocks were added.
  virtual void write(tables::Tables& tables) const = 0;
  [[nodiscard]] virtual std::vector<tables::Series> series() const { return {}; }
  [[nodiscard]] virtual std::vector<Violation> violations() const { return {}; }

 private:
  std::vector<std::unique_ptr<Result>> totals_;  ///< per part
};

/// A job whose results are values of type State, which number::ByteWriter takes and which has `merge(const State&)`
/// where a part has several blocks.
template <class State>
class JobOf : public Job {
 public:
  [[nodiscard]] std::unique_ptr<Result> run_block(std::size_t block) const final {
    return std::make_unique<Held>(work(block));
  }
  [[nodiscard]] std::unique_ptr<Result> read_result(number::ByteReader& bytes) const final {
    auto result = std::make_unique<Held>(State());
    bytes(result->state);
    return result;
  }

 protected:
  [[nodiscard]] virtual State work(std::size_t block) const = 0;

  /// The merged results of this part.
  [[nodiscard]] const State& state(std::size_t part) const {
    static const State nothing{};
    const auto* result = static_cast<const Held*>(total(part));
    return result == nullptr ? nothing : result->state;
  }

 private:
  struct Held final : Result {
    explicit Held(State value) : state(std::move(value)) {}
    void merge(const Result& other) override {
      if constexpr (requires { state.merge(state); })
        state.merge(static_cast<const Held&>(other).state);
      else
        throw std::logic_error("a part of one block has nothing to merge");
    }
    void save(number::ByteWriter& bytes) const override { bytes(state); }
    State state;
  };
};

/// Runs all blocks, one after the other.
inline void run_all(Job& job) {
  for (std::size_t block = 0; block < job.blocks(); ++block) job.add(job.part_of(block), job.run_block(block));
}

}  // namespace bezierbench::run
