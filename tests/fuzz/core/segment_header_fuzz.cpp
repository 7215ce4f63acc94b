// SPDX-License-Identifier: BSD-3-Clause
// A hostile publisher's files: any header, any acknowledgements, any offer, any reference.
#include <cstring>

#include "input.h"
#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "segment/received_segment.h"

namespace {

using namespace tzc;  // NOLINT: a fuzz target, not a header

constexpr std::size_t file_bytes = 16384;
constexpr std::uint32_t slots = 64;

/// The header lies at `begin`.
struct ValidHeader {
  const void* bytes;
  std::size_t size, begin;
};

posix::FileDescriptor sealed_file(const std::vector<std::uint8_t>& content, std::size_t offset,
                                  const ValidHeader& header, bool keep_valid) {
  auto file = posix::create_memory_file("fuzz", file_bytes, posix::Sharing::peers_read);
  auto mapping = posix::Mapping::map(file->descriptor.get(), file_bytes, posix::Access::read_write);
  if (keep_valid) std::memcpy(mapping->data() + header.begin, header.bytes, header.size);
  const std::size_t at =
      std::min(keep_valid ? std::max(offset, header.begin + header.size) : offset, file_bytes);
  std::copy_n(content.begin(), std::min(content.size(), file_bytes - at), mapping->data() + at);
  posix::seal(*file, posix::Sharing::peers_write);
  return std::move(file->descriptor);
}

segment::BlockRef take_ref(fuzz::Input& input) {
  auto ref = input.take<segment::BlockRef>();
  if (input.take<std::uint8_t>() & 1) ref.offset = ref.offset % (2 * file_bytes) / 64 * 64;
  if (input.take<std::uint8_t>() & 1) ref.slot %= 2 * slots;
  return ref;
}

std::uint64_t read_everything(const ConstBlock& block) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < block.size; ++i) sum += block.data[i];
  return sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const auto choice = input.take<std::uint8_t>();
  const std::size_t begin = choice & 8 ? file_bytes / 4 : 0;  // of the segment in its file
  segment::SegmentOffer offer{1, file_bytes - begin, file_bytes, file_bytes, begin, slots};
  if (choice & 1) offer = input.take<segment::SegmentOffer>();
  const segment::SegmentHeader header{
      segment::segment_magic, segment::layout_version, offer.slots, offer.id, offer.size, {}};
  const std::uint64_t ack_header[] = {segment::ack_magic,
                                      std::uint64_t{offer.slots} << 32 | segment::layout_version};
  auto data_file = sealed_file(input.take_bytes(input.take<std::uint16_t>() % 4096),
                               input.take<std::uint16_t>(), {&header, sizeof header, begin}, choice & 2);
  auto ack_file = sealed_file(input.take_bytes(input.take<std::uint16_t>() % 1024),
                              input.take<std::uint16_t>(), {ack_header, sizeof ack_header, 0}, choice & 4);
  auto opened = segment::ReceivedSegment::open(offer, std::move(data_file), std::move(ack_file));
  const auto* segment_ptr = std::get_if<std::shared_ptr<segment::ReceivedSegment>>(&opened);
  if (segment_ptr == nullptr) return 0;
  segment::ReceivedSegment& segment = **segment_ptr;
  std::uint64_t sum = 0;
  for (int i = 0; i < 16 && !input.empty(); ++i) {
    const segment::BlockRef ref = take_ref(input);
    if (!segment.check(ref)) continue;
    if (segment.take(ref)) segment.release(ref);
    sum += read_everything(segment.block(ref));
  }
  return sum == 1 ? 1 : 0;
}
