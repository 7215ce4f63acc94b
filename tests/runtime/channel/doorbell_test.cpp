// SPDX-License-Identifier: BSD-3-Clause
// One thread that reads for many subscribers, the doorbell at which it sleeps, and peers that lie about it.
#include "channel/wait/doorbell.h"

#include <atomic>
#include <fstream>
#include <set>

#include "channel/wait/receiver.h"
#include "channel/wire/shared_page.h"
#include "posix/address.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

#ifndef TZC_PORTABLE

int reading_threads() {
  int count = 0;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(thread.path() / "comm"), name);
    count += name == "tzc-reader" ? 1 : 0;
  }
  return count;
}

SubscriberOptions shared_options(const std::string& address,
                                 std::function<void(const MessagePtr&)> on_message) {
  SubscriberOptions options;
  options.address = address;
  options.shared_thread = true;
  options.on_message = std::move(on_message);
  return options;
}

std::shared_ptr<Subscriber> subscribe(SubscriberOptions options) {
  auto created = Subscriber::create(std::move(options));
  EXPECT_TRUE(created) << created.error().text();
  return *created;
}

Expected<std::shared_ptr<Doorbell>> opened(const Doorbell& doorbell, std::size_t size) {
  return Doorbell::open(posix::FileDescriptor(::dup(doorbell.fd())), size);
}

TEST(Doorbell, is_one_object_for_all_connections_to_a_process) {
  const auto mine = *Doorbell::create(), other = *Doorbell::create();
  const auto first = *opened(*mine, mine->size()), second = *opened(*mine, mine->size());
  EXPECT_EQ(first, second);
  EXPECT_NE(first, *opened(*other, other->size()));
  first->ring(70);
  EXPECT_EQ(mine->page().bell, 1u);
  EXPECT_EQ(mine->page().groups, 2u);
  EXPECT_EQ(mine->page().leaves[1], std::uint64_t{1} << 6);
}

TEST(Doorbell, a_file_of_another_size_is_refused) {
  const auto mine = *Doorbell::create();
  EXPECT_FALSE(opened(*mine, sizeof(DoorbellPage) - 1));
  EXPECT_FALSE(opened(*mine, mine->size() * 2));
  EXPECT_FALSE(opened(*mine, std::size_t{2} << 20));
}

TEST(Doorbell, numbers_run_out_and_come_back) {
  Receiver& receiver = **Receiver::instance();
  std::set<std::uint32_t> values;
  std::vector<std::shared_ptr<DoorbellNumber>> numbers;
  while (auto number = receiver.take_number()) numbers.push_back(std::move(number));
  for (const auto& number : numbers) values.insert(number->value());
  EXPECT_EQ(values.size(), numbers.size());
  EXPECT_EQ(*values.rbegin(), doorbell_numbers - 1);
  const std::uint32_t given_back = numbers[100]->value();
  numbers[100].reset();
  EXPECT_EQ(receiver.take_number()->value(), given_back);
}

TEST(SharedThread, reads_for_every_subscriber_of_the_process) {
  std::vector<std::shared_ptr<Publisher>> out;
  std::vector<std::unique_ptr<Inbox>> in;
  for (int i = 0; i < 10; ++i) out.push_back(publisher(20));
  for (int i = 0; i < 70; ++i) {  // more than one leaf of the doorbell has bits
    in.push_back(std::make_unique<Inbox>(out[static_cast<std::size_t>(i) % out.size()]->address()));
    ASSERT_TRUE(in.back()->subscriber) << in.back()->error;
  }
  if (on_shared_thread()) {
    EXPECT_EQ(reading_threads(), 1);
  }
  for (int round = 0; round < 20; ++round)
    for (const auto& each : out)
      each->publish(text_record(std::to_string(round), {filled(*each->memory(), 5000, 1)}));
  for (const auto& each : in) {
    ASSERT_TRUE(each->wait_for(20));
    const auto messages = each->messages();
    for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(control_of(messages[i]), std::to_string(i));
  }
}

