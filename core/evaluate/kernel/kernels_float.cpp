// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/instantiate.hpp"

namespace bezierbench {

template std::span<const Kernel<float>> kernels<float>(int dimension);
template std::span<const ConversionKernel<float>> conversion_kernels<float>(int dimension);

}  // namespace bezierbench
