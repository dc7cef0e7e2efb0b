// SPDX-License-Identifier: MIT
// Boost.Math 1.74 asks for a mutex, which the C++ library for WebAssembly without threads does not have.
#pragma once

namespace boost::detail {

struct lightweight_mutex {
  struct scoped_lock {
    explicit scoped_lock(lightweight_mutex& /*mutex*/) {}
  };
};

}  // namespace boost::detail
