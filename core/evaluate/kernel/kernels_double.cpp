// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/instantiate.hpp"

namespace bezierbench {

template std::span<const Kernel<double>> kernels<double>(int dimension);
template std::span<const ConversionKernel<double>> conversion_kernels<double>(int dimension);

std::span<const MethodInfo* const> conversion_infos() { return infos_of(Conversions{}); }

}  // namespace bezierbench
