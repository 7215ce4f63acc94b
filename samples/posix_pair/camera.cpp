// SPDX-License-Identifier: BSD-3-Clause
// Publishes 30 synthetic frames a second until it is stopped, or as many frames as its argument says.
#include <tzc/channel.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "frame.h"

namespace {

constexpr std::uint32_t width = 1280, height = 720;

std::int64_t now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch().count();
}

bool publish_frame(tzc::channel::Publisher& publisher, std::uint64_t number) {
  tzc::BufferPtr pixels = publisher.memory()->allocate(width * height);
  if (!pixels) {
    std::fprintf(stderr, "frame %llu: %s\n", static_cast<unsigned long long>(number),
                 publisher.memory()->last_failure().text().c_str());
    return false;
  }
  std::memset(pixels->data(), static_cast<int>(number), width * height);
  const Frame frame{number, now_ns(), width, height};
  publisher.publish(tzc::channel::make_record(0, &frame, sizeof frame, {pixels}));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  tzc::channel::PublisherOptions options;
  options.address = address;
  options.queue_size = 3;
  options.on_connect = [](const tzc::channel::ConnectionPtr& who) {
    std::printf("process %d subscribes\n", static_cast<int>(who->peer().pid));
  };
  const auto publisher = tzc::channel::Publisher::create(options);
  if (!publisher) {
    std::fprintf(stderr, "%s\n", publisher.error().text().c_str());
    return 1;
  }
  const std::uint64_t frames = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : UINT64_MAX;
  for (std::uint64_t number = 0; number < frames; ++number) {
    publish_frame(**publisher, number);
    std::this_thread::sleep_for(std::chrono::milliseconds(33));
  }
}
