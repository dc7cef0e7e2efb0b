// SPDX-License-Identifier: MIT
#include "core/easing/kernel.hpp"

#include <array>

#include "core/easing/roster.hpp"

namespace bezierbench {
namespace {

template <EasingMethod M, class Scalar>
void ease_each(const EasingCurve<Scalar>& curve, std::span<const Scalar> x, Eased<Scalar>* answers) {
  const auto prepared = M::prepare(curve);
  const EndSlopes<Scalar> slopes(curve);
  for (std::size_t k = 0; k < x.size(); ++k) answers[k] = ease<M>(prepared, slopes, x[k]);
}

template <class... Methods>
constexpr auto kernels_of_roster(TypeList<Methods...> /*roster*/) {
  return std::array{EasingKernel{&Methods::info, requires {Methods::is_correctly_rounded;
}
, ease_each<Methods, double>, ease_each<Methods, float>
}  // namespace
...
};  // namespace bezierbench
}

}  // namespace

std::span<const EasingKernel> easing_kernels() {
  static constexpr auto kernels = kernels_of_roster(EasingMethods{});
  return kernels;
}

}  // namespace bezierbench
