// SPDX-License-Identifier: MIT
#include "experiments/requirements/requirements.hpp"

#include "experiments/requirements/bounds.hpp"
#include "experiments/requirements/relations.hpp"

namespace bezierbench::requirements {
namespace {

bool any(const MethodInfo& /*info*/) { return true; }
bool is_bounded(const MethodInfo& info) { return info.bound.has_value(); }
bool is_bernstein(const MethodInfo& info) { return info.form == Form::bernstein; }  // power form has no mirror image
bool is_stable(const MethodInfo& info) { return info.bit_stable; }                  // other bits belong to libm
bool is_native_and_bounded(const MethodInfo& info) {
  return is_bernstein(info) && is_bounded(info) && info.id.find(':') == std::string_view::npos;
}

constexpr std::array<Property, 13> all{{
    {"bound", "no error is beyond the bound that the method states", is_bounded, keeps_its_bound},
    {"bound_in_float", "nor is any in float", is_bounded, keeps_its_bound_in_float},
    {"bound_underflow", "nor where whole curves or their errors are subnormal", is_bounded,
     keeps_its_bound_where_it_underflows},
    {"bound_overflow", "nor, in double and float, where results come near overflow or beyond", is_bounded,
     keeps_its_bound_up_to_overflow},
    {"largest_degree", "at its largest degrees, in double and float, coordinates of at most 1 give numbers", any,
     works_up_to_its_largest_degree},
    {"mild_curves", "errors are small on curves of low degree in [-1, 1], t in [0, 1]", any, is_right_on_mild_curves},
    {"constants", "a curve whose points are all the same is that point, to rounding", any, reproduces_constants},
    {"affine_maps", "an affine map of the curve maps its points, to rounding", any, is_affinely_invariant},
    {"reversal", "control points in reverse give the same curve from its other end, to rounding", is_bernstein,
     reverses_with_its_control_points},
    {"powers_of_two", "a power of two as factor changes no other bit", is_stable, scales_with_powers_of_two},
    {"axes", "each axis is evaluated as if it were alone, bit for bit", any, treats_axes_alike},
    {"batches", "many t at once give the bits of one at a time", any, gives_the_same_in_batches},
    {"end_points", "t = 0 and t = 1 give the first and the last control point exactly", is_native_and_bounded,
     interpolates_end_points},
}};

}  // namespace

std::vector<Evaluator> evaluators() {
  std::vector<Evaluator> methods;
  for (std::size_t place = 0; place < kernels<double>(2).size(); ++place)
    methods.push_back({{&kernels<double>(1)[place], &kernels<double>(2)[place], &kernels<double>(3)[place]},
                       &kernels<float>(2)[place]});
  return methods;
}

std::span<const Property> properties() { return all; }

}  // namespace bezierbench::requirements
