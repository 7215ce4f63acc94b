// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "segment/block.h"
#include "segment/fork_copies.h"
#include "segment/private_views.h"
#include "segment/registry.h"
#include "segment/segment_file.h"

namespace tzc {
namespace segment {

/// The blocks of one segment as callbacks of the publisher's own process see them: in a mapping of their own, so that a write
/// changes bytes of this process alone (private_views.h). Neither a subscriber nor the publisher's own message sees it. The
/// mapping is made for the first view. A block has one view at a time: who had it may have written to it. Thread-safe.
class OwnViews final : public ForkCopied {
 public:
  /// Both outlive this.
  OwnViews(const SegmentFile& file, const OwnSegment& owner) : file_(file), owner_(owner) {}
  OwnViews(const OwnViews&) = delete;
  OwnViews& operator=(const OwnViews&) = delete;
  ~OwnViews();

  /// The payload in a view. Null: it has no pages of its own (small), has a view already, or the system refuses such views.
  const std::uint8_t* begin(const Block& block);
  /// The view that begin() returned is gone.
  void end(const Block& block);
  /// Where the view's bytes at this address lie in the segment. False: no view lies there.
  bool offset_of(const std::uint8_t* address, std::uint64_t& offset) const;
  /// Whether the view of the payload that begins there was written to, so that it shows other bytes than the segment. After
  /// offset_of().
  bool is_written(std::uint64_t offset) const;

  // A forked child goes on to see the views that the forking thread keeps until fork() returns.
  bool hold_for_child() noexcept override { return views_->has_views(); }
  bool copy_in_child() noexcept override { return views_->copy_in_child(); }
  void release_for_child() noexcept override {}

 private:
  bool open();

  const SegmentFile& file_;
  const OwnSegment& owner_;
  std::mutex mutex_;
  std::unique_ptr<PrivateViews> views_;
  std::atomic<const std::uint8_t*> base_{
      nullptr};  // views_->data(); offset_of() runs under the registry's lock, so takes none
};

}  // namespace segment
}  // namespace tzc
