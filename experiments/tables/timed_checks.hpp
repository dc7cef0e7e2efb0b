// SPDX-License-Identifier: MIT
// The check of timed methods without a proved bound: their largest error is compared with the largest error that the
// accuracy studies of the same bundle have in the same cell.
#pragma once

#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {

/// Completes the rows of `timing.csv` that have `max_error_u`, from all accuracy studies in the other tables:
/// `allowed_error_u` by metric::allowed_error_u(), and `checked` is `no` where it is exceeded.
void check_timed_errors(Tables& tables);

}  // namespace bezierbench::tables
