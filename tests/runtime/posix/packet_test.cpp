// SPDX-License-Identifier: BSD-3-Clause
#include "posix/packet.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <vector>

namespace tzc {
namespace posix {
namespace {

class PacketTest : public ::testing::Test {
 protected:
  void SetUp() override {
    int ends[2];
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends), 0);
    left_ = FileDescriptor(ends[0]);
    right_ = FileDescriptor(ends[1]);
  }

  SendResult send(const std::string& text, std::vector<int> descriptors = {}) {
    const iovec part{const_cast<char*>(text.data()), text.size()};
    return send_packet(left_.get(), &part, 1, descriptors.data(), descriptors.size());
  }

  ReceiveResult receive(bool with_descriptors = false, std::size_t size = 4096) {
    memory_.resize(size);
    return receive_packet(right_.get(), memory_.data(), size, Waiting::return_at_once, with_descriptors,
                          packet_);
  }

  std::string received() const { return std::string(memory_.data(), packet_.size); }

  FileDescriptor left_, right_;
  ReceivedPacket packet_;
  std::vector<char> memory_;
};

int open_descriptors() {
  int count = 0;
  for (int fd = 0; fd < 256; ++fd) count += ::fcntl(fd, F_GETFD) >= 0 ? 1 : 0;
  return count;
}

TEST_F(PacketTest, keeps_boundaries) {
  send("one");
  send("two");
  ASSERT_EQ(receive(), ReceiveResult::packet);
  EXPECT_EQ(received(), "one");
  ASSERT_EQ(receive(), ReceiveResult::packet);
  EXPECT_EQ(received(), "two");
  EXPECT_EQ(receive(), ReceiveResult::nothing);
}

TEST_F(PacketTest, a_full_socket_is_reported_and_never_blocks) {
  const std::string large(32 << 10, 'x');
  while (send(large) == SendResult::sent) {
  }
  EXPECT_EQ(send(large), SendResult::full);
}

TEST_F(PacketTest, a_closed_peer_is_gone) {
  right_.reset();
  EXPECT_EQ(send("x"), SendResult::gone);
}

TEST_F(PacketTest, what_was_sent_before_the_end_is_still_read) {
  send("last words");
  left_.reset();
  ASSERT_EQ(receive(), ReceiveResult::packet);
  EXPECT_EQ(received(), "last words");
  EXPECT_EQ(receive(), ReceiveResult::closed);
}

TEST_F(PacketTest, a_peer_that_leaves_our_words_unread_is_still_heard) {
  const iovec part{const_cast<char*>("unread"), 6};
  send_packet(right_.get(), &part, 1);
  send("last words");
  left_.reset();
  ASSERT_EQ(receive(), ReceiveResult::packet);
  EXPECT_EQ(received(), "last words");
  EXPECT_EQ(receive(), ReceiveResult::closed);
}

TEST_F(PacketTest, says_when_a_packet_did_not_fit) {
  send(std::string(100, 'x'));
  ASSERT_EQ(receive(false, 10), ReceiveResult::packet);
  EXPECT_TRUE(packet_.truncated);
}

TEST_F(PacketTest, passes_descriptors_that_survive_the_sender) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  send("take these", {ends[0]});
  ::close(ends[0]);
  ASSERT_EQ(receive(true), ReceiveResult::packet);
  ASSERT_EQ(packet_.descriptor_count, 1u);
  ASSERT_EQ(::write(ends[1], "y", 1), 1);
  char byte = 0;
  EXPECT_EQ(::read(packet_.descriptors[0].get(), &byte, 1), 1);
  ::close(ends[1]);
}

TEST_F(PacketTest, descriptors_nobody_asked_for_never_arrive) {
  const int before = open_descriptors();
  send("two gifts", {0, 1});
  ASSERT_EQ(receive(false), ReceiveResult::packet);
  EXPECT_EQ(packet_.descriptor_count, 0u);
  EXPECT_TRUE(packet_.descriptors_lost);
  EXPECT_EQ(open_descriptors(), before);
}

TEST_F(PacketTest, more_descriptors_than_allowed_are_closed) {
  const int before = open_descriptors();
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int) * 8)] = {};
  iovec part{const_cast<char*>("x"), 1};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int) * 8);
  std::memset(CMSG_DATA(header), 0, sizeof(int) * 8);  // eight times standard input
  ASSERT_EQ(::sendmsg(left_.get(), &message, 0), 1);
  ASSERT_EQ(receive(true), ReceiveResult::packet);
  EXPECT_TRUE(packet_.descriptors_lost);
  EXPECT_LE(packet_.descriptor_count, max_passed_descriptors);
  packet_ = ReceivedPacket();
  EXPECT_EQ(open_descriptors(), before);
}

TEST_F(PacketTest, descriptors_of_an_empty_packet_are_closed) {
  const int before = open_descriptors();
  send("", {0, 0});
  EXPECT_EQ(receive(true), ReceiveResult::closed);
  packet_ = ReceivedPacket();
  EXPECT_EQ(open_descriptors(), before);
}

}  // namespace
}  // namespace posix
}  // namespace tzc
