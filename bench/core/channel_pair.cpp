// SPDX-License-Identifier: BSD-3-Clause
#include "channel_pair.h"

#include <unistd.h>

#include <cstdio>

namespace tzc {
namespace bench {
namespace {

std::string address_of(const Setup& setup) {
  return "@" + setup.name;
}

}  // namespace

std::shared_ptr<channel::Subscriber> connect(const Setup& setup, channel::SubscriberOptions options) {
  options.address = address_of(setup);
  for (int i = 0; i < 5000; ++i) {
    auto subscriber = channel::Subscriber::create(options);
    if (subscriber) return *subscriber;
    ::usleep(1000);  // the publisher is still starting
  }
  std::fprintf(stderr, "tzc: cannot subscribe\n");
  ::_exit(1);
}

std::shared_ptr<channel::Publisher> open_publisher(const Setup& setup, std::size_t block_bytes) {
  channel::PublisherOptions options;
  options.address = address_of(setup);
  options.queue_size = setup.queue_size;
  MemoryOptions memory;
  memory.size = block_bytes * (setup.queue_size + 2);
  if (setup.real_time) memory.prefault = Prefault::all;
  options.memory = *SegmentMemory::create(memory);
  return *channel::Publisher::create(options);
}

}  // namespace bench
}  // namespace tzc
