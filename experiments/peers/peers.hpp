// SPDX-License-Identifier: MIT
// Methods of other libraries, as kernels. Which of them there are is decided when the program is configured: the roster
// is experiments/peers/CMakeLists.txt.
#pragma once

#include <span>
#include <string_view>

#include "core/arc_length/kernel.hpp"
#include "core/evaluate/kernel.hpp"
#include "core/project/kernel.hpp"

namespace bezierbench::peers {

template <class K>
std::span<const K> none(int /*dimension*/) {
  return {};
}

/// A method of another library in this build. It solves one problem: one of the tables has one kernel, or none for this
/// dimension, the others are empty.
struct Peer {
  std::string_view id;       ///< of the method
  std::string_view library;  ///< several peers may share one
  std::string_view library_version;
  std::span<const Kernel<double>> (*kernels)(int dimension) = none<Kernel<double>>;  ///< evaluators
  std::span<const ArcLengthKernel> (*arc_length_kernels)(int dimension) = none<ArcLengthKernel>;
  std::span<const ProjectionKernel> (*projection_kernels)(int dimension) = none<ProjectionKernel>;
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
