// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <tzc/error.h>
#include <tzc/guard.h>
#include <tzc/policy.h>

// The publisher's shared memory in the publisher's own process.
//
//   SegmentMemory --allocate--> BufferPtr --fill, seal--> channel::make_record --> subscribers
//        ^                                                                            |
//        +---- reclaimed by a later allocate, once no BufferPtr and no subscriber ----+
//              references the block

namespace tzc {

namespace segment {
struct Block;
class Segment;
class SegmentMemoryImpl;
}  // namespace segment

/// One block of a segment. Reference counted by this process's handles (BufferPtr); thread-safe except for
/// the payload itself, which belongs to the thread that fills it until it is sealed.
class Buffer {
 public:
  /// First byte of the payload, aligned to a cache line (64 bytes). Valid while a BufferPtr exists.
  std::uint8_t* data() const noexcept { return data_; }
  /// Usable bytes, at least as many as allocate() was asked for.
  std::size_t size() const noexcept { return size_; }
  /// Sealed: published or shared. The content does not change until the block is reclaimed.
  bool sealed() const noexcept { return sealed_.load(std::memory_order_acquire); }
  /// In a forked child: the buffer is its parent's. What the child writes there stays the child's own, and the parent may reuse
  /// the block at any time. So a child cannot publish it: copy what is in it. Any thread.
  bool inherited() const noexcept;
  /// One way: a sealed buffer stays sealed until its block is reclaimed. Any thread.
  void seal() noexcept {
    sealed_.store(true, std::memory_order_release);
    if (__builtin_expect(guard::active, 0)) guard_published();
  }

 private:
  friend class BufferPtr;
  friend class segment::Segment;
  friend struct segment::Block;
  Buffer() noexcept = default;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  void guard_published() noexcept;
  void release_last() noexcept;  // drops the block's reference to its segment, perhaps the last one

  std::atomic<std::uint32_t> references_{0};
  std::atomic<bool> sealed_{false};
  std::uint32_t slot_ = 0;
  std::uint32_t generation_ = 0;
  std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
  segment::Segment* segment_ = nullptr;
};

/// A reference to a Buffer: while one exists the block is not reclaimed and its segment stays mapped.
/// Copying is cheap and thread-safe; a single BufferPtr object is not safe for concurrent writes.
class BufferPtr {
 public:
  BufferPtr() noexcept = default;
  BufferPtr(std::nullptr_t) noexcept {}  // NOLINT: implicit like every smart pointer
  BufferPtr(const BufferPtr& other) noexcept : buffer_(other.buffer_) { acquire(); }
  BufferPtr(BufferPtr&& other) noexcept : buffer_(other.buffer_) { other.buffer_ = nullptr; }
  ~BufferPtr() { drop(); }
  BufferPtr& operator=(BufferPtr other) noexcept {
    swap(other);
    return *this;
  }

  Buffer* get() const noexcept { return buffer_; }
  Buffer* operator->() const noexcept { return buffer_; }
  Buffer& operator*() const noexcept { return *buffer_; }
  explicit operator bool() const noexcept { return buffer_ != nullptr; }
  void reset() noexcept { BufferPtr().swap(*this); }
  void swap(BufferPtr& other) noexcept { std::swap(buffer_, other.buffer_); }
  friend bool operator==(const BufferPtr& a, const BufferPtr& b) noexcept { return a.buffer_ == b.buffer_; }
  friend bool operator!=(const BufferPtr& a, const BufferPtr& b) noexcept { return a.buffer_ != b.buffer_; }

 private:
  friend struct segment::Block;
  struct Adopt {};
  BufferPtr(Buffer* buffer, Adopt) noexcept : buffer_(buffer) {}  // adopts a counted reference
  void acquire() const noexcept {
    if (buffer_) buffer_->references_.fetch_add(1, std::memory_order_relaxed);
  }
  void drop() noexcept {
    if (buffer_ && buffer_->references_.fetch_sub(1, std::memory_order_acq_rel) == 1) buffer_->release_last();
  }

  Buffer* buffer_ = nullptr;
};

/// A parameter type for contiguous handles: a vector, or a list in braces. Owns nothing; valid while its
/// source lives.
class BufferSpan {
 public:
  BufferSpan() noexcept = default;
  BufferSpan(const BufferPtr* first, std::size_t size) noexcept : first_(first), size_(size) {}
  BufferSpan(const std::vector<BufferPtr>& buffers) noexcept  // NOLINT: implicit, as std::span from a vector
      : BufferSpan(buffers.data(), buffers.size()) {}
  BufferSpan(std::initializer_list<BufferPtr> buffers) noexcept  // NOLINT: implicit, for a list in braces
      : BufferSpan(buffers.begin(), buffers.size()) {}

  const BufferPtr* begin() const noexcept { return first_; }
  const BufferPtr* end() const noexcept { return first_ + size_; }
  std::size_t size() const noexcept { return size_; }

