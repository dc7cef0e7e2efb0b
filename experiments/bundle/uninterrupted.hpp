// SPDX-License-Identifier: MIT
// System calls that a signal interrupts are made again: on network file systems that happens to more of them than one
// would think.
#pragma once

#include <cerrno>
#include <system_error>

namespace bezierbench::bundle {

/// The result of `call()`, which says -1 and sets errno where it fails.
template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

/// What `call(error)` leaves in `error`, as the functions of std::filesystem do.
template <class Call>
std::error_code uninterrupted_error(Call call) {
  std::error_code error;
  do {
    error.clear();
    call(error);
  } while (error == std::errc::interrupted);
  return error;
}

}  // namespace bezierbench::bundle