TEST(SharedThread, one_that_may_not_begin_delays_no_other_and_loses_nothing) {
  const auto out = publisher(10);
  std::atomic<bool> may_begin{false};
  std::atomic<int> asked{0}, received{0};
  SubscriberOptions options = shared_options(out->address(), [&](const MessagePtr&) { ++received; });
  options.may_begin = [&] {
    ++asked;
    return may_begin.load();
  };
  const auto waiting = subscribe(options);
  Inbox other(out->address());
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(asked, 0) << "nothing has come";
  for (int i = 0; i < 5; ++i) out->publish(text_record(std::to_string(i), {filled(*out->memory(), 100, 1)}));
  EXPECT_TRUE(other.wait_for(5));
  EXPECT_TRUE(eventually([&] { return asked >= 3; }));
  EXPECT_EQ(received, 0);
  may_begin = true;
  EXPECT_TRUE(eventually([&] { return received == 5; }));
  const int asked_until_then = asked;
  out->publish(text_record("another"));
  EXPECT_TRUE(eventually([&] { return received == 6; }));
  EXPECT_EQ(asked, asked_until_then) << "once it began";
}

TEST(SharedThread, one_that_never_begins_can_go) {
  const auto out = publisher(10);
  SubscriberOptions options = shared_options(out->address(), [](const MessagePtr&) {});
  options.may_begin = [] { return false; };
  auto in = subscribe(options);
  out->publish(text_record("x"));
  in.reset();
  EXPECT_TRUE(eventually([&] { return out->connections().empty(); }));
}

TEST(SharedThread, a_subscriber_may_end_another_one_in_its_callback) {
  const auto out = publisher(), other = publisher();
  std::mutex mutex;
  std::shared_ptr<Subscriber> victim;
  std::atomic<int> late{0};
  std::atomic<bool> ended{false};
  {
    const std::lock_guard<std::mutex> lock(mutex);
    victim = subscribe(shared_options(other->address(), [&](const MessagePtr&) { late += ended ? 1 : 0; }));
  }
  const auto in = subscribe(shared_options(out->address(), [&](const MessagePtr&) {
    const std::lock_guard<std::mutex> lock(mutex);
    victim.reset();
    ended = true;
  }));
  out->publish(text_record("end it"));
  ASSERT_TRUE(eventually([&] { return ended.load(); }));
  for (int i = 0; i < 10; ++i) other->publish(text_record("too late"));
  EXPECT_TRUE(eventually([&] { return other->connections().empty(); }));
  EXPECT_EQ(late, 0);
}

TEST(SharedThread, the_end_of_a_subscriber_waits_for_its_callback_alone) {
  const auto out = publisher();
  std::atomic<bool> inside{false}, go{false}, left{false};
  auto slow = subscribe(shared_options(out->address(), [&](const MessagePtr&) {
    inside = true;
    while (!go) std::this_thread::yield();
    left = true;
  }));
  const auto silent = publisher();
  auto idle = subscribe(shared_options(silent->address(), [](const MessagePtr&) {}));
  out->publish(text_record("x"));
  ASSERT_TRUE(eventually([&] { return inside.load(); }));
  idle.reset();  // returns while the other callback runs
  std::thread ending([&] {
    slow.reset();
    EXPECT_TRUE(left);
  });
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_FALSE(left);
  go = true;
  ending.join();
}

TEST(SharedThread, a_slow_subscriber_with_its_own_delays_no_other) {
  const auto out = publisher();
  std::atomic<bool> inside{false}, go{false};
  SubscriberOptions options = shared_options(out->address(), [&](const MessagePtr&) {
    inside = true;
    while (!go) std::this_thread::yield();
  });
  options.shared_thread = false;
  const auto slow = subscribe(options);
  std::atomic<int> received{0};
  const auto quick = subscribe(shared_options(out->address(), [&](const MessagePtr&) { ++received; }));
  for (int i = 0; i < 3; ++i) out->publish(text_record("x"));
  EXPECT_TRUE(eventually([&] { return inside && received == 3; }));
  go = true;
}

TEST(SharedThread, the_publishers_end_is_noticed) {
  auto out = publisher();
  Inbox in(out->address());
  out.reset();
  EXPECT_TRUE(in.wait_for_end());
}

/// A subscriber on the shared thread, whose publisher is the test.
class HostileRinger : public ::testing::Test {
 protected:
  void SetUp() override {
    listener_ = std::move(*posix::Listener::listen(posix::generate_address()));
    std::thread server([&] { welcome(); });
    in_ = subscribe(shared_options(listener_.address(), [this](const MessagePtr&) { ++received_; }));
    server.join();
  }

