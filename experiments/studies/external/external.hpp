// SPDX-License-Identifier: MIT
// The jobs of accuracy and timing studies for an external method. Its inputs are those of the study, so its rows can be
// compared with those of our methods; no other row depends on it.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <tuple>

#include "experiments/external/method.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/external.hpp"

namespace bezierbench::studies {

/// Why a study does not use the method, a sentence about the study; empty where it does.
[[nodiscard]] std::string why_unasked(const suite::Study& study, const suite::ExternalMethod& record);

/// Null where the study does not use the method. `given` is the method of the record and must outlive the job; it may be
/// null where the job will not run.
std::unique_ptr<run::Job> external_job(const suite::Study& study, const suite::ExternalMethod& record,
                                       const external::Method* given, const run::JobContext& context);

// The two jobs behind external_job().

/// An external method in a job: its description, and the method itself where it was given.
class JudgedExternal {
 public:
  /// `form` is that of the curves; a file of answers may be for several.
  JudgedExternal(suite::ExternalMethod record, Form form, const external::Method* given);
  JudgedExternal(const JudgedExternal&) = delete;
  JudgedExternal& operator=(const JudgedExternal&) = delete;

  [[nodiscard]] const MethodInfo& info() const { return info_; }
  [[nodiscard]] bool answers_in(suite::ScalarKind scalar) const {
    return std::ranges::count(record_.scalars, scalar) > 0;
  }
  /// A kernel that only describes the method: its functions are null.
  template <class Scalar>
  [[nodiscard]] const Kernel<Scalar>& described(int dimension) const {
    return std::get<Described<Scalar>>(described_)[static_cast<std::size_t>(dimension) - 1];
  }
  /// Throws std::logic_error where it was not given.
  [[nodiscard]] const external::Method& method() const;
  /// The answer to a batch of a part of the job; without numbers where the method fails, where it took too long for another
  /// batch of this part, and in an interrupted run.
  [[nodiscard]] external::Answer ask(const suite::Study& study, std::size_t part, const external::Batch& batch) const;
  /// Reports the first failure of this job on standard error.
  void report(const suite::Study& study, const external::Answer& answer) const;

 private:
  template <class Scalar>
  using Described = std::array<Kernel<Scalar>, 3>;

  suite::ExternalMethod record_;
  const external::Method* given_;
  MethodInfo info_;  ///< refers to the record
  std::tuple<Described<float>, Described<double>> described_;
  mutable std::atomic_flag reported_;
  mutable std::mutex mutex_;
  mutable std::set<std::size_t> late_;  ///< parts in which a batch took too long
};

std::unique_ptr<run::Job> external_accuracy_job(const suite::Study& study, const suite::ExternalMethod& record,
                                                const external::Method* given, const run::JobContext& context);
std::unique_ptr<run::Job> external_timing_job(const suite::Study& study, const suite::ExternalMethod& record,
                                              const external::Method* given, const run::JobContext& context);

}  // namespace bezierbench::studies