 private:
  const BufferPtr* first_ = nullptr;
  std::size_t size_ = 0;
};

/// A source of memory for message arrays. Held by std::shared_ptr everywhere; thread-safe.
class MemorySource {
 public:
  virtual ~MemorySource() = default;
  /// A new unsealed buffer of at least `bytes` (1 for 0), its content unspecified: earlier bytes of this
  /// publisher, never anyone else's. Null when exhausted, after the publication policy has been applied.
  virtual BufferPtr allocate(std::size_t bytes) = 0;
};

/// When a segment's pages are committed. allocate always *reserves* pages before it returns a block, so a
/// full tmpfs is an error of allocate and never a SIGBUS.
enum class Prefault {
  none,          ///< each page when it is first written: cheapest for memory that may never be written
  on_first_use,  ///< all pages of a fresh block when it is first allocated (default)
  all,           ///< the whole segment when it is created: no page fault ever after
};

/// How a segment memory is laid out; fixed when it is created.
struct MemoryOptions {
  /// Total payload bytes of shared memory (the blocks' own headers come on top). 0: the first segment is
  /// sized at the first allocate, for max(4, queue_size + 2) blocks of that size, and more segments are added
  /// when needed, up to `ceiling`.
  std::size_t size = 0;
  std::size_t queue_size = 0;                  ///< of the publisher; only used when size is 0
  std::size_t ceiling = std::size_t{1} << 30;  ///< most bytes that size 0 grows to; 1 GiB by default
  Policy policy{};                             ///< what allocate does when the memory is full
  Prefault prefault = Prefault::on_first_use;  ///< when pages are committed
  std::string name{};                          ///< shown by diagnostics, e.g. the topic
  /// Its segments lie in one file with those of all memories of this process that say so: two descriptors for all of
  /// them. Whoever is sent one can read all, so only where every publisher admits the same processes of this user alone.
  /// Where the system has no such files, each segment has one of its own.
  bool pooled = false;
};

/// A snapshot of one publisher's memory. Bytes and counts since creation.
struct MemoryStats {
  std::size_t segments = 0;        ///< now
  std::size_t size_bytes = 0;      ///< address space of all segments
  std::size_t reserved_bytes = 0;  ///< committed in tmpfs; never shrinks while a segment lives
  std::size_t used_bytes = 0;      ///< blocks allocated and not reclaimed yet
  std::size_t used_blocks = 0;
  std::uint64_t allocated = 0;  ///< allocate calls that succeeded
  std::uint64_t refused = 0;    ///< allocate calls that returned null
  std::uint64_t reclaimed = 0;  ///< blocks taken back, lazily, after their last reference went
  std::uint64_t revoked = 0;    ///< blocks taken back from subscribers' queues (best_effort)
};

/// Why an allocate returned null.
struct AllocationError : Error {
  enum class Cause {
    none,       ///< no allocate was refused so far
    in_use,     ///< what is in use leaves no room for it
    too_large,  ///< the whole memory is smaller, so the same allocate will never succeed
    system,  ///< the system, a limit of this process (set_memory_ceiling) or of its control group refuses pages
  };
  Cause cause = Cause::none;
};

/// The shared memory of one publisher: one or several segments. Only the publisher's process allocates in
/// them. Thread-safe. In a forked child allocate returns null: the memory stays the parent's.
class SegmentMemory final : public MemorySource {
 public:
  /// Errors: no descriptor, no memory, or a size that the system refuses.
  static Expected<std::shared_ptr<SegmentMemory>> create(const MemoryOptions& options = MemoryOptions());
  ~SegmentMemory() override;

  /// Never blocks on another process. See MemorySource and Policy.
  BufferPtr allocate(std::size_t bytes) override;
  MemoryStats stats() const;
  /// Why the latest allocate returned null; empty text before the first failure.
  AllocationError last_failure() const;
  const MemoryOptions& options() const;
  /// What note_copy() has counted.
  std::uint64_t copied_bytes() const noexcept;

 private:
  friend void note_copy(MemorySource& memory, std::size_t bytes) noexcept;
  explicit SegmentMemory(std::unique_ptr<segment::SegmentMemoryImpl> impl);
  std::unique_ptr<segment::SegmentMemoryImpl> impl_;
  std::atomic<std::uint64_t> copied_bytes_{0};
};

/// Counts elements that were copied into the memory because their owner writes them again while others have them. For
/// SegmentMemory::copied_bytes; other sources count nothing. Any thread.
void note_copy(MemorySource& memory, std::size_t bytes) noexcept;

/// A block in a subscriber's process: read-only, valid while the received message lives.
struct ConstBlock {
  const std::uint8_t* data;
  std::size_t size;
};

/// Bytes of a live block: where they begin in its payload.
struct FoundBuffer {
  BufferPtr buffer;
  std::size_t offset = 0;
};

/// The live block of one of THIS process's segments whose payload has these bytes at [address, address + bytes), in the segment or
/// in a view (view_for_callbacks) that nobody has written to; null otherwise.
/// Thread-safe and cheap. The caller must hold another reference to the block, or the view, during the call.
FoundBuffer find_in_buffer(const void* address, std::size_t bytes);
/// Its buffer alone.
BufferPtr find_buffer(const void* address, std::size_t bytes);

/// What code of the publisher's own process, which may write to it in spite of the const, is shown of published buffers. A write
/// changes these bytes alone.
struct BufferViews {
  std::vector<ConstBlock> blocks;    ///< in the buffers' order
  std::shared_ptr<const void> hold;  ///< keeps them, and the buffers
};

/// Seals the buffers. Payloads below a page, those of which other such views live, and all where the system refuses them, are
/// copied, and so are a forked child's inherited ones. In guard mode, which keeps late writes to itself and reports them, the
/// blocks are the buffers' own bytes. Any thread. A
/// thread that writes must not block SIGSEGV. Throws std::bad_alloc.
BufferViews view_for_callbacks(const BufferSpan& buffers);

/// True when the address lies in a mapping of any segment, own or received. Thread-safe.
bool in_segment(const void* address);

}  // namespace tzc
