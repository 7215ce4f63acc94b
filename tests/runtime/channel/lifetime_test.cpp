// SPDX-License-Identifier: BSD-3-Clause
// Which end may leave when: unsubscribing, closing, dying and forking, with messages still held.
#include <signal.h>

#include <atomic>
#include <new>

#include "channel/inspection.h"
#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

bool has_room(Publisher& out, std::size_t bytes) {
  return static_cast<bool>(out.memory()->allocate(bytes));
}

/// The message fills the publisher's memory, with bytes of value 8; its connection is ending.
void expect_held_until_released(Publisher& out, MessagePtr held) {
  ASSERT_TRUE(eventually([&] { return out.connections().empty(); }));
  EXPECT_FALSE(has_room(out, mb));
  EXPECT_TRUE(all_bytes_are(held->blocks()[0], 8));
  held.reset();
  EXPECT_TRUE(eventually([&] { return has_room(out, mb); }));
}

TEST(Lifetime, a_held_message_outlives_its_subscriber) {
  const auto out = publisher(10, mb, Policy::best_effort());
  MessagePtr held;
  {
    Inbox in(out->address());
    out->publish(text_record("x", {filled(*out->memory(), mb, 8)}));
    ASSERT_TRUE(in.wait_for(1));
    held = in.messages()[0];
  }
  expect_held_until_released(*out, std::move(held));
}

/// For as long as it lives, keeps the service thread busy, which reads Unsubscribe packets.
class BusyServiceThread {
 public:
  BusyServiceThread() {
    PublisherOptions options;
    options.on_connect = [this](const ConnectionPtr&) {
      busy_ = true;
      while (!done_) std::this_thread::yield();
    };
    other_ = publish_with(options);
    visitor_ = std::thread([this] { idle_subscriber(other_->address()); });
    while (!busy_) std::this_thread::yield();
  }
  ~BusyServiceThread() {
    done_ = true;
    visitor_.join();
  }

 private:
  std::atomic<bool> busy_{false}, done_{false};
  std::shared_ptr<Publisher> other_;
  std::thread visitor_;
};

// The write fails before the Unsubscribe is read. Ending the socket then would free what the process still holds.
TEST(Lifetime, a_held_message_outlives_a_write_that_fails) {
  const auto out = publisher(10, mb, Policy::best_effort());
  MessagePtr held;
  {
    Inbox in(out->address());
    out->publish(text_record("x", {filled(*out->memory(), mb, 8)}));
    ASSERT_TRUE(in.wait_for(1));
    held = in.messages()[0];
    const BusyServiceThread busy;
    in.subscriber.reset();
    out->publish(text_record("nobody reads this"));
  }
  expect_held_until_released(*out, std::move(held));
}

TEST(Lifetime, a_held_message_outlives_its_publisher) {
  auto out = publisher();
  Inbox in(out->address());
  out->publish(text_record("x", {filled(*out->memory(), mb, 8)}));
  ASSERT_TRUE(in.wait_for(1));
  out.reset();
  ASSERT_TRUE(in.wait_for_end());
  EXPECT_TRUE(all_bytes_are(in.messages()[0]->blocks()[0], 8));
}

TEST(Lifetime, memory_that_outlives_its_publisher_does_not_reuse_held_blocks) {
  auto out = publisher(10, mb, Policy::best_effort());
  const auto memory = out->memory();
  Inbox in(out->address());
  out->publish(text_record("x", {filled(*memory, mb, 8)}));
  ASSERT_TRUE(in.wait_for(1));
  out.reset();
  ASSERT_TRUE(in.wait_for_end());
  EXPECT_FALSE(memory->allocate(mb));
  in.clear();
  EXPECT_TRUE(eventually([&] { return static_cast<bool>(memory->allocate(mb)); }));
}

