// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <new>
#include <thread>

#include "channel/inspection.h"
#include "channel/subscribe/link.h"
#include "channel/subscribe/reader.h"
#include "channel/wait/service.h"
#include "posix/futex.h"
#include "posix/hot.h"
#include "posix/thread.h"
#include "trace/trace.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {
namespace {

constexpr int most_in_a_row = 16;  // messages of one subscriber, before others have their turn

/// State of the reading thread and the user's handle. The thread outlives a handle that is destroyed inside a
/// callback.
struct SubscriberImpl final : ReceivingEnd {
  SubscriberImpl(SubscriberOptions given, std::shared_ptr<Link> connected,
                 std::shared_ptr<DoorbellNumber> given_number)
      : options(std::move(given)),
        link(connected),
        number(link->ring() != nullptr ? std::move(given_number) : nullptr),
        reader(std::move(connected), options) {}

  /// On a thread of its own.
  TZC_HOT void run() {
    while (read_one(posix::Waiting::block) == Reader::Result::message) {
    }
    report_end();
  }

  /// On the thread that is shared.
  TZC_HOT Progress read_some() override {
    if (!begun && !may_begin()) return reader.has_something() ? Progress::later : Progress::done;
    for (int i = 0; i < most_in_a_row; ++i) {
      const Reader::Result result = read_one(posix::Waiting::return_at_once);
      if (result == Reader::Result::nothing) return Progress::done;
      if (result == Reader::Result::message) continue;
      report_end();
      return Progress::closed;
    }
    return Progress::more;
  }

  /// `closed` also when the subscriber is being destroyed.
  TZC_HOT Reader::Result read_one(posix::Waiting waiting) {
    if (stopping) return Reader::Result::closed;
    MessagePtr message;
    const Reader::Result result = reader.read(waiting, message);
    if (result != Reader::Result::message) return result;
    if (!stopping) hand_over(message);
    message.reset();
    link->write_notice().give();
    return result;
  }

  bool may_begin() {
    begun = stopping || (reader.has_something() && (!options.may_begin || options.may_begin()));
    return begun;
  }

  // A copy of a large message may not fit; that must not end a process that could go on.
  TZC_HOT void hand_over(const MessagePtr& message) try {
    trace::active ? reader.trace().call_back(options, message) : options.on_message(message);
  } catch (const std::bad_alloc&) {
    reader.give_up("out of memory");
  }

  void report_end() {
    open = false;
    if (stopping || reported) return;
    reported = true;
    link->unsubscribe();  // at once: the publisher may deliver what is in flight by other means
    if (options.on_disconnect) options.on_disconnect(reader.reason());
  }

  const SubscriberOptions options;
  const std::shared_ptr<Link> link;
  const std::shared_ptr<DoorbellNumber> number;  // null: a thread of its own reads
  Reader reader;
  std::atomic<bool> stopping{false};
  std::atomic<bool> open{true};
  bool begun = false;  // reading thread
  bool reported = false;
};

/// Null: the reader thread has to wait on the socket.
Service* hang_up_service() {
  if (!posix::has_shared_futex()) return nullptr;
  const auto service = Service::instance();
  return service ? *service : nullptr;
}

/// Null: a thread of its own reads.
std::shared_ptr<DoorbellNumber> number_for(const SubscriberOptions& options) {
  if (!options.own_thread || !options.shared_thread) return nullptr;
  const auto receiver = Receiver::instance();
  return receiver ? (*receiver)->take_number() : nullptr;
}

class SubscriberOwner final : public Subscriber {
 public:
  explicit SubscriberOwner(std::shared_ptr<SubscriberImpl> impl) : impl_(std::move(impl)) {}

  // A forked child leaves its copy alone: it does not have the thread, and must not send for its parent.
  ~SubscriberOwner() override {
    if (impl_->link->forked()) {
      new std::shared_ptr<SubscriberImpl>(std::move(impl_));
      new std::thread(std::move(thread_));
      return;
    }
    impl_->stopping = true;
    impl_->link->unsubscribe();
    impl_->link->write_notice().stop();
    if (impl_->number) impl_->number->end();
    if (!thread_.joinable()) return;
    const bool inside_callback = thread_.get_id() == std::this_thread::get_id();
    inside_callback ? thread_.detach() : thread_.join();
  }

  Status start() {
    if (impl_->number) {
      impl_->number->begin(impl_);
      return Success{};
    }
    auto thread = posix::start_thread("tzc-reader", [impl = impl_] { impl->run(); });
    if (!thread) return thread.error();
    thread_ = std::move(*thread);
    return Success{};
  }

  int fd() const override { return impl_->options.own_thread ? -1 : impl_->link->sockets().current(); }

  MessagePtr read() override {
    MessagePtr message;
    const std::shared_ptr<SubscriberImpl> impl = impl_;  // on_disconnect may destroy this subscriber
    if (impl->options.own_thread || impl->link->forked()) return message;
    if (impl->reader.read(posix::Waiting::return_at_once, message) == Reader::Result::closed)
      impl->report_end();
    return message;
  }

  Credentials peer() const override { return impl_->link->peer(); }

  SubscriberStats stats() const override {
    const ReaderCounters& counters = impl_->reader.counters();
    SubscriberStats stats;
    stats.received = counters.received;
    stats.lost = counters.lost;
    stats.bytes = counters.bytes;
    stats.written = impl_->link->written();
    stats.copies_blocks = impl_->link->view_use().writes == segment::ViewWrites::copies;
    stats.connected = impl_->open;
    return stats;
  }

  SubscriberInspection inspect() const {
    const ReaderCounters& counters = impl_->reader.counters();
    return {counters.latencies.counts(), counters.shared_bytes};
  }

 private:
  std::shared_ptr<SubscriberImpl> impl_;
  std::thread thread_;
};

}  // namespace

// There is no other implementation.
SubscriberInspection inspect(const Subscriber& subscriber) {
  return static_cast<const SubscriberOwner&>(subscriber).inspect();
}

Expected<std::shared_ptr<Subscriber>> Subscriber::create(SubscriberOptions options) {
  if (options.own_thread && !options.on_message) {
    Error error;
    error.what = "subscribe with a thread of its own but without on_message";
    error.where = options.address;
    return error;
  }
  const bool own_thread = options.own_thread;
  const RingPlace place{own_thread ? hang_up_service() : nullptr, number_for(options)};
  auto link = Link::connect(options, place);
  if (!link) return link.error();
  auto impl = std::make_shared<SubscriberImpl>(std::move(options), std::move(*link), place.number);
  auto subscriber = std::make_shared<SubscriberOwner>(std::move(impl));
  if (own_thread) {
    const Status started = subscriber->start();
    if (!started) return started.error();
  }
  return std::shared_ptr<Subscriber>(std::move(subscriber));
}

}  // namespace channel
}  // namespace tzc
