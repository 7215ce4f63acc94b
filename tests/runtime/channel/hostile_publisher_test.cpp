// SPDX-License-Identifier: BSD-3-Clause
// Publishers that lie: the subscriber ends the connection, says why, and touches nothing that is not there.
#include <dirent.h>

#include "channel/shared_page.h"
#include "posix/address.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

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

  void subscribe(std::uint32_t features = 0) {
    std::thread server([&] {
      accept();
      auto page = posix::create_memory_file("page", 4096, posix::Sharing::peers_write);
      page_ = std::move(*posix::Mapping::map(page->descriptor.get(), 4096, posix::Access::read_write));
      new (page_.data()) ConnectionPage();
      posix::seal(*page, posix::Sharing::peers_write);
      peer_->send(Welcome{PacketKind::welcome, wire_version, 0, 4096, features}, {page->descriptor.get()});
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
  Ring& ring() { return reinterpret_cast<ConnectionPage*>(page_.data())->ring; }

  std::unique_ptr<RawPeer> peer_;
  posix::Mapping page_;
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
TEST_F(HostilePublisher, ARingThatClaimsMoreThanItHoldsEndsIt) {
  subscribe(reads_ring);
  ring().publisher.written = ring_start + ring_slots + 1;
  wake_reader(ring());
  expect_broken("wrong size");
}

TEST_F(HostilePublisher, ASlotThatClaimsMoreThanItHoldsEndsIt) {
  subscribe(reads_ring);
  ring().slots[ring_start % ring_slots].size = slot_bytes + 1;
  ring().publisher.written = ring_start + 1;
  wake_reader(ring());
  expect_broken("wrong size");
}

TEST_F(HostilePublisher, WhatComesThroughTheRingIsCheckedAsAPacket) {
  subscribe(reads_ring);
  const SegmentPacket offer{PacketKind::segment, 0, {1, 4096, 4096, 64}};
  RingWriter(&ring()).write(&offer, sizeof offer, "", 0);
  expect_broken("without its files");
}

TEST_F(HostilePublisher, PacketsThatNeverComeHoldNobodyUp) {
  subscribe(reads_ring);
  ring().publisher.packets = ring_start + 1;
  wake_reader(ring());
  in_.reset();  // waits for the reader thread
}

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
