// SPDX-License-Identifier: MIT
#include "bindings/c/status.hpp"

#include "core/api/floating_point_faults.hpp"

namespace bezierbench::c {

namespace {

thread_local const volatile int* stop_flag = nullptr;

}  // namespace

#ifdef __SSE2__
// All of the environment takes 110 ns to save and restore, nearly all of it for the x87, which hardly any function uses. A
// caller without traps gets the flags back instead.
constexpr unsigned no_traps = 0x1F80;
QuietExceptions::QuietExceptions() : sse_(__builtin_ia32_stmxcsr()), flags_(std::fetestexcept(FE_ALL_EXCEPT)) {
  has_traps_ = fegetexcept() != 0 || (sse_ & no_traps) != no_traps;
  if (has_traps_) std::feholdexcept(&caller_);
}
QuietExceptions::~QuietExceptions() {
  if (has_traps_) {
    std::fesetenv(&caller_);
  } else {
    __builtin_ia32_ldmxcsr(sse_);
    if (const int raised = std::fetestexcept(FE_ALL_EXCEPT) & ~flags_; raised != 0) std::feclearexcept(raised);
  }
}
#else
QuietExceptions::QuietExceptions() { std::feholdexcept(&caller_); }
QuietExceptions::~QuietExceptions() { std::fesetenv(&caller_); }
#endif

bool is_stopped() { return stop_flag != nullptr && __atomic_load_n(stop_flag, __ATOMIC_RELAXED) != 0; }

bool computes_in_ieee_754() { return floating_point_faults().empty(); }

}  // namespace bezierbench::c

void bb_stop_when(const volatile int* flag) { bezierbench::c::stop_flag = flag; }

unsigned bb_version() { return BEZIERBENCH_VERSION_NUMBER; }

const char* bb_strerror(int status) {
  switch (status) {
    case BB_OK: return "success";
    case BB_ERROR_NULL: return "a pointer is null";
    case BB_ERROR_METHOD: return "no method for this problem has this id; see bb_method_at()";
    case BB_ERROR_FORM: return "the method or function does not take curves in this form";
    case BB_ERROR_DIMENSION: return "the function does not take this dimension";
    case BB_ERROR_DEGREE: return "the degree is out of range, or not one that the method takes";
    case BB_ERROR_NOT_FINITE: return "a coordinate, weight or parameter is not finite";
    case BB_ERROR_PARAMETER: return "a parameter is outside of the domain of the method or function";
    case BB_ERROR_TOLERANCE: return "the tolerance is out of range";
    case BB_ERROR_NO_POINT: return "the weights sum to zero, so the curve has no point there";
    case BB_ERROR_NO_BOUND: return "the method has no proved bound";
    case BB_ERROR_NOT_CERTAIN: return "the true length is not certain to 30 digits";
    case BB_ERROR_OVERFLOW: return "a control point of the result exceeds the largest double; scale the points down";
    case BB_ERROR_ENVIRONMENT: return "this thread does not round to nearest, or flushes subnormal numbers to zero";
    case BB_ERROR_MEMORY: return "memory is exhausted";
    case BB_ERROR_COUNT: return "too few points, an index beyond the end, or a buffer that is too small";
    case BB_ERROR_STOPPED: return "the computation was stopped";
    case BB_ERROR_INTERNAL: return "a defect of libbezierbench; please report it";
    case BB_ERROR_REPEATED:
      return "a point repeats the one before it, so that the parameter takes no step; leave it out";
    case BB_ERROR_FILE: return "the file cannot be read, or breaks a rule of its kind; see the message";
    default: return "not a status of this version of libbezierbench";
  }
}
