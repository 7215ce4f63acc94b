// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/detail/partial_input.h>

#include <cstring>

namespace tzc {
namespace message {
namespace detail {
namespace {

std::uint64_t total_size(const std::vector<ConstBlock>& blocks) {
  std::uint64_t size = 0;
  for (const ConstBlock& block : blocks) size += block.size;
  return size;
}

}  // namespace

ControlReader::ControlReader(const std::uint8_t* control, std::size_t size,
                             const std::vector<ConstBlock>& blocks)
    : at_(control),
      end_(control + size),
      blocks_(blocks),
      array_bytes_left_(most_overlap * total_size(blocks)) {}

template <class T>
T ControlReader::read() {
  T value;
  std::memcpy(&value, advance(sizeof value), sizeof value);
  return value;
}

DataArray ControlReader::array(std::size_t element_size, std::size_t alignment) {
  const auto count = read<std::uint32_t>();
  if (count == 0) return DataArray{nullptr, 0};
  if (read<std::uint32_t>() != element_size) throw_malformed();
  const auto block = read<std::uint32_t>();
  const auto offset = read<std::uint64_t>();
  const std::uint64_t bytes = std::uint64_t{count} * element_size;
  if (block >= blocks_.size() || offset > blocks_[block].size || bytes > blocks_[block].size - offset) {
    throw_malformed();
  }
  if (bytes > array_bytes_left_) throw_malformed();
  array_bytes_left_ -= bytes;
  const std::uint8_t* const data = blocks_[block].data + offset;
  if (reinterpret_cast<std::uintptr_t>(data) % alignment != 0) throw_malformed();
  return DataArray{data, count};
}

std::size_t ControlReader::vector_size(std::size_t least) {
  const auto count = read<std::uint32_t>();
  if (count != 0 && (least == 0 || count > remaining() / least)) throw_malformed();
  return count;
}

void ControlReader::throw_malformed() {
  throw Malformed();
}

}  // namespace detail
}  // namespace message
}  // namespace tzc
