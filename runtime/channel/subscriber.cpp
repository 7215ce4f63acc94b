// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <thread>

#include "channel/link.h"
#include "channel/reader.h"
#include "channel/service.h"
#include "posix/futex.h"
#include "posix/hot.h"
#include "posix/thread.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {
namespace {

/// State of the reader thread and the user's handle. The thread outlives a handle that is destroyed inside a
/// callback.
struct SubscriberImpl {
  SubscriberImpl(SubscriberOptions given, std::shared_ptr<Link> connected)
      : options(std::move(given)), link(connected), reader(std::move(connected)) {}

  TZC_HOT void run() {
    MessagePtr message;
    while (!stopping && reader.read(posix::Waiting::block, message) == Reader::Result::message) {
      if (!stopping) options.on_message(message);
      message.reset();
      link->write_notice().give();
    }
    report_end();
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
  Reader reader;
  std::atomic<bool> stopping{false};
  std::atomic<bool> open{true};
  bool reported = false;
};

/// Null: the reader thread has to wait on the socket.
Service* hang_up_service() {
  if (!posix::has_shared_futex()) return nullptr;
  const auto service = Service::instance();
  return service ? *service : nullptr;
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
    if (!thread_.joinable()) return;
    const bool inside_callback = thread_.get_id() == std::this_thread::get_id();
    inside_callback ? thread_.detach() : thread_.join();
  }

  Status start_thread() {
    auto thread = posix::start_thread("tzc-reader", [impl = impl_] { impl->run(); });
    if (!thread) return thread.error();
    thread_ = std::move(*thread);
    return Success{};
  }

  int fd() const override { return impl_->options.own_thread ? -1 : impl_->link->fd(); }

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
    stats.copies_blocks = impl_->link->writes() == segment::ViewWrites::copies;
    stats.connected = impl_->open;
    return stats;
  }

 private:
  std::shared_ptr<SubscriberImpl> impl_;
  std::thread thread_;
};

}  // namespace

Expected<std::shared_ptr<Subscriber>> Subscriber::create(SubscriberOptions options) {
  if (options.own_thread && !options.on_message) {
    Error error;
    error.what = "subscribe with a thread of its own but without on_message";
    error.where = options.address;
    return error;
  }
  const bool own_thread = options.own_thread;
  auto link = Link::connect(options, own_thread ? hang_up_service() : nullptr);
  if (!link) return link.error();
  auto impl = std::make_shared<SubscriberImpl>(std::move(options), std::move(*link));
  auto subscriber = std::make_shared<SubscriberOwner>(std::move(impl));
  if (own_thread) {
    const Status started = subscriber->start_thread();
    if (!started) return started.error();
  }
  return std::shared_ptr<Subscriber>(std::move(subscriber));
}

}  // namespace channel
}  // namespace tzc
