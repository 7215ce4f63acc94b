// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <random>

#include "board.h"
#include "message_pattern.h"
#include "tzc/channel.h"

namespace tzc {
namespace crash {
namespace {

std::shared_ptr<channel::Publisher> open(std::mt19937& random) {
  MemoryOptions memory;
  memory.size = memory_size;
  memory.policy = std::array<Policy, 3>{Policy::best_effort(), Policy::medium_effort(),
                                        Policy::worst_effort()}[random() % 3];
  channel::PublisherOptions options;
  options.address = board->address;
  options.queue_size = 1 + random() % 20;
  options.memory = *SegmentMemory::create(memory);
  for (int i = 0; i < 1000; ++i) {
    auto created = channel::Publisher::create(options);
    if (created) return *created;
    ::usleep(1000);  // the kernel is still closing the dead one's socket
  }
  report_error("cannot listen again");
  ::_exit(1);
}

/// One block as large as all of it fits only when nothing at all is referenced any more.
bool everything_is_free(SegmentMemory& memory) {
  return static_cast<bool>(memory.allocate(memory_size));
}

}  // namespace

void run_publisher(unsigned seed) {
  std::mt19937 random(seed);
  const auto out = open(random);
  for (std::uint64_t sequence = std::uint64_t{seed} << 32;;) {
    board->connections = static_cast<int>(out->connections().size());
    if (board->phase == Phase::run) {
      if (const auto record = make_patterned(*out->memory(), ++sequence)) out->publish(record);
      if (random() % 4 == 0) ::usleep(random() % 200);
    } else if (board->all_free_since == 0) {
      if (everything_is_free(*out->memory())) board->all_free_since = now_ns();
      ::usleep(200);
    } else {
      ::usleep(500);
    }
  }
}

}  // namespace crash
}  // namespace tzc
