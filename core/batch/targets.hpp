// SPDX-License-Identifier: MIT
// The targets that this program was built for, whether or not this processor has them.
#pragma once

#include "core/batch/operation_work.hpp"
#include "core/batch/target_table.hpp"

namespace bezierbench::batch {

/// Each is defined in a translation unit of its own, compiled for its target; nothing else in that may be called on a
/// lesser processor.
template <class Scalar>
struct Tables {
  static const TargetTable<Scalar> avx512;
  static const TargetTable<Scalar> avx2;
  static const TargetTable<Scalar> neon;
  static const WorksOfWidths<Scalar> avx512_works;
  static const WorksOfWidths<Scalar> avx2_works;
  static const WorksOfWidths<Scalar> neon_works;
};

// Specialised there, so there is no definition to instantiate elsewhere.
template <>
const TargetTable<float> Tables<float>::avx512;
template <>
const TargetTable<double> Tables<double>::avx512;
template <>
const TargetTable<float> Tables<float>::avx2;
template <>
const TargetTable<double> Tables<double>::avx2;
template <>
const TargetTable<float> Tables<float>::neon;
template <>
const TargetTable<double> Tables<double>::neon;
template <>
const WorksOfWidths<float> Tables<float>::avx512_works;
template <>
const WorksOfWidths<double> Tables<double>::avx512_works;
template <>
const WorksOfWidths<float> Tables<float>::avx2_works;
template <>
const WorksOfWidths<double> Tables<double>::avx2_works;
template <>
const WorksOfWidths<float> Tables<float>::neon_works;
template <>
const WorksOfWidths<double> Tables<double>::neon_works;

}  // namespace bezierbench::batch
