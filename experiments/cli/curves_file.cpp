// SPDX-License-Identifier: MIT
#include "experiments/cli/curves_file.hpp"

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {

curves::Read read_curve_set(const std::string& file, const curves::ReadOptions& options) {
  try {
    return curves::read(bundle::read_file(file == "-" ? "/dev/stdin" : file), file, options);
  } catch (const curves::Unreadable& error) {
    throw Failure(Exit::input_output, error.what());
  }
}

}  // namespace bezierbench::cli
