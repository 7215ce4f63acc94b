// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/message.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace tzc {
namespace message {
namespace detail {
namespace {

constexpr std::size_t usual_control_size = 256;

template <class T>
void put(std::uint8_t* to, T value) {
  std::memcpy(to, &value, sizeof value);
}

}  // namespace

ControlWriter::ControlWriter(Encoded& encoded) : encoded_(encoded) {
  encoded_.control.clear();
  encoded_.control.reserve(usual_control_size);
  encoded_.buffers.clear();
  encoded_.copied_bytes = 0;
}

std::uint8_t* ControlWriter::advance(std::uint32_t size) {
  const std::size_t at = encoded_.control.size();
  encoded_.control.resize(at + size);
  return encoded_.control.data() + at;
}

void ControlWriter::reference(const BufferPtr& buffer, std::size_t offset, std::size_t count,
                              std::size_t element_size) {
  if (!begin_entry(count, element_size)) return;
  referenced_bytes_ += count * element_size;
  end_entry(index_of(buffer), offset);
}

void ControlWriter::array(const void* data, std::size_t count, std::size_t element_size, CopiedArray owner) {
  const std::size_t bytes = count * element_size;
  if (bytes != 0) {
    const FoundBuffer found = find_in_buffer(data, bytes);
    if (found.buffer) return reference(found.buffer, found.offset, count, element_size);
  }
  if (!begin_entry(count, element_size)) return;
  copies_.push_back(Copy{data, bytes, encoded_.control.size(), owner});
  end_entry(0, copied_size_);
  copied_size_ += aligned(bytes);
}

bool ControlWriter::finish(const std::shared_ptr<MemorySource>& memory) {
  if (too_long_ || is_overused()) return false;
  return copies_.empty() || make_copies(memory);
}

bool ControlWriter::begin_entry(std::size_t count, std::size_t element_size) {
  if (count > std::numeric_limits<std::uint32_t>::max()) too_long_ = true;
  put(advance(4), static_cast<std::uint32_t>(count));
  if (count == 0 || too_long_) return false;
  put(advance(4), static_cast<std::uint32_t>(element_size));
  return true;
}

void ControlWriter::end_entry(std::uint32_t block, std::uint64_t offset) {
  put(advance(4), block);
  put(advance(8), offset);
}

std::uint32_t ControlWriter::index_of(const BufferPtr& buffer) {
  auto& buffers = encoded_.buffers;
  const auto known = std::find(buffers.begin(), buffers.end(), buffer);
  const auto index = static_cast<std::uint32_t>(known - buffers.begin());
  if (known == buffers.end()) buffers.push_back(buffer);
  return index;
}

bool ControlWriter::is_overused() const {
  std::uint64_t size = 0;
  for (const BufferPtr& buffer : encoded_.buffers) size += buffer->size();
  return referenced_bytes_ > most_overlap * size;
}

bool ControlWriter::make_copies(const std::shared_ptr<MemorySource>& memory) {
  const BufferPtr buffer = memory->allocate(copied_size_);
  if (!buffer) return false;
  const auto block = static_cast<std::uint32_t>(encoded_.buffers.size());
  encoded_.buffers.push_back(buffer);
  std::size_t offset = 0;
  for (const Copy& copy : copies_) {
    std::uint8_t* const at = buffer->data() + offset;
    std::memcpy(at, copy.data, copy.bytes);
    if (copy.owner.note_sent != nullptr) copy.owner.note_sent(copy.owner.owner, memory, buffer, at);
    put(encoded_.control.data() + copy.entry, block);
    offset += aligned(copy.bytes);
    encoded_.copied_bytes += copy.bytes;
  }
  return true;
}

std::vector<ConstBlock> seal_blocks(Encoded& encoded) {
  std::vector<ConstBlock> blocks;
  blocks.reserve(encoded.buffers.size());
  for (const BufferPtr& buffer : encoded.buffers) {
    buffer->seal();
    blocks.push_back(ConstBlock{buffer->data(), buffer->size()});
  }
  return blocks;
}

std::shared_ptr<const void> hold_buffers(const Encoded& encoded) {
  return std::make_shared<const std::vector<BufferPtr>>(encoded.buffers);
}

}  // namespace detail
}  // namespace message
}  // namespace tzc
