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

/// What the reader thread and the user's handle share. The thread may outlive the handle when the handle goes
/// inside a callback.
struct Session {
  Session(SubscriberOptions given, std::shared_ptr<Link> connected)
      : options(std::move(given)), link(connected), reader(std::move(connected)) {}

  TZC_HOT void run() {
    MessagePtr message;
    while (!stopping && reader.read(posix::Waiting::block, message) == Reader::Result::message) {
      if (!stopping) options.on_message(message);
      message.reset();
    }
    report_end();
  }

  void report_end() {
    open = false;
    if (stopping || reported) return;
    reported = true;
    link->say_goodbye();  // at once: what the publisher has sent meanwhile is wanted by other means
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

class SubscriberHandle final : public Subscriber {
 public:
  explicit SubscriberHandle(std::shared_ptr<Session> session) : session_(std::move(session)) {}

  // A forked child has neither the thread nor the right to speak for its parent: let its copy be.
  ~SubscriberHandle() override {
    if (session_->link->forked()) {
      new std::shared_ptr<Session>(std::move(session_));
      new std::thread(std::move(thread_));
      return;
    }
    session_->stopping = true;
    session_->link->say_goodbye();
    if (!thread_.joinable()) return;
    const bool inside_callback = thread_.get_id() == std::this_thread::get_id();
    inside_callback ? thread_.detach() : thread_.join();
  }

  Status start_thread() {
    auto thread = posix::start_thread("tzc-reader", [session = session_] { session->run(); });
    if (!thread) return thread.error();
    thread_ = std::move(*thread);
    return Success{};
  }

  int fd() const override { return session_->options.own_thread ? -1 : session_->link->fd(); }

  MessagePtr read() override {
    MessagePtr message;
    const std::shared_ptr<Session> session = session_;  // on_disconnect may destroy this subscriber
    if (session->options.own_thread || session->link->forked()) return message;
    if (session->reader.read(posix::Waiting::return_at_once, message) == Reader::Result::closed)
      session->report_end();
    return message;
  }

  Credentials peer() const override { return session_->link->peer(); }

  SubscriberStats stats() const override {
    const ReaderCounters& counters = session_->reader.counters();
    SubscriberStats stats;
    stats.received = counters.received;
    stats.lost = counters.lost;
    stats.bytes = counters.bytes;
    stats.connected = session_->open;
    return stats;
  }

 private:
  std::shared_ptr<Session> session_;
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
  auto session = std::make_shared<Session>(std::move(options), std::move(*link));
  auto subscriber = std::make_shared<SubscriberHandle>(std::move(session));
  if (own_thread) {
    const Status started = subscriber->start_thread();
    if (!started) return started.error();
  }
  return std::shared_ptr<Subscriber>(std::move(subscriber));
}

}  // namespace channel
}  // namespace tzc
