// SPDX-License-Identifier: BSD-3-Clause
// Publishers of one process share a listening socket, and nothing else.
#include "channel/connect/entrance.h"

#include <sys/socket.h>

#include <set>

#include "posix/address.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

int listening_sockets() {
  int count = 0;
  for (int fd = 0; fd < 1024; ++fd) {
    int listens = 0;
    socklen_t size = sizeof listens;
    count += ::getsockopt(fd, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) == 0 && listens != 0 ? 1 : 0;
  }
  return count;
}

std::string socket_of(const std::string& address) {
  return parse_publisher_address(address)->socket;
}

TEST(Entrance, publishers_of_a_process_share_one_socket) {
  const int before = listening_sockets();
  std::vector<std::shared_ptr<Publisher>> publishers;
  std::set<std::string> addresses;
  for (int i = 0; i < 20; ++i) {
    publishers.push_back(publish_with({}));
    addresses.insert(publishers.back()->address());
    EXPECT_EQ(socket_of(publishers.back()->address()), socket_of(publishers.front()->address()));
  }
  EXPECT_EQ(addresses.size(), 20u);
  EXPECT_EQ(listening_sockets(), before + 1);
  const std::string one_of_them = publishers.back()->address();
  publishers.clear();
  EXPECT_TRUE(eventually([&] { return listening_sockets() == before; })) << "it goes with the last of them";
  EXPECT_NE(socket_of(publish_with({})->address()), socket_of(one_of_them));
}

TEST(Entrance, each_subscriber_gets_what_the_publisher_sends_that_it_names) {
  std::vector<std::shared_ptr<Publisher>> publishers;
  std::vector<std::unique_ptr<Inbox>> inboxes;
  for (int i = 0; i < 5; ++i) {
    publishers.push_back(publisher());
    inboxes.push_back(std::make_unique<Inbox>(publishers.back()->address()));
    ASSERT_TRUE(inboxes.back()->subscriber) << inboxes.back()->error;
  }
  for (std::size_t i = 0; i < publishers.size(); ++i) {
    ASSERT_TRUE(eventually([&] { return publishers[i]->connections().size() == 1; }));
    publishers[i]->publish(text_record(std::to_string(i)));
    ASSERT_TRUE(inboxes[i]->wait_for(1));
    EXPECT_EQ(control_of(inboxes[i]->messages()[0]), std::to_string(i));
  }
}

TEST(Entrance, each_publisher_authorizes_for_itself) {
  PublisherOptions options;
  options.authorize = [](const Credentials&, const std::string& hello) { return hello == "friend"; };
  const auto careful = publish_with(options), open = publisher();
  Inbox at_careful(careful->address(), "stranger"), at_open(open->address(), "stranger");
  EXPECT_FALSE(at_careful.subscriber);
  EXPECT_NE(at_careful.error.find("did not authorize"), std::string::npos) << at_careful.error;
  EXPECT_TRUE(at_open.subscriber) << at_open.error;
  EXPECT_EQ(careful->stats().refused_peers, 1u);
  EXPECT_EQ(open->stats().refused_peers, 0u);
}

TEST(Entrance, who_asks_for_a_publisher_that_left_is_told) {
  const auto stays = publisher();
  auto leaves = publisher();
  const std::string address = leaves->address();
  ASSERT_EQ(socket_of(address), socket_of(stays->address()));
  leaves.reset();
  Inbox late(address), in(stays->address());
  EXPECT_FALSE(late.subscriber);
  EXPECT_NE(late.error.find("no such publisher"), std::string::npos) << late.error;
  EXPECT_TRUE(in.subscriber) << in.error;
}

TEST(Entrance, one_of_its_own_address_has_its_own) {
  PublisherOptions options;
  options.address = posix::generate_address();
  const auto shared = publisher(), own = publish_with(options);
  EXPECT_EQ(own->address(), options.address);
  Inbox in(own->address());
  EXPECT_TRUE(in.subscriber) << in.error;
}

// The number separates publishers, so one that is made up leads to none.
TEST(HostileEntrance, made_up_numbers_lead_nowhere) {
  const auto out = publisher();
  const Hello right = hello_to(out->address());
  for (const std::uint64_t number :
       {std::uint64_t{0}, std::uint64_t{1}, right.publication + 1, ~right.publication}) {
    RawPeer peer = RawPeer::connect(out->address());
    Hello hello = right;
    hello.publication = number;
    peer.send(hello);
    ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
    EXPECT_EQ(peer.kind(), PacketKind::refusal) << number;
    EXPECT_EQ(peer.receive(), posix::ReceiveResult::closed);
  }
  EXPECT_TRUE(out->connections().empty());
  EXPECT_TRUE(Inbox(out->address()).subscriber);
}

