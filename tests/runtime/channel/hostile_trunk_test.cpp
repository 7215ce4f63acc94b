// SPDX-License-Identifier: BSD-3-Clause
// Processes that lie about a trunk, or over it.
#include <algorithm>

#include "channel/connect/trunk.h"
#include "channel/wire/shared_page.h"
#include "few_descriptors.h"
#include "posix/address.h"
#include "posix/memory_file.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

#ifndef TZC_PORTABLE

/// A subscriber's process that says what it likes over a trunk, which it got as an honest one does.
class HostileTrunk : public ::testing::Test {
 protected:
  void SetUp() override {
    Hello hello{PacketKind::hello, wire_magic, wire_version, 0, is_trunk};
    hello.trunk_number = 8;
    trunk_.send(hello);
    ASSERT_EQ(trunk_.receive(), posix::ReceiveResult::packet);
    ASSERT_EQ(trunk_.kind(), PacketKind::trunk_welcome);
    id_ = trunk_.as<TrunkWelcome>().id;
  }

  Hello hello(std::uint32_t number) const {
    Hello hello = hello_to(out_->address(), reads_ring | has_doorbell | has_trunk);
    hello.doorbell_bytes = static_cast<std::uint32_t>(bell_->size());
    hello.trunk = id_;
    hello.trunk_number = number;
    return hello;
  }
  /// What the publisher says to it.
  PacketKind greet(const Hello& hello) {
    connections_.push_back(RawPeer::connect(out_->address()));
    connections_.back().send(hello, {bell_->fd()});
    EXPECT_EQ(connections_.back().receive(), posix::ReceiveResult::packet);
    return connections_.back().kind();
  }
  void say(TrunkWord word, std::uint32_t number) { trunk_.send(WordPacket{PacketKind::word, word, number}); }
  bool has_connections(std::size_t count) {
    return eventually([&] { return out_->connections().size() == count; });
  }

  const std::shared_ptr<Publisher> out_ = publisher();
  RawPeer trunk_ = RawPeer::connect(out_->address());
  std::uint64_t id_ = 0;
  const std::shared_ptr<Doorbell> bell_ = *Doorbell::create();
  std::vector<RawPeer> connections_;
};

TEST_F(HostileTrunk, a_trunk_that_is_not_there_is_refused) {
  Hello forged = hello(1);
  forged.trunk ^= 1;
  EXPECT_EQ(greet(forged), PacketKind::refusal);
  EXPECT_EQ(greet(hello(1)), PacketKind::welcome);
}

TEST_F(HostileTrunk, of_another_process_is_refused) {
  const pid_t child = in_child([&] { return greet(hello(1)) == PacketKind::refusal ? 0 : 1; });
  EXPECT_EQ(exit_status(child), 0);
}

TEST_F(HostileTrunk, a_number_is_one_connections) {
  EXPECT_EQ(greet(hello(1)), PacketKind::welcome);
  EXPECT_EQ(greet(hello(1)), PacketKind::refusal);
  ASSERT_TRUE(has_connections(1));
  say(TrunkWord::gone, 1);
  ASSERT_TRUE(has_connections(0));
  EXPECT_EQ(greet(hello(1)), PacketKind::welcome);
}

TEST_F(HostileTrunk, words_about_nobody_or_of_publishers_change_nothing) {
  EXPECT_EQ(greet(hello(1)), PacketKind::welcome);
  say(TrunkWord::gone, 2);
  say(TrunkWord::lend, 1);
  say(TrunkWord::end, 1);
  say(static_cast<TrunkWord>(99), 1);
  out_->publish(text_record("x"));
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_TRUE(has_connections(1));
}

TEST_F(HostileTrunk, anything_else_ends_its_connections_alone) {
  const auto honest = inbox(out_->address());
  EXPECT_EQ(greet(hello(1)), PacketKind::welcome);
  EXPECT_EQ(greet(hello(2)), PacketKind::welcome);
  ASSERT_TRUE(has_connections(3));
  trunk_.send("nonsense", 8);
  ASSERT_TRUE(has_connections(1));
  out_->publish(text_record(large_text(1)));
  EXPECT_TRUE(honest->wait_for(1));
}

TEST_F(HostileTrunk, one_that_reads_nothing_holds_nobody_up) {
  const auto honest = inbox(out_->address());
  for (std::uint32_t i = 1; i <= 100; ++i) EXPECT_EQ(greet(hello(i)), PacketKind::welcome);
  ASSERT_TRUE(has_connections(101));
  for (int i = 0; i < 20; ++i) {
    out_->publish(text_record(large_text(i)));
    ASSERT_TRUE(honest->wait_for(i + 1));
  }
}

