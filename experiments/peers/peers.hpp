// SPDX-License-Identifier: MIT
// Methods of other libraries, as kernels. Which of them there are is decided when the program is configured: the roster
// is experiments/peers/CMakeLists.txt.
#pragma once

#include <span>
#include <string_view>

#include "core/evaluate/kernel.hpp"

namespace bezierbench::peers {

/// A method of another library in this build.
struct Peer {
  std::string_view id;       ///< of the method
  std::string_view library;  ///< several peers may share one
  std::string_view library_version;
  std::span<const Kernel<double>> (*kernels)(int dimension);  ///< one kernel, or none for this dimension
};

/// A peer that this program knows by name only.
struct AbsentPeer {
  std::string_view id;
  std::string_view remedy;  ///< what to do to have it
};

/// The peers in this build, in roster order; none unless it was configured with -DBEZIERBENCH_PEERS=ON.
std::span<const Peer> present();

/// The others of the roster.
std::span<const AbsentPeer> absent();

}  // namespace bezierbench::peers
