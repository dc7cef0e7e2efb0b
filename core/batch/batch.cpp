// SPDX-License-Identifier: MIT
#include "core/batch/batch.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/batch/roster.hpp"
#include "core/batch/targets.hpp"
#include "core/evaluate/kernel/parts.hpp"

namespace bezierbench::batch {
namespace {

template <class Name>
constexpr Target target_of(std::string_view name, bool (*is_usable)()) {
  return {name,
          is_usable,
          &TableOf<Name, float>::table,
          &TableOf<Name, double>::table,
          &WorksOf<Name, float>::table,
          &WorksOf<Name, double>::table};
}

// The compiler's builtin says what the processor has. Highway's library could say it as well, but it executes `rdtscp`
// when it is loaded, and Valgrind stops there on a virtual machine that hides this instruction.
#if defined(__x86_64__)
/// A processor with these features has all of x86-64-v3, a name that Clang 14 does not know here.
bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("aes") && __builtin_cpu_supports("pclmul");
}

bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

constexpr std::array all_targets{target_of<Avx512>("AVX-512", has_avx512), target_of<Avx2>("AVX2", has_avx2)};
#elif defined(__aarch64__)
constexpr std::array all_targets{target_of<Neon>("NEON", [] { return true; })};
#else
constexpr std::array<Target, 0> all_targets{};
#endif

/// Points of rational curves whose homogeneous coordinates lie between two steps, in the first cache.
constexpr std::size_t points_between = 128;

using ReadParts = Parts (*)(const void* prepared);

template <class State>
Parts read_parts(const void* prepared) {
  return parts_of(*static_cast<const State*>(prepared));
}

/// An evaluator with batch kernels. parts[d - 1] turns a prepared state of d axes into plain arrays.
struct Known {
  const MethodInfo* evaluator;
  const MethodInfo* rational;  ///< the same evaluator for rational curves; null where there is none
  std::array<ReadParts, max_dimension + 1> parts;
};

template <class Scalar, class E>
constexpr Known known() {
  Known result{&E::info,
               nullptr,
               {read_parts<PreparedOf<E, Scalar, 1>>, read_parts<PreparedOf<E, Scalar, 2>>,
                read_parts<PreparedOf<E, Scalar, 3>>, nullptr}};
  if constexpr (takes_rational<E>) {
    result.rational = &Homogeneous<E>::info;
    result.parts[max_dimension] = read_parts<PreparedOf<E, Scalar, max_dimension + 1>>;
  }
  return result;
}

template <class Scalar, class... Es>
std::span<const Known> all_known(TypeList<Es...> /*evaluators*/) {
  static constexpr std::array all{known<Scalar, Es>()...};
  return all;
}

}  // namespace

std::span<const Target> built_targets() { return all_targets; }

std::vector<const Target*> usable_targets() {
  std::vector<const Target*> usable;
  for (const auto& target : built_targets())
    if (target.is_usable()) usable.push_back(&target);
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
void BatchKernel<Scalar>::operator()(const void* prepared, std::span<const Scalar> t, Scalar* points) const {
  const auto state = parts(prepared);
  if (divide == nullptr) return evaluate(state, t.data(), t.size(), points);
  std::array<Scalar, (max_dimension + 1) * points_between> homogeneous;
  for (std::size_t k = 0; k < t.size(); k += points_between) {
    const std::size_t count = std::min(points_between, t.size() - k);
    evaluate(state, t.data() + k, count, homogeneous.data());
    divide(homogeneous.data(), dimension, count, points + k, t.size());
  }
}

template struct BatchKernel<float>;
template struct BatchKernel<double>;

template <class Scalar>
BatchKernel<Scalar> find(const Target& target, const Kernel<Scalar>& kernel) {
  const auto all = all_known<Scalar>(OneCurve());
  const auto& table = table_of<Scalar>(target);
  for (std::size_t place = 0; place < all.size(); ++place) {
    const Known& entry = all[place];
    const bool is_rational = entry.rational != nullptr && entry.rational == kernel.evaluator;
    if (entry.evaluator != kernel.evaluator && !is_rational) continue;
    const TargetKernels<Scalar>* unit = *table.units[place % units];
    const auto dimension = static_cast<std::size_t>(kernel.dimension) - (is_rational ? 0 : 1);
    return {entry.parts[dimension], unit[place / units].by_dimension[dimension], is_rational ? table.divide : nullptr,
            kernel.dimension};
  }
  return {};
}

template BatchKernel<float> find(const Target&, const Kernel<float>&);
template BatchKernel<double> find(const Target&, const Kernel<double>&);

template <class Scalar>
GroupKernel<Scalar> find_group(const Target& target, const Kernel<Scalar>& kernel) {
  const auto evaluators = infos_of(ManyCurves());
  const auto conversions = infos_of(ConversionsOfGroups());
  const auto& table = *table_of<Scalar>(target).group;
  const auto dimension = static_cast<std::size_t>(kernel.dimension) - 1;
  GroupKernel<Scalar> found;
  for (std::size_t k = 0; k < evaluators.size(); ++k)
    if (evaluators[k] == kernel.evaluator) found.evaluate = table.evaluators[k].by_dimension[dimension];
  for (std::size_t k = 0; k < conversions.size(); ++k)
    if (conversions[k] == kernel.conversion) found.convert = table.conversions[k].by_dimension[dimension];
  return found;
}

template GroupKernel<float> find_group(const Target&, const Kernel<float>&);
template GroupKernel<double> find_group(const Target&, const Kernel<double>&);

}  // namespace bezierbench::batch
