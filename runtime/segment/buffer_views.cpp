// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <new>

#include "segment/layout.h"
#include "segment/segment.h"
#include "tzc/memory.h"

namespace tzc {
namespace {

std::size_t aligned(std::size_t bytes) {
  return (bytes + segment::cache_line - 1) / segment::cache_line * segment::cache_line;
}

// Views of some buffers, and copies of those that cannot have one.
class Views {
 public:
  explicit Views(std::size_t buffers) {  // what show() has begun must be kept without memory for it
    viewed_.reserve(buffers);
    unwatched_.reserve(buffers);
  }
  ~Views() {
    for (const BufferPtr& buffer : viewed_)
      views_of(*buffer).end(static_cast<const segment::Block&>(*buffer));
  }

  ConstBlock show(const BufferPtr& buffer) {
    buffer->seal();
    if (guard::
            active) {  // which watches the publisher's own mapping: a write there is reported, and seen by nobody else
      unwatched_.push_back(buffer);
      return ConstBlock{buffer->data(), buffer->size()};
    }
    const std::uint8_t* data = views_of(*buffer).begin(static_cast<const segment::Block&>(*buffer));
    if (data != nullptr) {
      viewed_.push_back(buffer);
    } else {
      data = copy(*buffer);
    }
    return ConstBlock{data, buffer->size()};
  }

 private:
  static segment::OwnViews& views_of(const Buffer& buffer) {
    return segment::Segment::of(buffer).own_views();
  }

  const std::uint8_t* copy(const Buffer& buffer) {
    copies_.emplace_back(new std::uint8_t[buffer.size() + segment::cache_line]);
    std::uint8_t* const memory = copies_.back().get();
    std::uint8_t* const begin = memory + (aligned(reinterpret_cast<std::uintptr_t>(memory)) -
                                          reinterpret_cast<std::uintptr_t>(memory));
    std::memcpy(begin, buffer.data(), buffer.size());
    return begin;
  }

  std::vector<BufferPtr> viewed_;
  std::vector<BufferPtr> unwatched_;
  std::vector<std::unique_ptr<std::uint8_t[]>> copies_;
};

}  // namespace

BufferViews view_for_callbacks(const BufferSpan& buffers) {
  const auto views = std::make_shared<Views>(buffers.size());
  BufferViews shown;
  for (const BufferPtr& buffer : buffers) shown.blocks.push_back(views->show(buffer));
  shown.hold = views;
  return shown;
}

}  // namespace tzc
