// SPDX-License-Identifier: MIT
#include "experiments/peers/peers.hpp"

#include "peer_roster.hpp"

namespace bezierbench::peers {

std::span<const Peer> present() { return present_peers; }
std::span<const AbsentPeer> absent() { return absent_peers; }

}  // namespace bezierbench::peers
