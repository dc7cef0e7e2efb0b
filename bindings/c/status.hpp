// SPDX-License-Identifier: MIT
// What every function of the C interface does around its work: checks the floating-point environment, and turns
// refusals and exceptions into a bb_status.
#pragma once

#include <cfenv>
#include <concepts>

#include "bindings/c/include/bezierbench/bezierbench.h"
#include "reference/stop.hpp"

namespace bezierbench::c {

/// Ends a call with this status.
struct Refused {
  bb_status status;
};

/// Throws Refused(status) unless `holds`.
inline void require(bool holds, bb_status status) {
  if (!holds) throw Refused{status};
}

/// Throws Refused(BB_ERROR_NULL) if one of the pointers is null.
template <class... Pointers>
void require_pointers(const Pointers*... pointers) {
  require((... && (pointers != nullptr)), BB_ERROR_NULL);
}

/// Keeps floating-point exceptions of the library from the caller: no trap is taken, and the flags are as before.
class QuietExceptions {
 public:
  QuietExceptions();
  QuietExceptions(const QuietExceptions&) = delete;
  QuietExceptions& operator=(const QuietExceptions&) = delete;
  ~QuietExceptions();

 private:
  std::fenv_t caller_{};
#ifdef __SSE2__
  unsigned sse_;  ///< control and flags
  int flags_;
  bool has_traps_;
#endif
};

/// The status of the exception that is being handled.
bb_status status_of_exception() noexcept;

/// Whether this thread computes in IEEE 754 arithmetic to nearest.
bool computes_in_ieee_754();

/// Whether the flag of bb_stop_when() is set.
bool is_stopped();

/// Does `work` and returns BB_OK, or what kept it from being done.
template <std::invocable Work>
int guarded(const Work& work) noexcept {
  const QuietExceptions quiet;
  try {
    const reference::StopWhen stop(is_stopped);
    require(computes_in_ieee_754(), BB_ERROR_ENVIRONMENT);
    work();
    return BB_OK;
  } catch (...) {
    return status_of_exception();
  }
}

}  // namespace bezierbench::c