  void welcome() {
    peer_ = std::make_unique<RawPeer>(accept_at(listener_));
    trunk_ = std::make_unique<RawPeer>(accept_trunk_at(listener_));
    peer_->receive();
    const Hello hello = peer_->as<Hello>();
    bell_ = {*Doorbell::open(std::move(peer_->packet.descriptors[0]), hello.doorbell_bytes),
             hello.doorbell_number};
    auto page = posix::create_memory_file("page", posix::page_size(), posix::Sharing::peers_write);
    page_ = std::move(*posix::Mapping::map(page->descriptor.get(), page->size, posix::Access::read_write));
    new (page_.data()) ConnectionPage();
    posix::seal(*page, posix::Sharing::peers_write);
    peer_->send(
        Welcome{PacketKind::welcome, wire_version, 0, static_cast<std::uint32_t>(page->size), reads_ring},
        {page->descriptor.get()});
  }

  /// An empty record in the ring; rung by a bell that no thread hears.
  void write_silently() {
    struct {
      RecordPrefix prefix;
      BodyHeader header;
    } packet{{PacketKind::record, ++sequence_}, {}};
    writer().write(&packet, sizeof packet, "", 0);
  }
  RingWriter& writer() {
    if (!writer_)
      writer_ = std::make_unique<RingWriter>(&reinterpret_cast<ConnectionPage*>(page_.data())->ring);
    return *writer_;
  }

  posix::Listener listener_;
  std::unique_ptr<RawPeer> peer_;
  std::unique_ptr<RawPeer> trunk_;
  BellPull bell_;
  posix::Mapping page_;
  std::unique_ptr<RingWriter> writer_;
  std::uint32_t sequence_ = 0;
  std::atomic<int> received_{0};
  std::shared_ptr<Subscriber> in_;
};

TEST_F(HostileRinger, one_that_does_not_ring_is_read_all_the_same) {
  for (int i = 1; i <= 2; ++i) {
    write_silently();
    EXPECT_TRUE(eventually([&] { return received_ == i; }));
  }
}

TEST_F(HostileRinger, bits_and_bells_of_others_change_nothing_but_time) {
  std::atomic<bool> done{false};
  std::thread scribbler([&] {
    DoorbellPage& page = bell_.doorbell->page();
    for (std::uint32_t i = 0; !done; ++i) {
      bell_.doorbell->ring(i * 37 % doorbell_numbers);
      page.leaves[i % 8] = 0;
      page.sleeping = i;
      page.groups = i % 3 == 0 ? ~std::uint64_t{0} : 0;
      page.bell = i % 2;
      std::this_thread::yield();
    }
  });
  const auto out = publisher(100);
  Inbox honest(out->address());
  for (int i = 0; i < 50; ++i) out->publish(text_record(std::to_string(i)));
  EXPECT_TRUE(honest.wait_for(50));
  done = true;
  scribbler.join();
}

/// The refusal of a publisher to a hello that names a doorbell.
std::string refusal_of(Hello hello, const std::vector<int>& descriptors) {
  const auto out = publisher();
  hello.publication = parse_publisher_address(out->address())->publication;
  RawPeer peer = RawPeer::connect(out->address());
  peer.send(hello, descriptors);
  EXPECT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(peer.kind(), PacketKind::refusal);
  return peer.text(sizeof(Refusal));
}

TEST(HostileDoorbell, is_refused_with_the_reason) {
  const auto mine = *Doorbell::create();
  Hello hello{PacketKind::hello, wire_magic, wire_version, 0, reads_ring | has_doorbell};
  hello.doorbell_bytes = static_cast<std::uint32_t>(mine->size());
  EXPECT_NE(refusal_of(hello, {}).find("without its file"), std::string::npos);
  hello.doorbell_number = doorbell_numbers;
  EXPECT_NE(refusal_of(hello, {mine->fd()}).find("number 4096"), std::string::npos);
  hello.doorbell_number = 0;
  hello.doorbell_bytes *= 2;
  EXPECT_NE(refusal_of(hello, {mine->fd()}).find("size"), std::string::npos);
  const auto open = *posix::create_memory_file("open", mine->size(), posix::Sharing::peers_write);
  hello.doorbell_bytes = static_cast<std::uint32_t>(mine->size());
  EXPECT_NE(refusal_of(hello, {open.descriptor.get()}).find("not sealed"), std::string::npos);
}

#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
