// SPDX-License-Identifier: MIT
// A count over many pieces of work, shared among threads.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace bezierbench::programs {

/// The sum of work(0) to work(pieces - 1). Which thread does a piece changes nothing if a piece depends on its number only.
template <class Work>
auto sum_of_pieces(long pieces, unsigned threads, const Work& work) {
  decltype(work(0L)) sum;
  std::mutex guard;
  std::atomic<long> next = 0;
  std::vector<std::jthread> workers;
  for (unsigned k = 0; k < threads; ++k)
    workers.emplace_back([&] {
      for (long piece = next++; piece < pieces; piece = next++) {
        const auto one = work(piece);
        const std::scoped_lock lock(guard);
        sum += one;
      }
    });
  workers.clear();
  return sum;
}

}  // namespace bezierbench::programs
