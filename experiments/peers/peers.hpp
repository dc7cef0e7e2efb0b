// SPDX-License-Identifier: MIT
// Methods of other libraries, as kernels. The roster is experiments/peers/CMakeLists.txt; CMake chooses those whose
// libraries are installed.
#pragma once

#include <span>
#include <string_view>

#include "core/arc_length/kernel.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/project/kernel.hpp"

namespace bezierbench::peers {

template <class K>
std::span<const K> none(int /*dimension*/) {
  return {};
}

/// A method of another library in this build. It solves one problem: one of the functions returns its kernel, if it has
/// one for the dimension, and the others return an empty table.
struct Peer {
  std::string_view id;       ///< of the method
  std::string_view library;  ///< several peers may share one
  std::string_view library_version;
  std::span<const Kernel<double>> (*kernels)(int dimension) = none<Kernel<double>>;  ///< evaluators
  std::span<const ArcLengthKernel> (*arc_length_kernels)(int dimension) = none<ArcLengthKernel>;
  std::span<const ProjectionKernel> (*projection_kernels)(int dimension) = none<ProjectionKernel>;
};

/// A peer that is not in this build.
struct AbsentPeer {
  std::string_view id;
  std::string_view remedy;  ///< what to do to have it
};

/// The peers in this build, in roster order; none unless it was configured with -DBEZIERBENCH_PEERS=ON.
std::span<const Peer> present();

/// The peers of the roster that are not in this build.
std::span<const AbsentPeer> absent();

}  // namespace bezierbench::peers
