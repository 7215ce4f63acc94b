// SPDX-License-Identifier: BSD-3-Clause
#include "posix/packet.h"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace tzc {
namespace posix {
namespace {

constexpr std::size_t control_space = CMSG_SPACE(sizeof(int) * max_passed_descriptors);

struct alignas(cmsghdr) ControlMemory {
  char bytes[control_space];
};

void attach_descriptors(msghdr& message, ControlMemory& control, const int* descriptors, std::size_t count) {
  message.msg_control = control.bytes;
  message.msg_controllen = CMSG_SPACE(sizeof(int) * count);
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int) * count);
  std::memcpy(CMSG_DATA(header), descriptors, sizeof(int) * count);
}

SendResult classify_send_failure(int code) {
  switch (code) {
    case EAGAIN:
      return SendResult::full;
    case ENOBUFS:
    case ENOMEM:
    case ETOOMANYREFS:
      return SendResult::exhausted;
    default:
      return SendResult::gone;
  }
}

template <class Call>
SendResult finish_send(Call send_once) {
  ssize_t sent = 0;
  do {
    sent = send_once();
  } while (sent < 0 && errno == EINTR);
  return sent >= 0 ? SendResult::sent : classify_send_failure(errno);
}

void take_descriptors(msghdr& message, ReceivedPacket& packet) {
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
    const std::size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t i = 0; i < count; ++i) {
      int fd = -1;
      std::memcpy(&fd, CMSG_DATA(header) + i * sizeof(int), sizeof fd);
      FileDescriptor owned(fd);
      if (packet.descriptor_count < packet.descriptors.size())
        packet.descriptors[packet.descriptor_count++] = std::move(owned);
    }
  }
}

}  // namespace

SendResult send_packet(int socket, const iovec* parts, std::size_t part_count, const int* descriptors,
                       std::size_t descriptor_count) noexcept {
  msghdr message{};
  ControlMemory control;
  message.msg_iov = const_cast<iovec*>(parts);
  message.msg_iovlen = part_count;
  if (descriptor_count > 0) {
    std::memset(&control, 0, sizeof control);
    attach_descriptors(message, control, descriptors, descriptor_count);
  }
  return finish_send([&] { return ::sendmsg(socket, &message, MSG_DONTWAIT | MSG_NOSIGNAL); });
}

SendResult send_packet(int socket, const void* data, std::size_t size) noexcept {
  return finish_send([&] { return ::send(socket, data, size, MSG_DONTWAIT | MSG_NOSIGNAL); });
}

bool is_at_end(int socket) noexcept {
  char byte = 0;
  return ::recv(socket, &byte, sizeof byte, MSG_PEEK | MSG_DONTWAIT) == 0;
}

ReceiveResult receive_packet(int socket, void* memory, std::size_t size, Waiting waiting,
                             bool with_descriptors, ReceivedPacket& packet) noexcept {
  const iovec whole{memory, size};
  return receive_packet(socket, &whole, 1, waiting, with_descriptors, packet);
}

ReceiveResult receive_packet(int socket, const iovec* parts, std::size_t part_count, Waiting waiting,
                             bool with_descriptors, ReceivedPacket& packet) noexcept {
  ControlMemory control;
  msghdr message{};
  message.msg_iov = const_cast<iovec*>(parts);
  message.msg_iovlen = part_count;
  message.msg_control = with_descriptors ? control.bytes : nullptr;
  message.msg_controllen = with_descriptors ? control_space : 0;
  const int flags = MSG_CMSG_CLOEXEC | (waiting == Waiting::block ? 0 : MSG_DONTWAIT);
  ssize_t received = 0;
  do {  // a reset is reported once, before what the peer had sent until then
    received = ::recvmsg(socket, &message, flags);
  } while (received < 0 && (errno == EINTR || errno == ECONNRESET));
  if (received < 0 && (errno == EAGAIN || errno == ENOBUFS || errno == ENOMEM)) return ReceiveResult::nothing;
  if (received < 0) return ReceiveResult::closed;
  packet.size = static_cast<std::size_t>(received);
  packet.truncated = (message.msg_flags & MSG_TRUNC) != 0;
  packet.descriptors_lost = (message.msg_flags & MSG_CTRUNC) != 0;
  packet.descriptor_count = 0;
  if (with_descriptors && message.msg_controllen > 0) take_descriptors(message, packet);
  // An empty packet looks like the end, and is one: nobody sends it. It may have brought descriptors all the same.
  return received > 0 ? ReceiveResult::packet : ReceiveResult::closed;
}

}  // namespace posix
}  // namespace tzc
