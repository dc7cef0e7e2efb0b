// SPDX-License-Identifier: MIT
// A method from outside: code or answers that are no part of this program, or that were compiled into a user's own
// program. It is asked in a child process, a batch at a time.
#pragma once

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/outside/batch.hpp"
#include "experiments/outside/child.hpp"
#include "experiments/suite/outside.hpp"

namespace bezierbench::outside {

class Method {
 public:
  Method() = default;
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;
  Method(Method&&) = delete;
  Method& operator=(Method&&) = delete;
  virtual ~Method() = default;

  /// What a bundle says of it.
  [[nodiscard]] virtual const suite::OutsideMethod& record() const = 0;
  /// The points of a batch. Safe to call from several threads.
  [[nodiscard]] virtual Answer points(const Batch& batch) const = 0;
  /// For times: whether open_kernel() has a kernel.
  [[nodiscard]] virtual bool has_kernel() const { return false; }
  /// The functions of a method that is code in this process, to be asked for and called in a child process only, and
  /// there of one method only. Null where it cannot be loaded.
  [[nodiscard]] virtual const Kernel<double>* open_kernel(int /*dimension*/) const { return nullptr; }
  /// The limits of each of its processes.
  [[nodiscard]] virtual Limits limits() const { return {}; }
};

/// The methods of one run, in the order in which they were given.
using Methods = std::vector<std::shared_ptr<const Method>>;

/// The method with this id; null where there is none.
inline const Method* find(const Methods& methods, std::string_view id) {
  const auto found =
      std::ranges::find(methods, id, [](const auto& method) -> std::string_view { return method->record().id; });
  return found == methods.end() ? nullptr : found->get();
}

}  // namespace bezierbench::outside
