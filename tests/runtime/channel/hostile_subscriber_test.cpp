// SPDX-License-Identifier: BSD-3-Clause
// Subscribers that lie: whatever they send or scribble, the publisher goes on and gives nothing away.
#include <sys/mman.h>

#include "posix/mapping.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

void expect_going_on(Publisher& out) {
  Inbox in(out.address());
  ASSERT_TRUE(in.subscriber) << in.error;
  ASSERT_TRUE(eventually([&] { return out.stats().subscribers >= 1; }));
  out.publish(text_record("still here", {filled(*out.memory(), 1000, 1)}));
  EXPECT_TRUE(in.wait_for(1));
}

TEST(HostileSubscriber, a_greeting_of_another_protocol_is_refused) {
  const auto out = publisher();
  RawPeer peer = RawPeer::connect(out->address());
  peer.send("GET / HTTP/1.1\r\n\r\n", 18);
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(peer.kind(), PacketKind::refusal);
  EXPECT_EQ(peer.receive(), posix::ReceiveResult::closed);
  EXPECT_EQ(out->stats().refused_peers, 1u);
  expect_going_on(*out);
}

TEST(HostileSubscriber, another_version_is_told_which_one_is_old) {
  const auto out = publisher();
  RawPeer peer = RawPeer::connect(out->address());
  peer.send(Hello{PacketKind::hello, wire_magic, wire_version + 1, 0, 0});
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_NE(peer.text(sizeof(Refusal)).find("update the older one"), std::string::npos);
}

TEST(HostileSubscriber, silent_peers_hold_nobody_up) {
  const auto out = publisher();
  std::vector<RawPeer> silent;
  for (int i = 0; i < 300; ++i) silent.push_back(RawPeer::connect(out->address()));
  EXPECT_TRUE(eventually([&] { return out->stats().accept_failures > 0; })) << "more than may wait at a time";
  silent.clear();
  // Their places are free as soon as the service thread has seen them go; until then others are turned away,
  // too.
  SubscriberOptions next;
  next.address = out->address();
  next.own_thread = false;
  EXPECT_TRUE(eventually([&] { return static_cast<bool>(Subscriber::create(next)); }));
  expect_going_on(*out);
}

TEST(HostileSubscriber, one_that_talks_is_cut_off) {
  const auto out = publisher();
  RawPeer peer = RawPeer::connect(out->address());
  peer.send(hello_to(out->address()));
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(peer.kind(), PacketKind::welcome);
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
  peer.send("something", 9);
  EXPECT_TRUE(eventually([&] { return out->connections().empty(); }));
  expect_going_on(*out);
}

TEST(HostileSubscriber, scribbling_over_acknowledgements_hurts_only_itself) {
  const auto out = publisher(4, 4 * mb, Policy::best_effort());
  {
    RawPeer peer = RawPeer::connect(out->address());
    peer.send(hello_to(out->address()));
    ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
    auto page = posix::Mapping::map(peer.packet.descriptors[0].get(), 4096, posix::Access::read_write);
    ASSERT_TRUE(page);
    ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
    out->publish(text_record("x", {filled(*out->memory(), 1000, 1)}));
    ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
    ASSERT_EQ(peer.kind(), PacketKind::segment);
    auto acks = posix::Mapping::map(peer.packet.descriptors[1].get(), 4096, posix::Access::read_write);
    ASSERT_TRUE(acks);
    std::memset(acks->data(), 0x5a, 4096);
    for (int i = 0; i < 100; ++i) {
      std::memset(page->data(), i, 8);
      const BufferPtr buffer = filled(*out->memory(), 100'000, 1);
      if (buffer) out->publish(text_record("x", {buffer}));
    }
  }
  EXPECT_TRUE(eventually([&] { return static_cast<bool>(out->memory()->allocate(4 * mb)); }, 1000));
  expect_going_on(*out);
}

// The publisher looks at blocks that a subscriber hints at. Whatever a subscriber wrote there, its end is noticed.
TEST(HostileSubscriber, forged_hints_hide_nothing) {
  constexpr int blocks = 20;  // more than each allocate looks at anyway
  for (const std::uint64_t forged :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0xf0f0}, ~std::uint64_t{0}}) {
    const auto out = publisher(blocks, mb);
    {
      RawPeer peer = RawPeer::connect(out->address());
      peer.send(hello_to(out->address()));
      ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
      ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
      for (int i = 0; i < blocks; ++i) out->publish(text_record("x", {filled(*out->memory(), mb / 32, 1)}));
      ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
      auto acks = posix::Mapping::map(peer.packet.descriptors[1].get(), 4096, posix::Access::read_write);
      ASSERT_TRUE(acks);
      auto* header = reinterpret_cast<segment::AckHeader*>(acks->data());
      auto* leaves = reinterpret_cast<std::atomic<std::uint64_t>*>(acks->data() + segment::ack_header_bytes);
      const auto hint = [&](std::uint64_t bits) { header->released = leaves[0] = leaves[1] = bits; };
      hint(~std::uint64_t{0});
      EXPECT_FALSE(out->memory()->allocate(mb)) << "looked through in vain";
      hint(forged);
    }
    ASSERT_TRUE(eventually([&] { return out->connections().empty(); }));
    EXPECT_TRUE(out->memory()->allocate(mb)) << forged;
  }
}