TEST(Lifetime, unread_messages_of_a_closed_publisher_still_arrive) {
  auto out = publisher(100);
  const auto in = idle_subscriber(out->address());
  for (int i = 0; i < 100; ++i)
    out->publish(text_record(std::string(20'000, 'x'), {filled(*out->memory(), 100, 3)}));
  out.reset();
  int count = 0;
  EXPECT_TRUE(eventually([&] {
    while (const MessagePtr message = in->read()) count += all_bytes_are(message->blocks()[0], 3) ? 1 : 0;
    return !in->stats().connected;
  }));
  EXPECT_EQ(count, 100);
}

TEST(Lifetime, a_killed_subscriber_frees_its_blocks_at_once) {
  const auto out = publisher(10, mb);
  const std::string address = out->address();
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = in_child([&] {
    Inbox in(address);
    in.wait_for(1);
    (void)!::write(ready[1], "x", 1);
    ::pause();
    return 0;
  });
  ::close(ready[1]);  // a child that dies early ends the read below
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
  out->publish(text_record("x", {filled(*out->memory(), mb, 8)}));
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_FALSE(has_room(*out, mb));
  ::kill(child, SIGKILL);
  EXPECT_TRUE(eventually([&] { return has_room(*out, mb); }, 100));
  EXPECT_EQ(exit_status(child), -1);
  ::close(ready[0]);
}

TEST(Lifetime, a_killed_publisher_leaves_what_was_taken) {
  int address_pipe[2];
  ASSERT_EQ(::pipe(address_pipe), 0);
  const pid_t child = in_child([&] {
    const auto out = publisher();
    (void)!::write(address_pipe[1], out->address().c_str(), out->address().size() + 1);
    for (;;) {
      out->publish(text_record("x", {filled(*out->memory(), mb, 8)}));
      ::usleep(1000);
    }
    return 0;
  });
  ::close(address_pipe[1]);
  char address[200] = {};
  ASSERT_GT(::read(address_pipe[0], address, sizeof address), 0);
  Inbox in(address);
  ASSERT_TRUE(in.wait_for(3));
  ::kill(child, SIGKILL);
  exit_status(child);
  EXPECT_TRUE(in.wait_for_end());
  for (const MessagePtr& message : in.messages()) EXPECT_TRUE(all_bytes_are(message->blocks()[0], 8));
  ::close(address_pipe[0]);
}

TEST(Lifetime, nothing_is_left_open) {
  {
    Inbox warm_up(publisher()->address());
  }  // starts the service
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // earlier connections end
  const int before = open_descriptors();
  for (int i = 0; i < 20; ++i) {
    const auto out = publisher();
    Inbox in(out->address());
    out->publish(text_record("x", {filled(*out->memory(), 1000, 1)}));
    ASSERT_TRUE(in.wait_for(1));
  }
  EXPECT_TRUE(eventually([&] { return open_descriptors() == before; }))
      << open_descriptors() << " vs " << before;
}

TEST(Lifetime, callbacks_come_once_and_never_after_the_end) {
  std::atomic<int> connected{0}, disconnected{0};
  PublisherOptions options;
  options.on_connect = [&](const ConnectionPtr&) { ++connected; };
  options.on_disconnect = [&](const ConnectionPtr&) { ++disconnected; };
  auto out = publish_with(options);
  {
    Inbox in(out->address());
  }
  EXPECT_TRUE(eventually([&] { return disconnected == 1; }));
  Inbox other(out->address());
  out.reset();
  const int at_the_end = disconnected;
  other.subscriber.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(connected, 2);
  EXPECT_EQ(disconnected, at_the_end);
}

TEST(Lifetime, a_subscriber_may_go_inside_its_callback) {
  struct Shared {
    std::mutex mutex;
    std::shared_ptr<Subscriber> subscriber;
    std::atomic<int> calls{0};
  };
  const auto out = publisher();
  const auto shared = std::make_shared<Shared>();  // the last callback may still run when the test is over
  SubscriberOptions options;
  options.address = out->address();
  options.shared_thread = on_shared_thread();
  options.on_message = [shared](const MessagePtr&) {
    const std::lock_guard<std::mutex> lock(shared->mutex);
    shared->subscriber.reset();
    ++shared->calls;
  };
  {
    const std::lock_guard<std::mutex> lock(shared->mutex);
    shared->subscriber = *Subscriber::create(options);
  }
  for (int i = 0; i < 10; ++i) out->publish(text_record("x"));
  EXPECT_TRUE(eventually([&] { return shared->calls == 1 && out->connections().empty(); }));
}

TEST(Lifetime, a_publisher_may_go_inside_its_callbacks) {
  for (const bool on_connect : {true, false}) {
    std::shared_ptr<Publisher> out;
    std::atomic<bool> called{false};
    const auto destroy = [&](const ConnectionPtr&) {
      out.reset();
      called = true;
    };
    PublisherOptions options;
    (on_connect ? options.on_connect : options.on_disconnect) = destroy;
    out = publish_with(options);
    {
      Inbox in(out->address());
    }
    EXPECT_TRUE(eventually([&] { return called.load(); }));
  }
}

TEST(Lifetime, close_ends_one_subscription) {
  const auto out = publisher();
  Inbox a(out->address()), b(out->address());
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 2; }));
  out->publish(text_record("last"));
  const ConnectionPtr first = out->connections()[0];
  first->close();
  EXPECT_FALSE(first->alive());
  EXPECT_FALSE(first->send(text_record("too late")));
  EXPECT_TRUE(a.wait_for_end());
  EXPECT_EQ(a.messages().size(), 1u);
  EXPECT_EQ(out->publish(text_record("for b")), 1u);
}

