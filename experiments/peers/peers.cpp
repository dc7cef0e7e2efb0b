// SPDX-License-Identifier: MIT
#include "experiments/peers/peers.hpp"

#include "peer_roster.hpp"

namespace bezierbench::peers {

std::span<const Peer> present() { return present_peers; }
std::span<const AbsentPeer> absent() { return absent_peers; }
ModelReader model_reader() { return present_model_reader; }

}  // namespace bezierbench::peers
