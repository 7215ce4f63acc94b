// SPDX-License-Identifier: BSD-3-Clause
// Subscribers that lie: whatever they send or scribble, the publisher goes on and gives nothing away.
#include <sys/mman.h>

#include "posix/mapping.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

constexpr Hello good_hello{PacketKind::hello, wire_magic, wire_version, 0, 0};

void expect_going_on(Publisher& out) {
  Inbox in(out.address());
  ASSERT_TRUE(in.subscriber) << in.error;
  ASSERT_TRUE(eventually([&] { return out.stats().subscribers >= 1; }));
  out.publish(text_record("still here", {filled(*out.memory(), 1000, 1)}));
  EXPECT_TRUE(in.wait_for(1));
}

TEST(HostileSubscriber, AGreetingOfAnotherProtocolIsRefused) {
  const auto out = publisher();
  RawPeer peer = RawPeer::connect(out->address());
  peer.send("GET / HTTP/1.1\r\n\r\n", 18);
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(peer.kind(), PacketKind::refusal);
  EXPECT_EQ(peer.receive(), posix::ReceiveResult::closed);
  EXPECT_EQ(out->stats().refused_peers, 1u);
  expect_going_on(*out);
}

TEST(HostileSubscriber, AnotherVersionIsToldWhichOneIsOld) {
  const auto out = publisher();
  RawPeer peer = RawPeer::connect(out->address());
  peer.send(Hello{PacketKind::hello, wire_magic, wire_version + 1, 0, 0});
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_NE(peer.text(sizeof(Refusal)).find("update the older one"), std::string::npos);
}

TEST(HostileSubscriber, SilentPeersHoldNobodyUp) {
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

TEST(HostileSubscriber, OneThatTalksIsCutOff) {
  const auto out = publisher();
  RawPeer peer = RawPeer::connect(out->address());
  peer.send(good_hello);
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(peer.kind(), PacketKind::welcome);
  ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
  peer.send("something", 9);
  EXPECT_TRUE(eventually([&] { return out->connections().empty(); }));
  expect_going_on(*out);
}

TEST(HostileSubscriber, ScribblingOverAcknowledgementsHurtsOnlyItself) {
  const auto out = publisher(4, 4 * mb, Policy::best_effort());
  {
    RawPeer peer = RawPeer::connect(out->address());
    peer.send(good_hello);
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

// The publisher looks through its blocks when a count of releases has changed. What the end of a subscriber
// adds must not be taken back by what it wrote before.
TEST(HostileSubscriber, AForgedCountOfReleasesHidesNothing) {
  constexpr int blocks = 20;  // more than each allocate looks at anyway
  for (std::uint32_t forged = 1000 - 2 * blocks; forged < 1000; ++forged) {
    const auto out = publisher(blocks, mb);
    {
      RawPeer peer = RawPeer::connect(out->address());
      peer.send(good_hello);
      ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
      ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
      for (int i = 0; i < blocks; ++i) out->publish(text_record("x", {filled(*out->memory(), mb / 32, 1)}));
      ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
      auto acks = posix::Mapping::map(peer.packet.descriptors[1].get(), 4096, posix::Access::read_write);
      ASSERT_TRUE(acks);
      std::atomic<std::uint32_t>& releases = reinterpret_cast<segment::AckHeader*>(acks->data())->releases;
      releases = 1000;
      EXPECT_FALSE(out->memory()->allocate(mb)) << "looked through in vain";
      releases = forged;
    }
    ASSERT_TRUE(eventually([&] { return out->connections().empty(); }));
    EXPECT_TRUE(out->memory()->allocate(mb)) << forged;
  }
}

TEST(HostileSubscriber, AForgedCountOfReleasesHidesNoRevocation) {
  constexpr int blocks = 20;  // more than each allocate looks at anyway
  for (std::uint32_t forged = 1000 - 2 * blocks; forged < 1000; ++forged) {
    const auto out = publisher(blocks, mb);
    RawPeer peer = RawPeer::connect(out->address());
    peer.send(good_hello);
    ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
    ASSERT_TRUE(eventually([&] { return out->connections().size() == 1; }));
    for (int i = 0; i < blocks; ++i) out->publish(text_record("x", {filled(*out->memory(), mb / 32, 1)}));
    ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
    auto acks = posix::Mapping::map(peer.packet.descriptors[1].get(), 4096, posix::Access::read_write);
    ASSERT_TRUE(acks);
    std::atomic<std::uint32_t>& releases = reinterpret_cast<segment::AckHeader*>(acks->data())->releases;
    releases = 1000;
    EXPECT_FALSE(out->memory()->allocate(mb)) << "looked through in vain";
    releases = forged;
    for (int i = 0; i < blocks; ++i) out->publish(text_record("without a block"));  // revokes those with one
    EXPECT_TRUE(out->memory()->allocate(mb)) << forged;
  }
}

TEST(HostileSubscriber, DataCanNotBeMadeWritable) {
  const auto out = publisher();
  Inbox in(out->address());
  out->publish(text_record("x", {filled(*out->memory(), mb, 1)}));
  ASSERT_TRUE(in.wait_for(1));
  const MessagePtr message = in.messages()[0];
  const auto address = reinterpret_cast<std::uintptr_t>(message->blocks()[0].data) & ~std::uintptr_t{4095};
  EXPECT_NE(::mprotect(reinterpret_cast<void*>(address), 4096, PROT_READ | PROT_WRITE), 0);
}

TEST(HostileSubscriber, AnotherUsersProcessIsRefusedInAChild) {
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

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