TEST(HostileEntrance, silent_and_unreadable_peers_count_for_all_publishers) {
  const auto one = publisher(), other = publisher();
  RawPeer peer = RawPeer::connect(one->address());
  peer.send("GET / HTTP/1.1\r\n\r\n", 18);
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(peer.kind(), PacketKind::refusal);
  EXPECT_EQ(one->stats().refused_peers, 1u);
  EXPECT_EQ(other->stats().refused_peers, 1u);
}

/// A publisher that admits nobody, or hears whom it does admit.
struct Admission final : PeerAdmission {
  explicit Admission(bool open) : open_(open) {}
  bool considers(const Credentials&) const override { return open_; }
  void admit(posix::FileDescriptor, Peer) override { ++admitted; }
  void count_refused_peer() override { ++refused; }
  void count_accept_failure() override {}
  std::atomic<int> admitted{0};
  std::atomic<int> refused{0};

 private:
  const bool open_;
};

TEST(Entrance, a_user_whom_no_publisher_considers_is_not_heard) {
  const auto entrance = *Entrance::of_process();
  const auto strict = std::make_shared<Admission>(false);
  const auto number = entrance->enter(strict);
  RawPeer peer = RawPeer::connect(entrance->address_of(number));
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet) << "before it says a word";
  EXPECT_EQ(peer.kind(), PacketKind::refusal);
  EXPECT_EQ(strict->refused, 1);
}

TEST(Entrance, a_user_whom_another_publisher_considers_does_not_come_in) {
  const auto entrance = *Entrance::of_process();
  const auto strict = std::make_shared<Admission>(false), open = std::make_shared<Admission>(true);
  const std::string address = entrance->address_of(entrance->enter(strict));
  const std::string other = entrance->address_of(entrance->enter(open));
  RawPeer peer = RawPeer::connect(address), guest = RawPeer::connect(other);
  peer.send(hello_to(address));
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_EQ(peer.kind(), PacketKind::refusal);
  EXPECT_EQ(strict->refused, 1);
  EXPECT_EQ(strict->admitted, 0);
  guest.send(hello_to(other));
  EXPECT_TRUE(eventually([&] { return open->admitted == 1; }));
  EXPECT_EQ(open->refused, 0);
}

TEST(Entrance, a_forked_child_opens_its_own) {
  const auto out = publisher();
  const pid_t child = in_child([&] {
    const auto mine = publisher();
    Inbox in(mine->address());
    mine->publish(text_record("x"));
    return socket_of(mine->address()) != socket_of(out->address()) && in.wait_for(1) ? 0 : 1;
  });
  EXPECT_EQ(exit_status(child), 0);
  EXPECT_TRUE(Inbox(out->address()).subscriber);
}

// Publishers come and go on several threads while subscribers come to others: none is lost or led astray.
TEST(Entrance, publishers_come_and_go_at_once) {
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&wrong, t] {
      for (int i = 0; i < 25; ++i) {
        const auto out = publish_with({});
        Inbox in(out->address());
        const std::string text = std::to_string(t) + "," + std::to_string(i);
        const bool came = eventually([&] { return out->publish(text_record(text)) == 1; });
        if (!came || !in.wait_for(1) || control_of(in.messages()[0]) != text) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(PublisherAddress, is_the_socket_and_a_number) {
  const PublisherAddress address{"@tzc-1", 0xfedcba9876543210};
  EXPECT_EQ(to_text(address), "@tzc-1#fedcba9876543210");
  const auto parsed = parse_publisher_address(to_text(address));
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->socket, address.socket);
  EXPECT_EQ(parsed->publication, address.publication);
  EXPECT_EQ(to_text({"/tmp/x", 0}), "/tmp/x");
  EXPECT_EQ(parse_publisher_address("/tmp/x")->publication, 0u);
}

TEST(PublisherAddress, with_anything_else_behind_the_socket_is_an_error) {
  for (const char* text :
       {"@tzc#", "@tzc#0", "@tzc#g", "@tzc#1g", "@tzc#-1", "@tzc#1#2", "@tzc#11111111111111111"}) {
    const auto parsed = parse_publisher_address(text);
    EXPECT_FALSE(parsed) << text;
    EXPECT_NE(parsed.error().text().find(text), std::string::npos) << parsed.error().text();
    Inbox in(text);
    EXPECT_FALSE(in.subscriber);
  }
}

TEST(PublisherAddress, that_a_program_gives_has_no_number) {
  PublisherOptions options;
  options.address = "@tzc-test#1";
  const auto out = Publisher::create(options);
  ASSERT_FALSE(out);
  EXPECT_NE(out.error().text().find("has no '#'"), std::string::npos) << out.error().text();
  options.address = "@tzc-test#";
  EXPECT_FALSE(Publisher::create(options));
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