TEST(Lifetime, a_forked_child_reads_and_leaves_no_trace) {
  const auto out = publisher(10, mb, Policy::best_effort());
  auto in = std::make_unique<Inbox>(out->address());
  out->publish(text_record("x", {filled(*out->memory(), mb, 8)}));
  ASSERT_TRUE(in->wait_for(1));
  MessagePtr held = in->messages()[0];
  in->clear();
  const pid_t child = in_child([&] {
    const bool intact = all_bytes_are(held->blocks()[0], 8);
    held.reset();
    in->subscriber.reset();
    const_cast<std::shared_ptr<Publisher>&>(out).reset();
    return intact ? 0 : 1;
  });
  EXPECT_EQ(exit_status(child), 0);
  EXPECT_FALSE(has_room(*out, mb)) << "the child released its parent's message";
  EXPECT_EQ(out->publish(text_record("still there")), 1u);
  EXPECT_TRUE(in->wait_for(1));
  held.reset();
  EXPECT_TRUE(has_room(*out, mb));
}

TEST(Lifetime, a_callback_without_memory_ends_its_subscription_alone) {
  const auto out = publisher();
  Inbox other(out->address());
  std::atomic<int> calls{0};
  std::atomic<bool> ended{false};
  SubscriberOptions options;
  options.address = out->address();
  options.on_message = [&](const MessagePtr&) {
    if (++calls == 2) throw std::bad_alloc();
  };
  options.on_disconnect = [&](const std::string& reason) {
    ended = reason.find("memory") != std::string::npos;
  };
  const auto in = Subscriber::create(std::move(options));
  ASSERT_TRUE(in);
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 2; }));
  for (int i = 0; i < 3; ++i) out->publish(text_record("x", {filled(*out->memory(), mb, 8)}));
  EXPECT_TRUE(eventually([&] { return ended.load(); }));
  EXPECT_EQ(calls, 2);
  EXPECT_TRUE(eventually([&] { return out->connections().size() == 1; }));
  EXPECT_TRUE(other.wait_for(3));
}

// Other threads of the parent may hold the locks: here one publishes without a pause.
TEST(Lifetime, a_forked_child_may_ask_for_statistics) {
  const auto out = publisher();
  Inbox in(out->address());
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
  const ConnectionPtr connection = out->connections()[0];
  std::atomic<bool> done{false};
  std::thread busy([&] {
    while (!done) out->publish(text_record("x"));
  });
  const auto knows_nothing = [&] {
    return out->stats().published == 0 && out->connections().empty() &&
           out->memory()->stats().segments == 0 && connection->stats().sent == 0 &&
           connection->last_failure().text().empty() && connection->take_undelivered().empty() &&
           inspect(*connection).held.empty();
  };
  for (int i = 0; i < 20; ++i) {
    const pid_t child = in_child([&] {
      ::alarm(10);
      return knows_nothing() ? 0 : 1;
    });
    EXPECT_EQ(exit_status(child), 0);
  }
  done = true;
  busy.join();
  EXPECT_EQ(out->connections().size(), 1u);
}

// What the child writes there never comes into the file that a subscriber maps, and its parent may use the block again.
TEST(Lifetime, a_forked_child_does_not_share_its_parents_memory) {
  const auto memory = memory_of(4 * mb);
  const BufferPtr buffer = filled(*memory, mb, 1), other = filled(*memory, mb, 1);
  const RecordPtr earlier = text_record("made before", {other});
  EXPECT_FALSE(buffer->inherited());
  const pid_t child = in_child([&] {
    std::memset(buffer->data(), 2, buffer->size());
    if (!buffer->inherited() || text_record("x", {buffer})) return 1;
    const auto mine = publisher();
    Inbox own(mine->address());
    if (mine->publish(earlier) != 0) return 2;
    if (mine->connections()[0]->last_failure().text().find("forked") == std::string::npos) return 3;
    const BufferPtr copy = mine->memory()->allocate(mb);
    std::memcpy(copy->data(), buffer->data(), mb);
    if (mine->publish(text_record("copied", {copy})) != 1 || !own.wait_for(1)) return 4;
    return control_of(own.messages()[0]) == "copied" && all_bytes_are(own.messages()[0]->blocks()[0], 2) ? 0
                                                                                                         : 5;
  });
  EXPECT_EQ(exit_status(child), 0);
}

TEST(Lifetime, a_forked_child_can_start_its_own) {
  const auto out = publisher();
  Inbox in(out->address());
  const std::string parents_address = out->address();
  const pid_t child = in_child([&] {
    const auto mine = publisher();
    Inbox own(mine->address()), parents(parents_address);
    mine->publish(text_record("x", {filled(*mine->memory(), mb, 8)}));
    return own.wait_for(1) && parents.subscriber && out->publish(text_record("not mine")) == 0 ? 0 : 1;
  });
  EXPECT_EQ(exit_status(child), 0);
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
