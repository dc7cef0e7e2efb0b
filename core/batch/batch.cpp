// SPDX-License-Identifier: MIT
#include "core/batch/batch.hpp"

#include <hwy/targets.h>

#include <array>
#include <type_traits>

#include "core/batch/roster.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch {
namespace {

#if HWY_ARCH_X86
constexpr std::array all_targets{Target{"AVX-512", HWY_AVX3, &Tables<float>::avx512, &Tables<double>::avx512,
                                        &Tables<float>::avx512_works, &Tables<double>::avx512_works},
                                 Target{"AVX2", HWY_AVX2, &Tables<float>::avx2, &Tables<double>::avx2,
                                        &Tables<float>::avx2_works, &Tables<double>::avx2_works}};
#elif HWY_ARCH_ARM_A64
constexpr std::array all_targets{Target{"NEON", HWY_NEON, &Tables<float>::neon, &Tables<double>::neon,
                                        &Tables<float>::neon_works, &Tables<double>::neon_works}};
#else
constexpr std::array<Target, 0> all_targets{};
#endif

/// An evaluator of the roster, and for each dimension the function that reads its prepared state.
template <class Scalar>
struct Known {
  const MethodInfo* evaluator;
  std::array<Parts<Scalar> (*)(const void* prepared), max_dimension> parts;
};

template <class Scalar, class Prepared>
Parts<Scalar> parts_of(const void* prepared) {
  const auto& state = *static_cast<const Prepared*>(prepared);
  if constexpr (requires { state.rounding; })
    return {state.scaled.degree(), state.scaled.data(), state.lost.data(), state.given.data(), state.rounding.data()};
  else if constexpr (requires { state.high; })
    return {state.degree(), state.high.data(), state.low.data()};
  else if constexpr (requires { state.lost; })
    return {state.scaled.degree(), state.scaled.data(), state.lost.data()};
  else if constexpr (requires { state.scaled; })
    return {state.scaled.degree(), state.scaled.data(), nullptr};
  else
    return {state.degree(), state.data(), nullptr};
}

template <class Scalar, class Entry>
constexpr Known<Scalar> known() {
  using E = typename Entry::Evaluator;
  static_assert(std::is_same_v<PreparedOf<E, Scalar, 2>, typename Entry::State::template Prepared<Scalar, 2, dynamic>>);
  return {&E::info,
          {parts_of<Scalar, PreparedOf<E, Scalar, 1>>, parts_of<Scalar, PreparedOf<E, Scalar, 2>>,
           parts_of<Scalar, PreparedOf<E, Scalar, 3>>}};
}

template <class Scalar, class... Plain, class... WithFma>
std::span<const Known<Scalar>> all_known(TypeList<Plain...> /*unfused*/, TypeList<WithFma...> /*fused*/) {
  static constexpr std::array table{known<Scalar, Plain>()..., known<Scalar, WithFma>()...};
  return table;
}

}  // namespace

std::span<const Target> built_targets() { return all_targets; }

bool is_usable(const Target& target) { return (hwy::SupportedTargets() & target.highway) != 0; }

std::vector<const Target*> usable_targets() {
  std::vector<const Target*> usable;
  for (const auto& target : built_targets())
    if (is_usable(target)) usable.push_back(&target);
  return usable;
}

template <class Scalar>
const TargetTable<Scalar>& table_of(const Target& target) {
  if constexpr (std::is_same_v<Scalar, float>)
    return *target.float_table;
  else
    return *target.double_table;
}

template const TargetTable<float>& table_of<float>(const Target&);
template const TargetTable<double>& table_of<double>(const Target&);

template <class Scalar>
WorksOfWidths<Scalar> works_of(const Target& target) {
  if constexpr (std::is_same_v<Scalar, float>)
    return *target.float_works;
  else
    return *target.double_works;
}

template WorksOfWidths<float> works_of<float>(const Target&);
template WorksOfWidths<double> works_of<double>(const Target&);

template <class Scalar>
BatchKernel<Scalar> find(const Target& target, const Kernel<Scalar>& kernel) {
  const auto all = all_known<Scalar>(Unfused{}, Fused{});
  const auto& table = table_of<Scalar>(target);
  const auto dimension = static_cast<std::size_t>(kernel.dimension) - 1;
  for (std::size_t k = 0; k < table.count; ++k)
    if (all[k].evaluator == kernel.evaluator)
      return {all[k].parts[dimension], table.kernels[k].of_dimension[dimension]};
  return {};
}

template BatchKernel<float> find(const Target&, const Kernel<float>&);
template BatchKernel<double> find(const Target&, const Kernel<double>&);

template <class Scalar>
GroupKernel<Scalar> find_group(const Target& target, const Kernel<Scalar>& kernel) {
  const auto evaluators = infos_of(typename Concatenated<UnfusedOfGroups, FusedOfGroups>::Type());
  const auto conversions = infos_of(ConversionsOfGroups());
  const auto& table = table_of<Scalar>(target).group;
  const auto dimension = static_cast<std::size_t>(kernel.dimension) - 1;
  GroupKernel<Scalar> found;
  for (std::size_t k = 0; k < table.evaluator_count; ++k)
    if (evaluators[k] == kernel.evaluator) found.evaluate = table.evaluators[k].of_dimension[dimension];
  for (std::size_t k = 0; k < conversions.size(); ++k)
    if (conversions[k] == kernel.conversion) found.convert = table.conversions[k].of_dimension[dimension];
  return found;
}

template GroupKernel<float> find_group(const Target&, const Kernel<float>&);
template GroupKernel<double> find_group(const Target&, const Kernel<double>&);

}  // namespace bezierbench::batch
