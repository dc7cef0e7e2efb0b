// SPDX-License-Identifier: MIT
// The methods that a cell of an accuracy study judges, each measured from every baseline.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "experiments/judge/group_points.hpp"
#include "experiments/sample/cell.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::judge {

template <class Scalar>
class JudgedMethods {
 public:
  /// Throws Failure(usage) for methods and baselines that do not take the study's curves.
  JudgedMethods(const suite::Study& study, const sample::Cell& cell);
  /// One method only, which need not be in the roster; the kernel must outlive the object.
  JudgedMethods(const suite::Study& study, const sample::Cell& cell, const Kernel<Scalar>& method);

  [[nodiscard]] std::size_t count() const { return methods_.size(); }
  [[nodiscard]] std::size_t baseline_count() const { return baselines_.size(); }
  [[nodiscard]] const GroupMethod<Scalar>& operator[](std::size_t method) const { return methods_[method]; }
  [[nodiscard]] const MethodInfo& info(std::size_t method) const { return *methods_[method].kernel->info; }
  [[nodiscard]] const std::optional<reference::BoundAtDegree>& bound(std::size_t method) const {
    return bounds_[method];
  }
  /// Empty for the exact reference.
  [[nodiscard]] const std::optional<GroupMethod<Scalar>>& baseline(std::size_t baseline) const {
    return baselines_[baseline];
  }
  /// The amplifications that the bounds multiply, and that of p~.
  [[nodiscard]] const std::set<Amplification>& amplifications() const { return amplifications_; }

  /// Judgements are method by method, baseline by baseline.
  [[nodiscard]] std::size_t judgement_count() const { return count() * baseline_count(); }
  [[nodiscard]] std::size_t index(std::size_t method, std::size_t baseline) const {
    return method * baseline_count() + baseline;
  }
  [[nodiscard]] bool supported(const GroupMethod<Scalar>& method) const {
    return method.kernel->info->template supports<Scalar>(degree_);
  }
  [[nodiscard]] bool is_exact(std::size_t baseline) const { return !baselines_[baseline]; }
  [[nodiscard]] bool is_baseline(std::size_t method, std::size_t baseline) const {
    return baselines_[baseline] && baselines_[baseline]->kernel == methods_[method].kernel;
  }
  /// A method is not measured against itself.
  [[nodiscard]] bool judged(std::size_t method, std::size_t baseline) const {
    return !is_baseline(method, baseline) && supported(methods_[method]) &&
           (is_exact(baseline) || supported(*baselines_[baseline]));
  }
  [[nodiscard]] bool is_stable(std::size_t method, std::size_t baseline) const {
    return info(method).bit_stable && (is_exact(baseline) || baselines_[baseline]->kernel->info->bit_stable);
  }

 private:
  void add(const Kernel<Scalar>& method);
  void add_baselines(const suite::Study& study, const sample::Cell& cell);

  int degree_;
  std::vector<GroupMethod<Scalar>> methods_;
  std::vector<std::optional<reference::BoundAtDegree>> bounds_;
  std::set<Amplification> amplifications_;
  std::vector<std::optional<GroupMethod<Scalar>>> baselines_;
};

}  // namespace bezierbench::judge
