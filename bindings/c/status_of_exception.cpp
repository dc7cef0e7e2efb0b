// SPDX-License-Identifier: MIT
#include <new>

#include "bindings/c/status.hpp"
#include "reference/length/true_length.hpp"

namespace bezierbench::c {

bb_status status_of_exception() noexcept {
  try {
    throw;
  } catch (const Refused& refused) {
    return refused.status;
  } catch (const std::bad_alloc&) {
    return BB_ERROR_MEMORY;
  } catch (const reference::Stopped&) {
    return BB_ERROR_STOPPED;
  } catch (const reference::NotCertain&) {
    return BB_ERROR_NOT_CERTAIN;
  } catch (...) {
    return BB_ERROR_INTERNAL;
  }
}

}  // namespace bezierbench::c
