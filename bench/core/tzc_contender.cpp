// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <unistd.h>

#include <cstring>
#include <vector>

#include "channel_pair.h"
#include "contenders.h"
#include "span.h"
#include "tzc/channel.h"

namespace tzc {
namespace bench {
namespace {

using channel::MessagePtr;

constexpr std::uint32_t rehearsal = 1;     // the tag of a message that is not measured
constexpr useconds_t rehearsal_us = 2000;  // how long a subscriber takes over one

// What docs/core.md asks of a real-time publisher's start-up: a full queue, before subscribers that are late.
void rehearse(channel::Publisher& publisher, const Setup& setup) {
  const char control[control_bytes] = {};
  std::vector<channel::RecordPtr> records;
  for (std::size_t i = 0; i < setup.queue_size; ++i)
    records.push_back(channel::make_record(rehearsal, control, sizeof control,
                                           {publisher.memory()->allocate(setup.size_bytes)}));
  for (const channel::RecordPtr& record : records) publisher.publish(record);
  ::usleep(static_cast<useconds_t>(2 * setup.queue_size) * rehearsal_us);
}

void record(const MessagePtr& message, Recorder& recorder) {
  if (message->tag() == rehearsal) {
    ::usleep(rehearsal_us);
    return;
  }
  Stamp stamp{};
  std::memcpy(&stamp, message->control(), sizeof stamp);
  recorder.record(stamp);
}

class TzcContender final : public Contender {
 public:
  explicit TzcContender(bool own_loop) : own_loop_(own_loop) {}

  const char* name() const override { return own_loop_ ? "tzc-own-loop" : "tzc"; }
  std::size_t memory_bytes(const Setup& setup) const override { return shared_memory_bytes(setup, false); }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    channel::SubscriberOptions options;
    options.own_thread = !own_loop_;
    options.private_writes = !setup.real_time;  // which looks after signal handlers for each message
    options.on_message = [&recorder](const MessagePtr& message) { record(message, recorder); };
    const auto subscriber = connect(setup, options);
    recorder.ready();
    while (!recorder.stop()) own_loop_ ? poll_once(*subscriber, recorder) : void(::usleep(250'000));
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    const auto publisher = open_publisher(setup, setup.size_bytes);
    return [publisher, setup](std::uint64_t index) {
      if (setup.real_time && index == 0) rehearse(*publisher, setup);
      const Span span(setup, index);
      BufferPtr buffer = publisher->memory()->allocate(setup.size_bytes);
      if (!buffer) return;
      span.fill(buffer->data(), setup.size_bytes);
      char control[control_bytes] = {};
      const Stamp stamp = span.stamp();
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
