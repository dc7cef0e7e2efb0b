// SPDX-License-Identifier: MIT
// The list of methods.
#include <deque>
#include <string>
#include <vector>

#include "bindings/c/curve.hpp"
#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "core/bounds/kernel.hpp"
#include "core/bspline/kernel.hpp"
#include "core/derivative/kernel.hpp"
#include "core/easing/kernel.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/fit/kernel.hpp"
#include "core/flatten/kernel.hpp"
#include "core/grid/kernel.hpp"
#include "core/project/kernel.hpp"
#include "core/subdivide/kernel.hpp"

using namespace bezierbench;

namespace {

/// The entries of the list, and what their strings point to: the views in MethodInfo need not end in a zero.
class Methods {
 public:
  Methods() {
    const auto add_all = [this](const auto& all) {
      for (const auto& kernel : all) add(*kernel.info);
    };
    add_all(kernels<double>(1));
    add_all(derivative_kernels(1));
    add_all(grid_kernels(1));
    add_all(split_kernels(1));
    add_all(bounds_kernels(1));
    add_all(arc_length_kernels(1));
    add_all(inverse_arc_length_kernels(1));
    add_all(projection_kernels(1));
    add_all(fitting_kernels(1));
    add_all(flatten_kernels(1));
    add_all(easing_kernels());
    add_all(bspline_kernels(1));
  }

  [[nodiscard]] const std::vector<bb_method>& entries() const { return entries_; }

 private:
  void add(const MethodInfo& info) {
    entries_.push_back({kept(info.id), kept(info.label), kept(name(info.problem)),
                        kept(info.bound ? info.bound->text : ""), kept(info.flops), kept(info.citation),
                        c::form_of(info.form), info.min_degree, info.max_degree, info.max_degree_float,
                        info.unit_interval_only ? 1 : 0, info.bit_stable ? 1 : 0});
  }
  const char* kept(std::string_view text) { return texts_.emplace_back(text).c_str(); }

  std::vector<bb_method> entries_;
  std::deque<std::string> texts_;  // its elements do not move
};

const std::vector<bb_method>& methods() {
  static const Methods all;
  return all.entries();
}

}  // namespace

std::size_t bb_method_count() {
  try {
    return methods().size();
  } catch (...) {  // no memory for the list
    return 0;
  }
}

int bb_method_at(std::size_t index, bb_method* method) {
  return c::guarded([&] {
    c::require_pointers(method);
    c::require(index < methods().size(), BB_ERROR_COUNT);
    *method = methods()[index];
  });
}
