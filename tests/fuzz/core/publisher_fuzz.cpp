// SPDX-License-Identifier: BSD-3-Clause
// A hostile subscriber: any hello, any packets, and any acknowledgements while the publisher goes on.
#include <cstdio>
#include <cstring>
#include <thread>

#include "channel/connect/pending_peer.h"
#include "channel/connect/trunk.h"
#include "channel/publish/connection.h"
#include "channel/wire/wire.h"
#include "input.h"
#include "posix/mapping.h"
#include "tzc/channel.h"

namespace {

using namespace tzc;           // NOLINT: a fuzz target, not a header
using namespace tzc::channel;  // NOLINT

constexpr std::uint32_t number = 7;  // of the connection on its trunk

/// Keeps every file that the publisher shares, mapped for writing where it lets us, and every socket that it lends.
class Hostile {
 public:
  Hostile(posix::FileDescriptor socket, posix::FileDescriptor trunk) : memory_(max_packet_bytes) {
    sockets_.push_back(std::move(socket));
    sockets_.push_back(std::move(trunk));
  }

  void read_one(fuzz::Input& input) {
    posix::ReceivedPacket packet;
    const auto result = posix::receive_packet(some_socket(input), memory_.data(), memory_.size(),
                                              posix::Waiting::return_at_once, true, packet);
    if (result != posix::ReceiveResult::packet) return;
    for (std::size_t i = 0; i < packet.descriptor_count; ++i) take(std::move(packet.descriptors[i]));
  }

  void scribble(fuzz::Input& input) {
    if (writable_.empty()) return;
    const posix::Mapping& target = writable_[input.take<std::uint8_t>() % writable_.size()];
    const std::size_t offset = input.take<std::uint16_t>() % (target.size() - 64);
    input.take_into(target.data() + offset, input.take<std::uint8_t>() % 64);
  }

  void say(fuzz::Input& input) const {
    const auto packet = input.take_bytes(input.take<std::uint8_t>());
    posix::send_packet(some_socket(input), packet.data(), packet.size());
  }

  void say_word(fuzz::Input& input) const {
    const auto word = static_cast<TrunkWord>(input.take<std::uint8_t>() % 6);
    const WordPacket packet{PacketKind::word, word, number + input.take<std::uint8_t>() % 2};
    posix::send_packet(sockets_[1].get(), &packet, sizeof packet);
  }

  void close_one(fuzz::Input& input) {
    if (sockets_.size() > 2)
      sockets_.erase(sockets_.begin() + 2 + input.take<std::uint8_t>() % (sockets_.size() - 2));
  }

 private:
  int some_socket(fuzz::Input& input) const {
    return sockets_[input.take<std::uint8_t>() % sockets_.size()].get();
  }
  void take(posix::FileDescriptor file) {
    auto mapping = posix::Mapping::map(file.get(), 4096, posix::Access::read_write);
    if (mapping)
      writable_.push_back(std::move(*mapping));
    else
      sockets_.push_back(std::move(file));
  }

  std::vector<posix::FileDescriptor> sockets_;  // the connection's, the trunk's, and those that were lent
  std::vector<std::uint8_t> memory_;
  std::vector<posix::Mapping> writable_;
};

void publish(ConnectionImpl& connection, SegmentMemory& memory, fuzz::Input& input) {
  std::vector<BufferPtr> buffers;
  for (int count = input.take<std::uint8_t>() % 3; count > 0; --count) {
    if (BufferPtr buffer = memory.allocate(input.take<std::uint16_t>())) buffers.push_back(std::move(buffer));
  }
  if (buffers.size() == 2 && (input.take<std::uint8_t>() & 1)) buffers[1] = buffers[0];
  const std::vector<std::uint8_t> control(input.take<std::uint8_t>() & 1 ? 10 : 40'000, 1);
  connection.send(make_record(1, control.data(), control.size(), buffers));
}

void act(Hostile& hostile, ConnectionImpl& connection, SegmentMemory& memory, fuzz::Input& input) {
  switch (input.take<std::uint8_t>() % 10) {
    case 0:
      hostile.say(input);
      break;
    case 1:
    case 2:
      hostile.read_one(input);
      break;
    case 3:
    case 4:
      hostile.scribble(input);
      break;
    case 5:
      hostile.say_word(input);
      break;
    case 6:
      hostile.close_one(input);
      break;
    default:
      publish(connection, memory, input);
  }
}

// What comes back says what was sent, whatever the peer wrote meanwhile.
void read(const Record& record) {
  const RecordParts parts = parts_of(record);
  if (parts.tag != 1 || (parts.control_size != 10 && parts.control_size != 40'000)) __builtin_trap();
  for (std::size_t i = 0; i < parts.control_size; ++i) {
    if (parts.control[i] != 1) __builtin_trap();
  }
  for (const ConstBlock& block : parts.blocks) {
    volatile std::uint8_t last = block.size > 0 ? block.data[block.size - 1] : std::uint8_t{0};
    (void)last;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string reason;
  Peer peer;
  parse_hello(data, size, peer, reason);

  fuzz::Input input(data, size);
  fuzz::SocketPair sockets;
  MemoryOptions memory_options;
  memory_options.size = 256 << 10;
  memory_options.prefault = Prefault::none;
  memory_options.policy = input.take<std::uint8_t>() & 1 ? Policy::best_effort() : Policy::medium_effort();
  const auto memory = *SegmentMemory::create(memory_options);
  auto page = SharedPage::create(first_sequence);
  peer.reads_ring = (input.take<std::uint8_t>() & 1) != 0;
  ConnectionImpl::Options options{};
  const auto limits = input.take<std::uint8_t>();
  options.limit = {limits % 8u + 1, limits / 8u * 1024u};
  options.keeps_undelivered = (input.take<std::uint8_t>() & 1) != 0;
  fuzz::SocketPair trunk_sockets;
  const auto trunk = *Trunk::start(**Service::instance(), std::move(trunk_sockets.ours), {{}, 1, false});
  if (input.take<std::uint8_t>() & 1) {
    peer.reads_ring = true;  // as with every trunk
    peer.trunk.place = trunk->take(number);
  }
  auto connection = std::make_shared<ConnectionImpl>(
      std::move(sockets.ours), std::move(peer), std::move(*page), options, std::weak_ptr<ConnectionOwner>());
  connection->start(**Service::instance());
  connection->uncork();
  {
    Hostile hostile(std::move(sockets.theirs), std::move(trunk_sockets.theirs));
    while (!input.empty()) {
      act(hostile, *connection, *memory, input);
    }
  }
  // Whatever it did: once it is gone, everything is free again.
  for (int i = 0; i < 10'000 && connection->stats().in_flight + connection->alive() > 0; ++i)
    std::this_thread::yield();
  while (connection.use_count() > 1) std::this_thread::yield();
  for (const RecordPtr& record : connection->take_undelivered()) read(*record);
  connection.reset();
  if (!memory->allocate(256 << 10)) {
    std::fprintf(stderr, "not free: %s\n", memory->last_failure().text().c_str());
    __builtin_trap();
  }
  return 0;
}
