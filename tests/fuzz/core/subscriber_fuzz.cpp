// SPDX-License-Identifier: BSD-3-Clause
// A hostile publisher: any packets, with any descriptors, while it scribbles over everything that is shared.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "channel/connect/trunk.h"
#include "channel/subscribe/link.h"
#include "channel/subscribe/reader.h"
#include "channel/wait/receiver.h"
#include "channel/wait/service.h"
#include "channel/wire/delivery_cursors.h"
#include "channel/wire/wire.h"
#include "input.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"

namespace {

using namespace tzc;           // NOLINT: a fuzz target, not a header
using namespace tzc::channel;  // NOLINT

constexpr std::size_t file_bytes = 16384;
constexpr std::uint32_t slots = 64;
const std::uint64_t payload = segment::payloads_offset(slots, posix::page_size());

struct SharedFile {
  posix::MemoryFile file;
  posix::Mapping mapping;
};

SharedFile shared_file(std::size_t size) {
  SharedFile shared;
  shared.file = *posix::create_memory_file("fuzz", size, posix::Sharing::peers_write);
  shared.mapping = *posix::Mapping::map(shared.file.descriptor.get(), size, posix::Access::read_write);
  posix::seal(shared.file, posix::Sharing::peers_write);
  return shared;
}

/// What a well-behaved publisher would share, ready to be damaged.
class Hostile {
 public:
  Hostile() : page_(shared_file(4096)), data_(shared_file(file_bytes)), acks_(shared_file(file_bytes)) {
    new (page_.mapping.data()) ConnectionPage();
    const segment::SegmentHeader header{
        segment::segment_magic, segment::layout_version, slots, 1, file_bytes, {}};
    std::memcpy(data_.mapping.data(), &header, sizeof header);
    const std::uint64_t ack_header[] = {segment::ack_magic,
                                        std::uint64_t{slots} << 32 | segment::layout_version};
    std::memcpy(acks_.mapping.data(), ack_header, sizeof ack_header);
    const segment::BlockHeader block{segment::block_magic, 5, 0, 0, payload, 1024};
    std::memcpy(data_.mapping.data() + segment::block_header_offset(0), &block, sizeof block);
    const std::uint64_t in_flight = std::uint64_t{5} << 32 | 3 << 16;
    std::memcpy(acks_.mapping.data() + segment::ack_words_offset(slots), &in_flight, sizeof in_flight);
  }

  void welcome(const fuzz::SocketPair& sockets, std::uint32_t features) const {
    const Welcome packet{PacketKind::welcome, wire_version, 0, 4096, features};
    sockets.send(&packet, sizeof packet, {page_.file.descriptor.get()});
  }

  Ring& ring() { return reinterpret_cast<ConnectionPage*>(page_.mapping.data())->ring; }

  void scribble(fuzz::Input& input) {
    SharedFile& target = *std::array<SharedFile*, 3>{&page_, &data_, &acks_}[input.take<std::uint8_t>() % 3];
    const std::size_t offset = input.take<std::uint16_t>() % (target.mapping.size() - 64);
    input.take_into(target.mapping.data() + offset, input.take<std::uint8_t>() % 64);
  }

  std::vector<int> descriptors(std::uint8_t choice) const {
    static const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    switch (choice % 6) {
      case 1:
        return {null};
      case 2:
        return {data_.file.descriptor.get(), null};
      case 3:
        return {acks_.file.descriptor.get(), data_.file.descriptor.get()};
      case 4:
      case 5:
        return {data_.file.descriptor.get(), acks_.file.descriptor.get()};
      default:
        return {};
    }
  }

  void write_into_ring(const std::vector<std::uint8_t>& packet) {
    std::atomic<std::uint32_t>& written = ring().publisher.written;
    Ring::Slot& slot = ring().slots[written % ring_slots];
    std::copy(packet.begin(), packet.end(), slot.bytes);
    slot.size = static_cast<std::uint32_t>(packet.size());
    ++written;
  }

 private:
  SharedFile page_, data_, acks_;
};

std::vector<std::uint8_t> valid_segment() {
  const SegmentPacket packet{PacketKind::segment, 0, {1, file_bytes, file_bytes, file_bytes, 0, slots}};
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(&packet);
  return {bytes, bytes + sizeof packet};
}

std::vector<std::uint8_t> valid_record(std::uint32_t sequence, fuzz::Input& input) {
  const auto control = input.take_bytes(input.take<std::uint8_t>());
  const RecordPrefix prefix{PacketKind::record, sequence};
  const BodyHeader header{1, input.take<std::uint8_t>() & 1u, 1, 0, control.size()};
  const segment::BlockRef ref{1, payload, 1024, 0, 5};
  std::vector<std::uint8_t> packet(sizeof prefix + sizeof header + sizeof ref);
  std::memcpy(packet.data(), &prefix, sizeof prefix);
  std::memcpy(packet.data() + sizeof prefix, &header, sizeof header);
  std::memcpy(packet.data() + sizeof prefix + sizeof header, &ref, sizeof ref);
  packet.insert(packet.end(), control.begin(), control.end());
  return packet;
}

void damage(std::vector<std::uint8_t>& packet, fuzz::Input& input) {
  for (int count = input.take<std::uint8_t>() % 4; count > 0 && !packet.empty(); --count)
    packet[input.take<std::uint16_t>() % packet.size()] = input.take<std::uint8_t>();
}

/// The publisher's end of a trunk: lends sockets, some of which it closes soon, and says other things.
class Lender {
 public:
  explicit Lender(posix::FileDescriptor trunk) : trunk_(std::move(trunk)) {}

