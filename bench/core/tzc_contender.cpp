// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

#include "contenders.h"
#include "tzc/channel.h"

namespace tzc {
namespace bench {
namespace {

using channel::MessagePtr;

void record(const MessagePtr& message, Recorder& recorder) {
  Stamp stamp{};
  std::memcpy(&stamp, message->control(), sizeof stamp);
  recorder.record(stamp);
}

std::shared_ptr<channel::Subscriber> connect(channel::SubscriberOptions options) {
  for (int i = 0; i < 5000; ++i) {
    auto subscriber = channel::Subscriber::create(options);
    if (subscriber) return *subscriber;
    ::usleep(1000);  // the publisher is still starting
  }
  std::fprintf(stderr, "tzc: cannot subscribe\n");
  ::_exit(1);
}

class TzcContender final : public Contender {
 public:
  explicit TzcContender(bool own_loop) : own_loop_(own_loop) {}

  const char* name() const override { return own_loop_ ? "tzc-own-loop" : "tzc"; }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    channel::SubscriberOptions options;
    options.address = "@" + setup.name;
    options.own_thread = !own_loop_;
    options.on_message = [&recorder](const MessagePtr& message) { record(message, recorder); };
    const auto subscriber = connect(options);
    recorder.ready();
    while (!recorder.stop()) own_loop_ ? poll_once(*subscriber, recorder) : void(::usleep(250'000));
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    channel::PublisherOptions options;
    options.address = "@" + setup.name;
    options.queue_size = setup.queue_size;
    MemoryOptions memory;
    memory.size = setup.size_bytes * (setup.queue_size + 2);
    options.memory = *SegmentMemory::create(memory);
    const auto publisher = *channel::Publisher::create(options);
    return [publisher, setup](std::uint64_t index) {
      BufferPtr buffer = publisher->memory()->allocate(setup.size_bytes);
      char control[control_bytes] = {};
      const Stamp stamp{now_ns(), index};
      std::memcpy(control, &stamp, sizeof stamp);
      publisher->publish(channel::make_record(0, control, sizeof control, {std::move(buffer)}));
    };
  }

 private:
  static void poll_once(channel::Subscriber& subscriber, Recorder& recorder) {
    pollfd one{subscriber.fd(), POLLIN, 0};
    ::poll(&one, 1, 100);
    while (const MessagePtr message = subscriber.read()) record(message, recorder);
  }

  const bool own_loop_;
};

}  // namespace

std::unique_ptr<Contender> tzc_reader_contender() {
  return std::make_unique<TzcContender>(false);
}
std::unique_ptr<Contender> tzc_own_loop_contender() {
  return std::make_unique<TzcContender>(true);
}

}  // namespace bench
}  // namespace tzc
