// SPDX-License-Identifier: BSD-3-Clause
// Publishers that lie: the subscriber ends the connection, says why, and touches nothing that is not there.

#include <unistd.h>

#include "channel/wire/shared_page.h"
#include "few_descriptors.h"
#include "posix/address.h"
#include "posix/futex.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "raw_peer.h"

namespace tzc {
namespace channel {
namespace test {
namespace {

/// A publisher whose packets the test writes itself, and a real subscriber.
class HostilePublisher : public ::testing::Test {
 protected:
  void SetUp() override { listener_ = std::move(*posix::Listener::listen(posix::generate_address())); }

  void accept() {
    peer_ = std::make_unique<RawPeer>(accept_at(listener_));
    if (on_shared_thread() && posix::has_shared_futex() && !trunk_)
      trunk_ = std::make_unique<RawPeer>(accept_trunk_at(listener_));
    peer_->receive();
    const Hello hello = peer_->as<Hello>();
    if ((hello.features & has_doorbell) == 0) return;
    bell_ = {*Doorbell::open(std::move(peer_->packet.descriptors[0]), hello.doorbell_bytes),
             hello.doorbell_number};
  }
  void ring_bell() { bell_.pull(ring()); }

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
  std::unique_ptr<RawPeer> trunk_;  // null: the subscriber has a thread of its own
  BellPull bell_;
  posix::Mapping page_;
  std::unique_ptr<Inbox> in_;
};

TEST_F(HostilePublisher, one_that_never_answers_is_given_up) {
  SubscriberOptions options;
  options.address = listener_.address();
  options.own_thread = false;
  options.handshake_timeout = milliseconds(50);
  const auto created = Subscriber::create(options);
  ASSERT_FALSE(created);
  EXPECT_NE(created.error().text().find("did not answer in time"), std::string::npos)
      << created.error().text();
}

TEST_F(HostilePublisher, packets_of_no_known_kind_end_it) {
  subscribe();
  peer_->send("rubbish!", 8);
  expect_broken("unknown kind");
}

TEST_F(HostilePublisher, an_unknown_block_ends_it) {
  subscribe();
  std::uint8_t packet[sizeof(RecordPrefix) + sizeof(BodyHeader) + sizeof(segment::BlockRef)] = {};
  const RecordPrefix prefix{PacketKind::record, 1};
  const BodyHeader header{0, 0, 1, 0, 0};
  std::memcpy(packet, &prefix, sizeof prefix);
  std::memcpy(packet + sizeof prefix, &header, sizeof header);
  peer_->send(packet, sizeof packet);
  expect_broken("a block that does not exist");
}

TEST_F(HostilePublisher, a_segment_without_files_ends_it) {
  subscribe();
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, 4096, 4096, 4096, 0, 64}});
  expect_broken("without its files");
}

TEST_F(HostilePublisher, a_file_that_is_no_segment_ends_it) {
  subscribe();
  auto file = posix::create_memory_file("junk", 8192, posix::Sharing::peers_write);
  posix::seal(*file, posix::Sharing::peers_write);
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, 8192, 8192, 8192, 0, 64}},
              {file->descriptor.get(), file->descriptor.get()});
  expect_broken("refuse a received segment");
}

TEST_F(HostilePublisher, a_file_shorter_than_announced_ends_it) {
  subscribe();
  auto file = posix::create_memory_file("short", 4096, posix::Sharing::peers_write);
  posix::seal(*file, posix::Sharing::peers_write);
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, mb, mb, mb, 0, 64}},
              {file->descriptor.get(), file->descriptor.get()});
  expect_broken("not the announced one");
}

// As for a subscriber with little address space: no process has so much.
TEST_F(HostilePublisher, one_of_whose_segments_this_process_has_no_room_broke_no_protocol) {
  subscribe();
  const std::size_t vast = std::size_t{1} << 60;
  auto data = posix::create_memory_file("vast", vast, posix::Sharing::peers_write);
  auto acks = posix::create_memory_file("acks", mb, posix::Sharing::peers_write);
  ASSERT_TRUE(data && acks);
  posix::seal(*data, posix::Sharing::peers_write);
  posix::seal(*acks, posix::Sharing::peers_write);
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, vast, mb, vast, 0, 64}},
              {data->descriptor.get(), acks->descriptor.get()});
  const std::string reason = end_reason();
  EXPECT_EQ(reason.find("broke the protocol"), std::string::npos) << reason;
  EXPECT_NE(reason.find("this process cannot map a segment"), std::string::npos) << reason;
}

