// SPDX-License-Identifier: BSD-3-Clause
// Receives frames in its own poll loop, until the camera ends, or as many frames as its argument says.
#include <poll.h>
#include <tzc/channel.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "frame.h"

namespace {

std::int64_t now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch().count();
}

bool show(const tzc::channel::Message& message) {
  Frame frame;
  if (message.control_size() != sizeof frame || message.blocks().size() != 1) return false;
  std::memcpy(&frame, message.control(), sizeof frame);
  const tzc::ConstBlock& pixels = message.blocks()[0];
  const std::size_t last = std::size_t{frame.width} * frame.height - 1;
  std::printf("frame %llu, %u x %u, %.0f us old\n", static_cast<unsigned long long>(frame.number),
              frame.width, frame.height, static_cast<double>(now_ns() - frame.taken_ns) / 1000);
  return last < pixels.size && pixels.data[0] == static_cast<std::uint8_t>(frame.number) &&
         pixels.data[last] == pixels.data[0];
}

}  // namespace

int main(int argc, char** argv) {
  tzc::channel::SubscriberOptions options;
  options.address = address;
  options.own_thread = false;
  const auto subscriber = tzc::channel::Subscriber::create(options);
  if (!subscriber) {
    std::fprintf(stderr, "%s\n", subscriber.error().text().c_str());
    return 1;
  }
  const long frames = argc > 1 ? std::atol(argv[1]) : -1;
  for (long shown = 0; shown != frames && (*subscriber)->stats().connected;) {
    pollfd one{(*subscriber)->fd(), POLLIN, 0};
    ::poll(&one, 1, -1);
    while (const tzc::channel::MessagePtr message = (*subscriber)->read()) {
      if (!show(*message)) return 1;
      ++shown;
    }
  }
  std::printf("lost: %llu\n", static_cast<unsigned long long>((*subscriber)->stats().lost));
}
