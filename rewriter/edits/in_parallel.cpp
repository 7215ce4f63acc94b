// SPDX-License-Identifier: BSD-3-Clause
#include "edits/in_parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace tzc::rewriter {

void in_parallel(unsigned jobs, std::size_t count, const std::function<void(std::size_t)>& work) {
  if (jobs == 0) jobs = std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < jobs && i < count; ++i) threads.emplace_back(run);
  run();
  for (std::thread& thread : threads) thread.join();
}

}  // namespace tzc::rewriter
