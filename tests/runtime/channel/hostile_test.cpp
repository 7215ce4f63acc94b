// SPDX-License-Identifier: BSD-3-Clause
// Peers that lie: whatever they send, the other side goes on, says what is wrong, and gives nothing away.
#include <dirent.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include "channel/verdict.h"
#include "channel/wire.h"
#include "posix/address.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "posix/packet.h"
#include "posix/socket.h"
#include "support.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

using std::chrono::milliseconds;

/// One end of a connection, spoken by hand.
class RawPeer {
 public:
  explicit RawPeer(posix::FileDescriptor socket) : socket_(std::move(socket)), memory_(max_packet_bytes) {}
  static RawPeer connect(const std::string& address) {
    return RawPeer(*posix::connect_to(address, milliseconds(1000)));
  }

  void send(const void* data, std::size_t size, std::vector<int> descriptors = {}) const {
    const iovec part{const_cast<void*>(data), size};
    posix::send_packet(socket_.get(), &part, 1, descriptors.data(), descriptors.size());
  }
  template <class Packet>
  void send(const Packet& packet, std::vector<int> descriptors = {}) const {
    send(&packet, sizeof packet, std::move(descriptors));
  }

  posix::ReceiveResult receive() {
    packet = posix::ReceivedPacket();
    posix::wait_readable(socket_.get(), milliseconds(5000));
    return posix::receive_packet(socket_.get(), memory_.data(), memory_.size(),
                                 posix::Waiting::return_at_once, true, packet);
  }
  PacketKind kind() const { return *reinterpret_cast<const PacketKind*>(memory_.data()); }
  std::string text(std::size_t after) const {
    return std::string(reinterpret_cast<const char*>(memory_.data()) + after, packet.size - after);
  }

  posix::ReceivedPacket packet;

 private:
  posix::FileDescriptor socket_;
  std::vector<std::uint8_t> memory_;
};

constexpr Hello good_hello{PacketKind::hello, wire_magic, wire_version, 0};

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
  peer.send(Hello{PacketKind::hello, wire_magic, wire_version + 1, 0});
  ASSERT_EQ(peer.receive(), posix::ReceiveResult::packet);
  EXPECT_NE(peer.text(sizeof(Refusal)).find("update the older one"), std::string::npos);
}

TEST(HostileSubscriber, SilentPeersHoldNobodyUp) {
  const auto out = publisher();
  std::vector<RawPeer> silent;
  for (int i = 0; i < 300; ++i) silent.push_back(RawPeer::connect(out->address()));
  EXPECT_TRUE(eventually([&] { return out->stats().accept_failures > 0; })) << "more than may wait at a time";
  silent.clear();
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

/// A publisher spoken by hand, and a real subscriber.
class HostilePublisher : public ::testing::Test {
 protected:
  void SetUp() override { listener_ = std::move(*posix::Listener::listen(posix::generate_address())); }

  void accept() {
    posix::wait_readable(listener_.fd(), milliseconds(5000));
    posix::FileDescriptor socket;
    posix::accept_connection(listener_.fd(), socket);
    peer_ = std::make_unique<RawPeer>(std::move(socket));
    peer_->receive();
  }

  void subscribe(bool welcome = true) {
    std::thread server([&] {
      accept();
      if (!welcome) return;
      auto page = posix::create_memory_file("page", 4096, posix::Sharing::peers_write);
      posix::seal(*page, posix::Sharing::peers_write);
      peer_->send(Welcome{PacketKind::welcome, wire_version, 0, 4096}, {page->descriptor.get()});
    });
    in_ = std::make_unique<Inbox>(listener_.address());
    server.join();
  }

  std::string end_reason() {
    EXPECT_TRUE(in_->wait_for_end());
    return in_->reason();
  }

  void expect_broken(const std::string& why) {
    const std::string reason = end_reason();
    EXPECT_NE(reason.find("broke the protocol"), std::string::npos) << reason;
    EXPECT_NE(reason.find(why), std::string::npos) << reason;
  }

  posix::Listener listener_;
  std::unique_ptr<RawPeer> peer_;
  std::unique_ptr<Inbox> in_;
};

TEST_F(HostilePublisher, OneThatNeverAnswersIsGivenUp) {
  SubscriberOptions options;
  options.address = listener_.address();
  options.own_thread = false;
  options.handshake_timeout = milliseconds(50);
  const auto created = Subscriber::create(options);
  ASSERT_FALSE(created);
  EXPECT_NE(created.error().text().find("did not answer in time"), std::string::npos)
      << created.error().text();
}

TEST_F(HostilePublisher, PacketsOfNoKnownKindEndIt) {
  subscribe();
  peer_->send("rubbish!", 8);
  expect_broken("unknown kind");
}

TEST_F(HostilePublisher, AnUnknownBlockEndsIt) {
  subscribe();
  std::uint8_t packet[sizeof(RecordPrefix) + sizeof(BodyHeader) + sizeof(segment::BlockRef)] = {};
  const RecordPrefix prefix{PacketKind::record, 1};
  const BodyHeader header{0, 0, 1, 0, 0};
  std::memcpy(packet, &prefix, sizeof prefix);
  std::memcpy(packet + sizeof prefix, &header, sizeof header);
  peer_->send(packet, sizeof packet);
  expect_broken("a block that does not exist");
}

TEST_F(HostilePublisher, ASegmentWithoutFilesEndsIt) {
  subscribe();
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, 4096, 4096, 64}});
  expect_broken("without its files");
}

