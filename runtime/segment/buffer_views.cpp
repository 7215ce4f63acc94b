// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>

#include "segment/segment.h"
#include "tzc/memory.h"

namespace tzc {
namespace {

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
    // Guard mode watches the publisher's own mapping: a write there is reported, and seen by nobody else.
    if (guard::active) {
      unwatched_.push_back(buffer);
      return ConstBlock{buffer->data(), buffer->size()};
    }
    const std::uint8_t* const data = view(*buffer);
    if (data == nullptr) return ConstBlock{copy(*buffer), buffer->size()};
    viewed_.push_back(buffer);
    return ConstBlock{data, buffer->size()};
  }

 private:
  static segment::OwnViews& views_of(const Buffer& buffer) {
    return segment::Segment::of(buffer).own_views();
  }

  // A view shows the file, where a forked child's own writes are not.
  static const std::uint8_t* view(const Buffer& buffer) {
    return buffer.inherited() ? nullptr : views_of(buffer).begin(static_cast<const segment::Block&>(buffer));
  }

  const std::uint8_t* copy(const Buffer& buffer) {
    copies_.push_back(
        std::make_unique<std::uint8_t[]>(buffer.size()));  // aligned as a std::vector's elements
    std::memcpy(copies_.back().get(), buffer.data(), buffer.size());
    return copies_.back().get();
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