TEST_F(HostileTrunk, one_that_closes_its_loans_loses_them) {
  EXPECT_EQ(greet(hello(1)), PacketKind::welcome);
  ASSERT_TRUE(has_connections(1));
  out_->publish(text_record(large_text(1)));
  ASSERT_EQ(trunk_.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(trunk_.as<WordPacket>().word, TrunkWord::lend);
  trunk_.packet = posix::ReceivedPacket();
  EXPECT_TRUE(eventually([&] { return out_->stats().subscribers == 0; }));
  say(TrunkWord::gone, 1);
  EXPECT_TRUE(has_connections(0));
}

// It claims to have read what it was lent, and does not take it from the trunk.
TEST_F(HostileTrunk, one_that_reads_nothing_and_says_it_did_collects_no_sockets_here) {
  constexpr std::uint32_t connections = 40;
  std::vector<posix::Mapping> pages;
  for (std::uint32_t i = 1; i <= connections; ++i) {
    ASSERT_EQ(greet(hello(i)), PacketKind::welcome);
    const int page = connections_.back().packet.descriptors[0].get();
    pages.push_back(std::move(*posix::Mapping::map(page, posix::page_size(), posix::Access::read_write)));
  }
  ASSERT_TRUE(has_connections(connections));
  const int before = open_descriptors();
  const FewDescriptors few(static_cast<rlim_t>(before) + 300);
  int most = 0;  // more words than a socket holds
  for (int i = 0; i < 3000; ++i) {
    out_->publish(text_record(large_text(i)));
    for (const posix::Mapping& page : pages) {
      Ring& ring = reinterpret_cast<ConnectionPage*>(page.data())->ring;
      ring.subscriber.packets_read.store(ring.publisher.packets.load());
    }
    most = std::max(most, open_descriptors());
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  EXPECT_LE(most, before + 3 * 8);
}

TEST_F(HostileTrunk, it_is_lent_no_more_than_it_takes) {
  RawPeer modest = RawPeer::connect(out_->address());
  Hello takes_one{PacketKind::hello, wire_magic, wire_version, 0, is_trunk};
  takes_one.trunk_number = 1;
  modest.send(takes_one);
  ASSERT_EQ(modest.receive(), posix::ReceiveResult::packet);
  id_ = modest.as<TrunkWelcome>().id;
  EXPECT_EQ(greet(hello(1)), PacketKind::welcome);
  EXPECT_EQ(greet(hello(2)), PacketKind::welcome);
  ASSERT_TRUE(has_connections(2));
  out_->publish(text_record(large_text(1)));
  ASSERT_EQ(modest.receive(), posix::ReceiveResult::packet);
  const std::uint32_t first = modest.as<WordPacket>().number;
  EXPECT_FALSE(modest.is_readable_within(milliseconds(100)));
  modest.packet = posix::ReceivedPacket();
  modest.send(WordPacket{PacketKind::word, TrunkWord::gone, first});
  ASSERT_EQ(modest.receive(), posix::ReceiveResult::packet);
  EXPECT_NE(modest.as<WordPacket>().number, first);
}

/// Opens trunks and subscribes to nothing; how many it got.
int useless_trunks(const std::string& address, int count, std::vector<RawPeer>& trunks) {
  int accepted = 0;
  for (int i = 0; i < count; ++i) {
    trunks.push_back(RawPeer::connect(address));
    trunks.back().send(Hello{PacketKind::hello, wire_magic, wire_version, 0, is_trunk});
    trunks.back().receive();
    accepted += trunks.back().kind() == PacketKind::trunk_welcome ? 1 : 0;
  }
  return accepted;
}

TEST_F(HostileTrunk, those_without_a_connection_are_limited) {
  std::vector<RawPeer> trunks;
  EXPECT_LE(useless_trunks(out_->address(), 300, trunks), 256);
  trunks.clear();
  EXPECT_TRUE(eventually([&] { return inbox(out_->address())->subscriber != nullptr; }));
}

TEST(UselessTrunks, another_users_are_few_and_keep_nobody_else_away_in_a_child) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root to become another user";
  PublisherOptions options;
  options.authorize = [](const Credentials& peer, const std::string&) { return peer.uid == ::geteuid(); };
  const auto out = publish_with(std::move(options));
  const pid_t child = in_child([&] {
    std::vector<RawPeer> trunks;
    if (::setuid(65534) != 0) return 1;
    return useless_trunks(out->address(), 40, trunks) <= 16 && inbox(out->address())->error != "" ? 0 : 2;
  });
  EXPECT_EQ(exit_status(child), 0);
  EXPECT_TRUE(inbox(out->address())->subscriber);
}

/// A publisher's process that says what it likes over a trunk.
class LyingLender : public ::testing::Test {
 protected:
  void SetUp() override {
    std::thread server([&] {
      peer_ = std::make_unique<RawPeer>(accept_at(listener_));
      trunk_ = std::make_unique<RawPeer>(accept_trunk_at(listener_));
      peer_->receive();
      number_ = peer_->as<Hello>().trunk_number;
      auto page = posix::create_memory_file("page", posix::page_size(), posix::Sharing::peers_write);
      page_ = std::move(*posix::Mapping::map(page->descriptor.get(), page->size, posix::Access::read_write));
      new (page_.data()) ConnectionPage();
      posix::seal(*page, posix::Sharing::peers_write);
      peer_->send(Welcome{PacketKind::welcome, wire_version, 0, static_cast<std::uint32_t>(page->size),
                          reads_ring | has_trunk},
                  {page->descriptor.get()});
    });
    in_ = inbox(listener_.address());
    server.join();
    ASSERT_TRUE(in_->subscriber) << in_->error;
  }

  void say(TrunkWord word, std::uint32_t number, const std::vector<int>& socket = {}) const {
    trunk_->send(WordPacket{PacketKind::word, word, number}, socket);
  }
  void lend() {
    posix::SocketPair pair = posix::make_socket_pair();
    say(TrunkWord::lend, number_, {pair.theirs.get()});
    lent_.push_back(std::move(pair.ours));
  }

  posix::Listener listener_ = std::move(*posix::Listener::listen(posix::generate_address()));
  std::unique_ptr<RawPeer> peer_;
  std::unique_ptr<RawPeer> trunk_;
  std::uint32_t number_ = 0;
  posix::Mapping page_;
  std::vector<posix::FileDescriptor> lent_;
  std::unique_ptr<Inbox> in_;
};

TEST(Trunk, who_listens_after_its_end_is_told) {
  posix::SocketPair pair = posix::make_socket_pair();
  const auto trunk = *Trunk::start(**Service::instance(), std::move(pair.ours), {{}, 1, false});
  const auto place = trunk->take(1);
  pair.theirs.reset();
  ASSERT_TRUE(eventually([&] { return trunk->take_any() == nullptr; }));
  EXPECT_FALSE(place->listen({}));
}

TEST_F(LyingLender, end_is_heard) {
  say(TrunkWord::end, number_);
  EXPECT_TRUE(in_->wait_for_end());
}

TEST_F(LyingLender, its_end_is_the_end) {
  trunk_.reset();
  EXPECT_TRUE(in_->wait_for_end());
}

TEST_F(LyingLender, more_sockets_than_an_honest_one_lends_are_the_end) {
  lend();  // beside the connection's own
  lend();
  EXPECT_TRUE(in_->wait_for_end());
}

TEST_F(LyingLender, a_loan_without_a_socket_is_the_end) {
  say(TrunkWord::lend, number_);
  ASSERT_TRUE(in_->wait_for_end());
  EXPECT_NE(in_->reason().find("did not arrive"), std::string::npos)
      << "a subscriber without descriptors learns nothing of it otherwise: " << in_->reason();
}

TEST_F(LyingLender, words_about_nobody_are_nothing) {
  for (std::uint32_t i = 1; i <= 100; ++i) say(TrunkWord::end, number_ + i);
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_TRUE(in_->reason().empty());
}

TEST_F(LyingLender, half_a_word_is_the_end) {
  trunk_->send("half", 4);
  EXPECT_TRUE(in_->wait_for_end());
}

// It announces packets that never come, or ends of loans without number.
TEST_F(LyingLender, packets_that_never_come_are_waited_for_without_noise) {
  Ring& ring = reinterpret_cast<ConnectionPage*>(page_.data())->ring;
  ring.publisher.packets.fetch_add(1000);
  peer_.reset();
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_TRUE(in_->reason().empty());
  say(TrunkWord::end, number_);
  EXPECT_TRUE(in_->wait_for_end());
}

#endif

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