TEST_F(HostilePublisher, AFileThatIsNoSegmentEndsIt) {
  subscribe();
  auto file = posix::create_memory_file("junk", 8192, posix::Sharing::peers_write);
  posix::seal(*file, posix::Sharing::peers_write);
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, 8192, 8192, 64}},
              {file->descriptor.get(), file->descriptor.get()});
  expect_broken("refuse a received segment");
}

TEST_F(HostilePublisher, AFileShorterThanAnnouncedEndsIt) {
  subscribe();
  auto file = posix::create_memory_file("short", 4096, posix::Sharing::peers_write);
  posix::seal(*file, posix::Sharing::peers_write);
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, mb, mb, 64}},
              {file->descriptor.get(), file->descriptor.get()});
  expect_broken("not the announced one");
}

#ifndef TZC_PORTABLE
TEST_F(HostilePublisher, AFileThatItCouldStillTruncateEndsIt) {
  subscribe();
  auto file = posix::create_memory_file("open", 8192, posix::Sharing::peers_write);
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, 8192, 8192, 64}},
              {file->descriptor.get(), file->descriptor.get()});
  expect_broken("not sealed");
}
#endif

TEST_F(HostilePublisher, HugeAnnouncementsCostNothing) {
  subscribe();
  peer_->send(FragmentPrefix{PacketKind::fragment, 1, 0, std::uint64_t{1} << 60});
  expect_broken("too large");
}

TEST_F(HostilePublisher, FragmentsThatDoNotFitEndIt) {
  subscribe();
  struct {
    FragmentPrefix prefix;
    char slice[10];
  } packet{{PacketKind::fragment, 1, 500, 1000}, {}};
  peer_->send(packet);
  expect_broken("don't fit together");
}

TEST_F(HostilePublisher, RepeatedSequenceNumbersEndIt) {
  subscribe();
  struct {
    RecordPrefix prefix;
    BodyHeader header;
  } packet{{PacketKind::record, 1}, {}};
  peer_->send(packet);
  peer_->send(packet);
  expect_broken("a malformed record");
  EXPECT_EQ(in_->messages().size(), 1u);
}

TEST_F(HostilePublisher, DescriptorsThatBelongToNothingAreClosed) {
  subscribe();
  const auto count = [] {
    int open = 0;
    DIR* folder = ::opendir("/proc/self/fd");
    while (::readdir(folder) != nullptr) ++open;
    ::closedir(folder);
    return open;
  };
  const int before = count();
  struct {
    RecordPrefix prefix;
    BodyHeader header;
  } packet{{PacketKind::record, 1}, {}};
  for (std::uint32_t i = 1; i <= 100; ++i) {
    packet.prefix.sequence = i;
    peer_->send(packet, {0, 1});
  }
  ASSERT_TRUE(in_->wait_for(100));
  EXPECT_EQ(count(), before);
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
