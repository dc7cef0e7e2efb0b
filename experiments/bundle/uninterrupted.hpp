// SPDX-License-Identifier: MIT
// Calls of system functions, repeated where a signal interrupts them. On network file systems this happens to many
// functions.
#pragma once

#include <cerrno>
#include <system_error>

namespace bezierbench::bundle {

/// The result of `call()`, which returns -1 and sets errno where it fails.
template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

/// The error that `call(error)` sets, as functions of std::filesystem do.
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