  /// Where the next packet goes: the connection's socket, or the one that was lent last.
  int socket(const fuzz::SocketPair& first) const { return lent_ ? lent_.get() : first.ours.get(); }

  void say(std::uint32_t number, fuzz::Input& input) {
    const auto choice = input.take<std::uint8_t>();
    if (choice % 16 == 0) return say_anything(input);
    fuzz::SocketPair pair;
    const WordPacket packet{PacketKind::word, choice % 8 == 0 ? TrunkWord::end : TrunkWord::lend,
                            number + (choice % 32 == 1 ? 1 : 0)};
    const iovec whole{const_cast<WordPacket*>(&packet), sizeof packet};
    const int theirs = pair.theirs.get();
    posix::send_packet(trunk_.get(), &whole, 1, &theirs, choice % 8 == 2 ? 0 : 1);
    lent_ = std::move(pair.ours);
  }
  void give_up() { lent_.reset(); }

 private:
  void say_anything(fuzz::Input& input) const {
    const auto packet = input.take_bytes(input.take<std::uint8_t>() % 32);
    posix::send_packet(trunk_.get(), packet.data(), packet.size());
  }

  posix::FileDescriptor trunk_;
  posix::FileDescriptor lent_;
};

void send_something(int socket, Hostile& hostile, std::uint32_t& sequence, fuzz::Input& input) {
  std::vector<std::uint8_t> packet;
  const auto choice = input.take<std::uint8_t>();
  switch (choice % 4) {
    case 0:
      packet = valid_segment();
      break;
    case 1:
    case 2:
      packet = valid_record(++sequence, input);
      break;
    default:
      packet = input.take_bytes(input.take<std::uint16_t>() % 2048);
  }
  damage(packet, input);
  if (choice & 0x80 && packet.size() < slot_bytes) {
    hostile.write_into_ring(packet);
    return;
  }
  if (choice & 0x40) ++hostile.ring().publisher.packets;
  const std::vector<int> files = hostile.descriptors(choice % 4 == 0 ? choice / 4 + 4 : choice / 4);
  const iovec whole{packet.data(), packet.size()};
  posix::send_packet(socket, &whole, 1, files.data(), files.size());
}

std::uint64_t read_everything(const Message& message) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < message.control_size(); ++i) sum += message.control()[i];
  for (const ConstBlock& block : message.blocks()) {
    for (std::size_t i = 0; i < block.size; ++i) sum += block.data[i];
  }
  return sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  fuzz::SocketPair sockets;
  Hostile hostile;
  SubscriberOptions options;
  options.handshake_timeout = std::chrono::milliseconds(0);
  const auto greeting = input.take<std::uint8_t>();
  if (greeting == 0) {
    const auto packet = input.take_bytes(64);
    sockets.send(packet.data(), packet.size(), hostile.descriptors(input.take<std::uint8_t>()));
  } else {
    hostile.welcome(sockets, greeting % 4 == 2 ? reads_ring | has_trunk : reads_ring);
  }
  fuzz::SocketPair trunk_sockets;
  Lender lender(std::move(trunk_sockets.ours));
  RingPlace place;
  if (greeting % 2 == 0) place.service = *Service::instance();
  if (greeting % 4 == 2) {
    const auto trunk = *Trunk::start(*place.service, std::move(trunk_sockets.theirs), {{}, 1, true});
    place.number = (*Receiver::instance())->take_number();
    place.trunk = trunk->take_any();
  }
  const std::uint32_t number = place.trunk ? place.trunk->number() : 0;
  auto link = std::make_shared<Link>(std::move(sockets.theirs), Credentials(), std::move(place));
  if (!link->shake_hands(options, 0)) return 0;
  Reader reader(link, options);
  std::vector<MessagePtr> held;
  std::uint32_t sequence = 0;
  std::uint64_t sum = 0;
  while (!input.empty()) {
    if (input.take<std::uint8_t>() % 4 == 0) hostile.scribble(input);
    const auto about_sockets = input.take<std::uint8_t>();
    if (about_sockets % 8 == 0) lender.say(number, input);
    if (about_sockets % 8 == 1) lender.give_up();
    send_something(lender.socket(sockets), hostile, sequence, input);
    MessagePtr message;
    if (reader.read(posix::Waiting::return_at_once, message) == Reader::Result::closed) break;
    if (!message) continue;
    sum += read_everything(*message);
    if (input.take<std::uint8_t>() & 1) held.push_back(std::move(message));
  }
  return sum == 1 ? 1 : 0;
}
