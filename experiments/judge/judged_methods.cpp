// SPDX-License-Identifier: MIT
#include "experiments/judge/judged_methods.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "core/bound/amplification.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::judge {

namespace {

constexpr std::string_view exact_baseline = "exact";

}  // namespace

template <class Scalar>
JudgedMethods<Scalar>::JudgedMethods(const suite::Study& study, const sample::Cell& cell) : degree_(cell.degree) {
  for (const auto* method : chosen_kernels<Scalar>(study, cell)) add(*method);
  add_baselines(study, cell);
}

template <class Scalar>
JudgedMethods<Scalar>::JudgedMethods(const suite::Study& study, const sample::Cell& cell, const Kernel<Scalar>& method)
    : degree_(cell.degree) {
  add(method);
  add_baselines(study, cell);
}

template <class Scalar>
void JudgedMethods<Scalar>::add(const Kernel<Scalar>& method) {
  methods_.emplace_back(method);
  bounds_.emplace_back();
  if (!method.info->bound) return;
  bounds_.back().emplace(*method.info->bound, degree_, ScalarFacts<Scalar>::arithmetic);
  amplifications_.insert(method.info->bound->amplification);
  if (const auto* local = method.info->bound->of_local) amplifications_.insert(local->amplification);
}

template <class Scalar>
void JudgedMethods<Scalar>::add_baselines(const suite::Study& study, const sample::Cell& cell) {
  amplifications_.insert(p_tilde_of(study.form));
  for (std::size_t k = 0; k < study.baseline.size(); ++k) {
    const std::string& id = study.baseline[k];
    const Kernel<Scalar>* kernel = nullptr;
    if (id != exact_baseline) {
      kernel = find_method<Scalar>(id, study.form, cell.dimension);
      if (kernel == nullptr)
        suite::refuse(study, {"baseline", k, "curve",
                              fmt::format("baseline \"{}\" does not take curves in {} form; see `list methods`", id,
                                          name(study.form))});
      if (!takes(*kernel->info, cell.t_interval))
        suite::refuse(study, {"baseline", k, "t_interval", fmt::format("baseline \"{}\" takes t in [0,1] only", id)});
    }
    baselines_.emplace_back();
    if (kernel != nullptr) baselines_.back().emplace(*kernel);
  }
}

template class JudgedMethods<float>;
template class JudgedMethods<double>;

namespace {

const batch::Target* best_target() {
  static const auto usable = batch::usable_targets();
  return usable.empty() ? nullptr : usable.front();
}

}  // namespace

template <class Scalar>
GroupMethod<Scalar>::GroupMethod(const Kernel<Scalar>& method) : kernel(&method), evaluator(&method) {
  if (const auto* target = best_target()) side_by_side = batch::find_group(*target, method);
  if (method.conversion == nullptr) return;
  if (const auto* alone = find_kernel<Scalar>(method.evaluator->id, method.evaluated_form, method.dimension))
    evaluator = alone;
}

template <class Scalar>
void GroupPoints<Scalar>::add(const CurveView<Scalar>& curve, Scalar t) {
  for (std::size_t i = 0; i < curve.coefficients.size(); ++i)
    given_[i * trials_at_once + count_] = curve.coefficients[i];
  t_[count_] = t;
  curves_[count_++] = curve;
}

template <class Scalar>
void GroupPoints<Scalar>::evaluate(const GroupMethod<Scalar>& method, PointsOfGroup& points) {
  if (method.side_by_side.evaluate == nullptr || !fits_in_groups()) return evaluate_one_by_one(method, points);
  std::array<Scalar, reference::max_dimension * trials_at_once> computed;
  method.side_by_side.evaluate(degree_, evaluated_coefficients(method).data(), t_.data(), computed.data());
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
    for (std::size_t k = 0; k < trials_at_once; ++k)
      points[axis][k] = static_cast<double>(computed[axis * trials_at_once + k]);
}

template <class Scalar>
const std::vector<Scalar>& GroupPoints<Scalar>::evaluated_coefficients(const GroupMethod<Scalar>& method) {
  const Kernel<Scalar>& kernel = *method.kernel;
  if (kernel.conversion == nullptr) return given_;
  if (kernel.conversion == conversion_) return converted_;
  conversion_ = kernel.conversion;
  if (method.side_by_side.convert != nullptr && fits_in_groups()) {
    converted_.resize(given_.size());
    method.side_by_side.convert(degree_, given_.data(), converted_.data());
    return converted_;
  }
  for (std::size_t k = 0; k < count_; ++k) {
    kernel.converted(curves_[k], one_);
    converted_.resize(one_.size() * trials_at_once);
    for (std::size_t i = 0; i < one_.size(); ++i) converted_[i * trials_at_once + k] = one_[i];
  }
  return converted_;
}

template <class Scalar>
void GroupPoints<Scalar>::evaluate_one_by_one(const GroupMethod<Scalar>& method, PointsOfGroup& points) {
  const auto d = static_cast<std::size_t>(dimension_);
  const bool converted = method.evaluator != method.kernel;
  const auto& coefficients = converted ? evaluated_coefficients(method) : given_;
  for (std::size_t k = 0; k < count_; ++k) {
    CurveView<Scalar> curve = curves_[k];
    if (converted) {
      one_.resize(curve.coefficients.size());
      for (std::size_t i = 0; i < one_.size(); ++i) one_[i] = coefficients[i * trials_at_once + k];
      curve = {method.kernel->evaluated_form, curve.dimension, curve.degree, one_};
    }
    std::array<Scalar, reference::max_dimension> point{};
    PreparedState<Scalar>(*method.evaluator, curve).evaluate({&t_[k], 1}, point.data());
    for (std::size_t axis = 0; axis < d; ++axis) points[axis][k] = static_cast<double>(point[axis]);
  }
}

template <class Scalar>
void GroupPoints<Scalar>::check_first(const GroupMethod<Scalar>& method, const PointsOfGroup& points) {
  const auto d = static_cast<std::size_t>(dimension_);
  std::array<Scalar, reference::max_dimension> point{};
  PreparedState<Scalar>(*method.kernel, curves_[0]).evaluate({t_.data(), 1}, point.data());
  for (std::size_t axis = 0; axis < d; ++axis) {
    const auto right = static_cast<double>(point[axis]);
    const double ours = points[axis][0];
    const bool same = std::isnan(right) ? std::isnan(ours)
                                        : std::bit_cast<std::uint64_t>(ours) == std::bit_cast<std::uint64_t>(right);
    if (!same)
      throw std::logic_error(fmt::format("{}: many curves at once give {}, one curve {}; run the tests of core/batch",
                                         method.kernel->info->id, ours, right));
  }
}

template struct GroupMethod<float>;
template struct GroupMethod<double>;
template class GroupPoints<float>;
template class GroupPoints<double>;

}  // namespace bezierbench::judge
