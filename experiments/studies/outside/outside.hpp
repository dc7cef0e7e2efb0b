// SPDX-License-Identifier: MIT
// The work of accuracy and timing studies on a method from outside. Its inputs are those of the study, so its rows stand
// beside those of our own methods; no other row depends on it.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>

#include "experiments/outside/method.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/outside.hpp"

namespace bezierbench::studies {

/// Why a study asks nothing of the method, a sentence about the study; empty where it asks it.
[[nodiscard]] std::string why_unasked(const suite::Study& study, const suite::OutsideMethod& record);

/// Null where the study asks nothing of the method. `at_hand` may be null where the job
/// is not to be run; else it must outlive the job and be the method of the record.
std::unique_ptr<run::Job> outside_job(const suite::Study& study, const suite::OutsideMethod& record,
                                      const outside::Method* at_hand, const run::JobContext& context);

// The two jobs behind outside_job().

/// A method from outside in a job: what describes it, and the method itself where it is at hand.
class JudgedOutside {
 public:
  /// `form` is that of the curves; a file of answers may be for several.
  JudgedOutside(suite::OutsideMethod record, Form form, const outside::Method* at_hand);
  JudgedOutside(const JudgedOutside&) = delete;
  JudgedOutside& operator=(const JudgedOutside&) = delete;

  [[nodiscard]] const MethodInfo& info() const { return info_; }
  /// A kernel that describes the method and cannot be called.
  [[nodiscard]] const Kernel<double>& described(int dimension) const {
    return described_[static_cast<std::size_t>(dimension) - 1];
  }
  /// Throws std::logic_error where it is not at hand.
  [[nodiscard]] const outside::Method& method() const;
  /// Tells the user about the first failure in this job.
  void tell(const suite::Study& study, const outside::Answer& answer) const;

 private:
  suite::OutsideMethod record_;
  const outside::Method* at_hand_;
  MethodInfo info_;  ///< refers to the record
  std::array<Kernel<double>, 3> described_;
  mutable std::atomic_flag told_;
};

std::unique_ptr<run::Job> outside_accuracy_job(const suite::Study& study, const suite::OutsideMethod& record,
                                               const outside::Method* at_hand, const run::JobContext& context);
std::unique_ptr<run::Job> outside_timing_job(const suite::Study& study, const suite::OutsideMethod& record,
                                             const outside::Method* at_hand, const run::JobContext& context);

}  // namespace bezierbench::studies