TEST_F(HostilePublisher, nor_did_one_whose_files_find_no_descriptor_here) {
  subscribe();
  auto file = posix::create_memory_file("segment", mb, posix::Sharing::peers_write);
  const int next = ::dup(file->descriptor.get());
  ::close(next);
  const FewDescriptors none_is_left(static_cast<rlim_t>(next));
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, mb, mb, mb, 0, 64}},
              {file->descriptor.get(), file->descriptor.get()});
  const std::string reason = end_reason();
  EXPECT_EQ(reason.find("broke the protocol"), std::string::npos) << reason;
  EXPECT_NE(reason.find("too many files open"), std::string::npos) << reason;
}

TEST_F(HostilePublisher, a_part_that_lies_outside_its_file_ends_it) {
  const std::uint64_t page = posix::page_size(), most = ~std::uint64_t{0};
  const std::pair<std::uint64_t, std::uint64_t> parts[] = {// size, offset
                                                           {2 * page, 3 * page},
                                                           {2 * page, most - page + 1},
                                                           {2 * page, 1},
                                                           {5 * page, 0},
                                                           {most - page + 1, 2 * page}};
  for (const auto& [size, offset] : parts) {
    subscribe();
    auto file = posix::create_memory_file("part", 4 * page, posix::Sharing::peers_write);
    posix::seal(*file, posix::Sharing::peers_write);
    peer_->send(SegmentPacket{PacketKind::segment, 0, {1, size, 2 * page, 4 * page, offset, 64}},
                {file->descriptor.get(), file->descriptor.get()});
    expect_broken("its sizes don't agree");
  }
}

#ifndef TZC_PORTABLE
TEST_F(HostilePublisher, a_ring_that_claims_more_than_it_holds_ends_it) {
  subscribe(reads_ring);
  ring().publisher.written = ring_start + ring_slots + 1;
  ring_bell();
  expect_broken("wrong size");
}

TEST_F(HostilePublisher, a_slot_that_claims_more_than_it_holds_ends_it) {
  subscribe(reads_ring);
  ring().slots[ring_start % ring_slots].size = slot_bytes + 1;
  ring().publisher.written = ring_start + 1;
  ring_bell();
  expect_broken("wrong size");
}

TEST_F(HostilePublisher, what_comes_through_the_ring_is_checked_as_a_packet) {
  subscribe(reads_ring);
  const SegmentPacket offer{PacketKind::segment, 0, {1, 4096, 4096, 4096, 0, 64}};
  RingWriter(&ring(), bell_).write(&offer, sizeof offer, "", 0);
  expect_broken("without its files");
}

TEST_F(HostilePublisher, packets_that_never_come_hold_nobody_up) {
  subscribe(reads_ring);
  ring().publisher.packets = ring_start + 1;
  ring_bell();
  in_.reset();  // waits for the reader thread
}

TEST_F(HostilePublisher, a_file_that_it_could_still_truncate_ends_it) {
  subscribe();
  const std::size_t size = 2 * posix::page_size();
  auto file = posix::create_memory_file("open", size, posix::Sharing::peers_write);
  peer_->send(SegmentPacket{PacketKind::segment, 0, {1, size, size, size, 0, 64}},
              {file->descriptor.get(), file->descriptor.get()});
  expect_broken("not sealed");
}
#endif

TEST_F(HostilePublisher, huge_announcements_cost_nothing) {
  subscribe();
  peer_->send(FragmentPrefix{PacketKind::fragment, 1, 0, std::uint64_t{1} << 60});
  expect_broken("too large");
}

TEST_F(HostilePublisher, fragments_that_do_not_fit_end_it) {
  subscribe();
  struct {
    FragmentPrefix prefix;
    char slice[10];
  } packet{{PacketKind::fragment, 1, 500, 1000}, {}};
  peer_->send(packet);
  expect_broken("don't fit together");
}

TEST_F(HostilePublisher, repeated_sequence_numbers_end_it) {
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

TEST_F(HostilePublisher, descriptors_that_belong_to_nothing_are_closed) {
  subscribe();
  const int before = open_descriptors();
  struct {
    RecordPrefix prefix;
    BodyHeader header;
  } packet{{PacketKind::record, 1}, {}};
  for (std::uint32_t i = 1; i <= 100; ++i) {
    packet.prefix.sequence = i;
    peer_->send(packet, {0, 1});
  }
  ASSERT_TRUE(in_->wait_for(100));
  EXPECT_EQ(open_descriptors(), before);
}

}  // namespace
}  // namespace test
}  // namespace channel
}  // namespace tzc