TEST(HostileSubscriber, forged_hints_hide_no_revocation) {
  constexpr int blocks = 20;  // more than each allocate looks at anyway
  for (const std::uint64_t forged :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0xf0f0}, ~std::uint64_t{0}}) {
    const auto out = publisher(blocks, mb);
    RawPeer peer = RawPeer::connect(out->address());
    peer.send(hello_to(out->address()));
    ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
    ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
    for (int i = 0; i < blocks; ++i) out->publish(text_record("x", {filled(*out->memory(), mb / 32, 1)}));
    ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
    auto acks = posix::Mapping::map(peer.packet.descriptors[1].get(), 4096, posix::Access::read_write);
    ASSERT_TRUE(acks);
    auto* header = reinterpret_cast<segment::AckHeader*>(acks->data());
    auto* leaves = reinterpret_cast<std::atomic<std::uint64_t>*>(acks->data() + segment::ack_header_bytes);
    const auto hint = [&](std::uint64_t bits) { header->released = leaves[0] = leaves[1] = bits; };
    hint(~std::uint64_t{0});
    EXPECT_FALSE(out->memory()->allocate(mb)) << "looked through in vain";
    hint(forged);
    for (int i = 0; i < blocks; ++i) out->publish(text_record("without a block"));  // revokes those with one
    EXPECT_TRUE(out->memory()->allocate(mb)) << forged;
  }
}

// What a process makes writable is its own copy.
TEST(HostileSubscriber, data_that_is_made_writable_is_a_copy) {
  const auto out = publisher();
  Inbox in(out->address());
  const BufferPtr buffer = filled(*out->memory(), mb, 1);
  out->publish(text_record("x", {buffer}));
  ASSERT_TRUE(in.wait_for(1));
  const MessagePtr message = in.messages()[0];
  auto* data = const_cast<std::uint8_t*>(message->blocks()[0].data);
  ASSERT_EQ(::mprotect(data, 4096, PROT_READ | PROT_WRITE), 0);
  std::memset(data, 2, 4096);
  EXPECT_TRUE(all_bytes_are(ConstBlock{buffer->data(), buffer->size()}, 1));
}

// Only root may become another user, so a normal user's run leaves this test and the one with another user's silence out;
// a run as root, as in a clean root or a container, has both.
TEST(HostileSubscriber, another_users_process_is_refused_in_a_child) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root to become another user";
  PublisherOptions options;
  options.address = "@tzc-other-user-" + std::to_string(::getpid());
  const auto out = publish_with(options);
  const pid_t child = in_child([&] {
    if (::setuid(65534) != 0) return 1;
    Inbox in(options.address);
    return !in.subscriber && in.error.find("only processes of the publisher's user") != std::string::npos ? 0
                                                                                                          : 2;
  });
  EXPECT_EQ(exit_status(child), 0);
}

// A publisher that looks at the hello itself accepts connections of every user, and has to wait for what they say.
TEST(HostileSubscriber, another_users_silence_keeps_nobody_else_away) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root to become another user";
  PublisherOptions options;
  options.authorize = [](const Credentials& peer, const std::string&) { return peer.uid == ::geteuid(); };
  const auto out = publish_with(std::move(options));
  int done[2];
  ASSERT_EQ(::pipe(done), 0);
  const pid_t child = in_child([&] {
    if (::setuid(65534) != 0) return 1;
    std::vector<RawPeer> silent;
    for (int i = 0; i < 300; ++i) silent.push_back(RawPeer::connect(out->address()));
    char byte = 0;
    if (::write(done[1], &byte, 1) != 1) return 1;
    ::pause();
    return 0;
  });
  char byte = 0;
  EXPECT_EQ(::read(done[0], &byte, 1), 1);
#ifndef TZC_PORTABLE  // there the file mode of the socket keeps other users out
  EXPECT_TRUE(eventually([&] { return out->stats().accept_failures >= 200; }, 60000))
      << "a few of another user may wait";
#endif
  Inbox in(out->address());
  EXPECT_TRUE(in.subscriber) << in.error;
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(done[0]);
  ::close(done[1]);
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
