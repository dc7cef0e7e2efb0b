// SPDX-License-Identifier: MIT
// What Highway's library says of every 64-bit ARM processor, in place of that library.
#include <hwy/targets.h>

namespace hwy {

int64_t SupportedTargets() { return HWY_NEON; }

}  // namespace hwy
