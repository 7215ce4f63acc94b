// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/answer.h"

#include <algorithm>
#include <string>

#include "posix/socket.h"

namespace tzc {
namespace channel {

Error subscribe_failed(const std::string& why) {
  Error error;
  error.what = "subscribe: " + why;
  return error;
}

Status Answer::await(int socket, std::chrono::milliseconds timeout) {
  if (!posix::wait_readable(socket, timeout)) return subscribe_failed("the publisher did not answer in time");
  const auto result = posix::receive_packet(socket, memory_.data(), memory_.size(),
                                            posix::Waiting::return_at_once, true, packet_);
  if (result != posix::ReceiveResult::packet) return subscribe_failed("the publisher closed the connection");
  if (packet_.descriptors_lost && packet_.descriptor_count == 0)
    return subscribe_failed("too many open files in this process");
  Refusal refusal{};
  if (packet_.size < sizeof refusal) return subscribe_failed("not a TZC publisher");
  std::memcpy(&refusal, memory_.data(), sizeof refusal);
  if (refusal.kind != PacketKind::refusal) return Success{};
  const std::string reason(memory_.begin() + sizeof refusal, memory_.begin() + packet_.size);
  return subscribe_failed("refused by the publisher: " + reason);
}

}  // namespace channel
}  // namespace tzc
