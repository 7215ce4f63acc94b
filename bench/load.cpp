// SPDX-License-Identifier: BSD-3-Clause
#include "load.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <thread>

#include "processes.h"

namespace tzc {
namespace bench {
namespace {

// More than the caches of one processor hold, so that the others' caches and the memory are busy, too.
constexpr std::size_t working_set = 8 << 20;

[[noreturn]] void work() {
  std::vector<std::uint32_t> from(working_set / sizeof(std::uint32_t)), to(from.size());
  for (std::uint32_t state = 1;;) {
    for (std::uint32_t& word : from) word = state = state * 1664525 + 1013904223;
    std::memcpy(to.data(), from.data(), working_set);
    state += to[state % to.size()];
  }
}

}  // namespace

Load::Load() {
  workers_ = in_children(std::max(1U, std::thread::hardware_concurrency()), [](std::size_t) { work(); });
}

Load::~Load() {
  stop(workers_);
}

}  // namespace bench
}  // namespace tzc
