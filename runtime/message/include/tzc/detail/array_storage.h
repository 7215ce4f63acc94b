// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/sleep_lock.h>
#include <tzc/guard.h>
#include <tzc/memory.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <utility>

// GCC has a macro for it, Clang a feature.
#if defined(__SANITIZE_THREAD__)
#define TZC_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TZC_THREAD_SANITIZER 1
#endif
#endif
#ifndef TZC_THREAD_SANITIZER
#define TZC_THREAD_SANITIZER 0
#endif

// Without a build type catkin compiles without optimisation, and each access to an element would be a chain of calls, three times as slow as
// std::vector's.
#ifdef __OPTIMIZE__
#define TZC_ALWAYS_INLINE \
  inline  // of its own accord, also where a function is compiled for another processor
#else
#define TZC_ALWAYS_INLINE inline __attribute__((always_inline))
#endif

namespace tzc {
namespace detail {

/// Memory for elements: on the heap (`buffer` null, made by std::allocator) or inside a block of a segment.
template <class T>
struct ArrayBlock {
  T* begin = nullptr;
  std::size_t capacity = 0;
  BufferPtr buffer;
};

/// The memory behind a tzc::Array and its copy-on-write rule.
///
///   writable_ != null   this object alone owns the elements; they may be written in place
///   writable_ == null   published: others have them (block_.begin != null), in block_ or in a copy of it, sent_. Or no
///                       memory yet although capacity_ promises some (block_.begin == null). The next write makes memory
///                       first
///
/// What several threads may do with a std::vector at once, they may do here: reading, writing to different elements
/// ([container.requirements.dataraces]: operator[], data(), begin() and their like do not modify it), copying, publishing. So
/// writable(), share(), note_sent() and share_with() may meet: they change hands under a lock. Publishing moves no element, and
/// those that writable() leaves stay readable for who got at them before: on the heap until this object is modified, in a
/// segment until the next publish.
template <class T>
class ArrayStorage {
 public:
  ArrayStorage() = default;
  ArrayStorage(const ArrayStorage&) = delete;
  ArrayStorage& operator=(const ArrayStorage&) = delete;
  ~ArrayStorage() {
    release(block_);
    release(old_heap_);
  }

  TZC_ALWAYS_INLINE const T* begin() const noexcept { return element_pointer(block_.begin); }
  TZC_ALWAYS_INLINE std::size_t size() const noexcept { return size_; }
  std::size_t capacity() const noexcept { return capacity_; }
  const BufferPtr& buffer() const noexcept { return block_.buffer; }
  const std::shared_ptr<MemorySource>& memory() const noexcept { return memory_; }

  /// Size without constructing or writing anything; n <= capacity() and, if it grows, is_writable().
  void set_size(std::size_t n) noexcept { size_ = n; }
  /// What capacity() reports; never more than the memory behind writable elements.
  void set_capacity(std::size_t n) noexcept { capacity_ = n; }

  bool is_writable() const noexcept { return element_pointer(writable_) != nullptr; }
  bool is_shared() const noexcept { return begin() != nullptr && !is_writable(); }
  /// Whether that byte is one of the memory behind the elements.
  bool has(const volatile void* byte) const noexcept {
    const auto begin = reinterpret_cast<std::uintptr_t>(block_.begin);
    return reinterpret_cast<std::uintptr_t>(byte) - begin < block_.capacity * sizeof(T);
  }

  /// The elements for writing; copies them first if they are shared.
  TZC_ALWAYS_INLINE T* writable() {
    T* const elements = element_pointer(writable_);
    if (__builtin_expect(elements != nullptr, 1)) return elements;
    return make_writable();
  }

  T* writable_or_null() noexcept { return writable_; }

  /// Where others may read the elements. Those in a segment are shared from now on: the next write through this object gets
  /// fresh memory. Of those on the heap it returns the copy that was sent before, if there is one, otherwise themselves. In a
  /// forked child, its parent's segments are as the heap: returned without a buffer, to be copied.
  ArrayBlock<T> share() const noexcept {
    const std::lock_guard<SleepLock> changing_hands(lock_);
    left_ = nullptr;
    if (is_inherited(sent_)) take_back_heap();
    if (is_inherited(block_)) return without_buffer(block_);
    if (block_.buffer) publish_pointer(writable_, static_cast<T*>(nullptr));
    return sent_.buffer ? sent_ : block_;
  }

  /// The elements on the heap, which share() returned, were copied to `at`, inside `buffer`, and are sent from there, again and
  /// again until they are written. The next write moves them into `memory`, unless the array has a memory already.
  void note_sent(const std::shared_ptr<MemorySource>& memory, const BufferPtr& buffer,
                 std::uint8_t* at) const noexcept {
    const std::lock_guard<SleepLock> changing_hands(lock_);
    if (block_.buffer || sent_.buffer) return;  // another thread was faster, or the block is the parent's
    if (!memory_) memory_ = memory;
    sent_.begin = reinterpret_cast<T*>(at);
    sent_.capacity = size_;
    sent_.buffer = buffer;
    if (__builtin_expect(guard::active, 0))
      guard::freeze(block_.begin, block_.capacity * sizeof(T), memory.get());
    publish_pointer(writable_, static_cast<T*>(nullptr));
  }

  /// Replaces the memory by fresh memory for `capacity` elements and keeps the first `kept` of them.
  void remake(std::size_t capacity, std::size_t kept) {
    ArrayBlock<T> fresh = acquire_with(capacity, kept);
    install(std::move(fresh));
    capacity_ = capacity;
  }
  /// The same for a caller that copies from where the elements were: `before`, which is empty, keeps that.
  void remake(std::size_t capacity, std::size_t kept, ArrayStorage& before) {
    ArrayBlock<T> fresh = acquire_with(capacity, kept);
    before.swap_elements(*this);
    size_ = before.size_;
    install(std::move(fresh));
    capacity_ = capacity;
  }

  /// Takes over heap memory that std::allocator<T> made.
  void adopt(T* begin, std::size_t size, std::size_t capacity) {
    ArrayBlock<T> block;
    block.begin = begin;
    block.capacity = capacity;
    install(std::move(block));
    size_ = size;
    capacity_ = capacity;
  }

  /// Gives heap memory away; the caller frees it with std::allocator<T>. Leaves this object empty.
  void give_up_heap() noexcept {
    if (__builtin_expect(guard::active, 0)) guard::thaw(block_.begin);
    block_ = ArrayBlock<T>();
    forget();
  }
  bool on_heap() const noexcept { return !block_.buffer; }
  std::size_t heap_capacity() const noexcept { return block_.capacity; }

  /// Drops the elements and their memory; capacity 0.
  void reset() noexcept {
    release(block_);
    forget();
  }

  /// Drops shared elements without copying them; capacity() stays, as after std::vector::clear.
  void drop_elements() noexcept {
    if (is_shared()) {
      release(block_);
      leave_others();
    }
    size_ = 0;
  }

  /// Refers to the same elements as `other`, if those are shared.
  bool share_with(const ArrayStorage& other) {
    ArrayBlock<T> same = other.shared_block();
    if (same.begin == nullptr) return false;
    install(std::move(same));
    writable_ = nullptr;
    size_ = capacity_ = other.size_;
    return true;
  }

  /// Exchanges elements, not the memory source.
  void swap_elements(ArrayStorage& other) noexcept {
    std::swap(block_, other.block_);
    std::swap(writable_, other.writable_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
    std::swap(left_, other.left_);
    std::swap(sent_, other.sent_);
    std::swap(old_heap_, other.old_heap_);
  }

  /// Later growth takes memory from `memory`, or from the heap when that is exhausted.
  void bind(std::shared_ptr<MemorySource> memory) noexcept {
    if (memory != memory_) spare_ = ArrayBlock<T>();
    memory_ = std::move(memory);
  }
  void share_memory_with(ArrayStorage& other) noexcept {
    if (!memory_) memory_ = other.memory_;
    if (!other.memory_) other.memory_ = memory_;
  }
  void take_memory_of(ArrayStorage& other) noexcept {
    memory_ = std::move(other.memory_);
    spare_ = std::move(other.spare_);
  }

  /// Elements that allocate() must find memory for; 0 when they are writable in a segment already, or an earlier allocate() has reserved memory for
  /// the next write.
  std::size_t elements_to_place() const noexcept {
    if (block_.buffer && is_writable() && !is_inherited(block_)) return 0;
    if (is_shared() && spare_.begin != nullptr && spare_.capacity >= capacity_) return 0;
    return is_writable() && size_ != 0 ? size_ : capacity_;
  }

  /// Moves the elements to `at`, inside `buffer`, where elements_to_place() fit. Shared elements are not
  /// copied yet: the memory is kept for the next write.
  void place(const BufferPtr& buffer, void* at) {
    ArrayBlock<T> reserved;
    reserved.begin = static_cast<T*>(at);
    reserved.capacity = elements_to_place();
    reserved.buffer = buffer;
    spare_ = std::move(reserved);
    if (is_shared()) return;
    if (__builtin_expect(guard::active, 0) && block_.begin != nullptr && on_heap()) return retire_heap();
    remake(spare_.capacity, size_);
  }

 private:
  T* make_writable() __attribute__((cold, noinline)) {
    const std::lock_guard<SleepLock> changing_hands(lock_);
    if (writable_ != nullptr) return writable_;  // another thread was faster
    left_ = nullptr;
    if (block_.begin == nullptr) {
      if (capacity_ != 0) remake(capacity_, 0);
      return writable_;
    }
    if (on_heap() && (old_heap_.begin != nullptr || !reserve_segment(capacity_))) return take_back_heap();
    ArrayBlock<T> fresh = acquire(capacity_);
    if (size_ != 0) std::memcpy(static_cast<void*>(fresh.begin), block_.begin, size_ * sizeof(T));
    note_copied(fresh, size_);
    if (on_heap()) {
      old_heap_.begin = block_.begin;
      old_heap_.capacity = block_.capacity;
      sent_ = ArrayBlock<T>();
    }
    left_ = std::exchange(block_.buffer, std::move(fresh.buffer));
    block_.capacity = fresh.capacity;
    publish_pointer(block_.begin, fresh.begin);
    publish_pointer(writable_, fresh.begin);
    return fresh.begin;
  }

  /// It is in memory of the process that this one was forked from.
  static bool is_inherited(const ArrayBlock<T>& block) noexcept {
    return block.buffer && block.buffer->inherited();
  }
  static ArrayBlock<T> without_buffer(const ArrayBlock<T>& block) noexcept {
    ArrayBlock<T> elements;
    elements.begin = block.begin;
    elements.capacity = block.capacity;
    return elements;
  }

  /// Others have the elements, which were copied.
  void note_copied(const ArrayBlock<T>& to, std::size_t count) {
    if (to.buffer && memory_ && count != 0) note_copy(*memory_, count * sizeof(T));
  }

  /// Memory in a segment for the next acquire(). False: there is none.
  bool reserve_segment(std::size_t capacity) {
    if (spare_.begin != nullptr && spare_.capacity >= capacity) return true;
    spare_ = ArrayBlock<T>();
    if (memory_) spare_.buffer = memory_->allocate(capacity * sizeof(T));
    if (!spare_.buffer) return false;
    spare_.begin = reinterpret_cast<T*>(spare_.buffer->data());
    spare_.capacity = capacity;
    return true;
  }

  /// Others have a copy of what was sent, so without memory for another one the elements are written where they are. So they
  /// are when one more thread might read elements that were on the heap before.
  T* take_back_heap() const noexcept {
    sent_ = ArrayBlock<T>();
    if (__builtin_expect(guard::active, 0)) guard::thaw(block_.begin);
    publish_pointer(writable_, block_.begin);
    return block_.begin;
  }

  ArrayBlock<T> shared_block() const {
    const std::lock_guard<SleepLock> changing_hands(lock_);
    if (is_writable()) return ArrayBlock<T>();
    const ArrayBlock<T>& shared = sent_.buffer ? sent_ : block_;
    return is_inherited(shared) ? ArrayBlock<T>() : shared;
  }

  /// A pointer to elements that another thread may just have filled. What is read and written through it depends on the
  /// address, which orders the two on every processor that ROS runs on; ThreadSanitizer wants to be told.
  TZC_ALWAYS_INLINE static T* element_pointer(T* const& pointer) noexcept {
    return __atomic_load_n(&pointer, pointer_order);
  }
  static void publish_pointer(T*& pointer, T* elements) noexcept {
    __atomic_store_n(&pointer, elements, __ATOMIC_RELEASE);
  }
  static constexpr int pointer_order = TZC_THREAD_SANITIZER ? __ATOMIC_ACQUIRE : __ATOMIC_RELAXED;

  ArrayBlock<T> acquire(std::size_t capacity) {
    // Room beside an array that was published meanwhile: writing there is right, but guard mode cannot tell.
    const bool is_watched = __builtin_expect(guard::active, 0) && spare_.buffer && spare_.buffer->sealed();
    if (spare_.begin != nullptr && spare_.capacity >= capacity && !is_watched)
      return std::exchange(spare_, ArrayBlock<T>());
    spare_ = ArrayBlock<T>();
    ArrayBlock<T> block;
    if (capacity == 0) return block;
    block.capacity = capacity;
    if (memory_) block.buffer = memory_->allocate(capacity * sizeof(T));
    block.begin = block.buffer ? reinterpret_cast<T*>(block.buffer->data()) : allocate_on_heap(capacity);
    return block;
  }

  ArrayBlock<T> acquire_with(std::size_t capacity, std::size_t kept) {
    ArrayBlock<T> fresh = acquire(capacity);
    if (kept != 0) std::memcpy(static_cast<void*>(fresh.begin), block_.begin, kept * sizeof(T));
    if (is_shared()) note_copied(fresh, kept);
    return fresh;
  }

  static T* allocate_on_heap(std::size_t capacity) {
    void* const guarded =
        __builtin_expect(guard::active, 0) ? guard::allocate(capacity * sizeof(T)) : nullptr;
    return guarded != nullptr ? static_cast<T*>(guarded) : std::allocator<T>().allocate(capacity);
  }

  /// As remake(), in guard mode: pointers into the heap memory are watched.
  void retire_heap() __attribute__((cold, noinline)) {
    ArrayBlock<T> old;
    std::swap(old, block_);
    ArrayBlock<T> fresh = acquire(spare_.capacity);
    if (size_ != 0) std::memcpy(static_cast<void*>(fresh.begin), old.begin, size_ * sizeof(T));
    install(std::move(fresh));
    capacity_ = block_.capacity;
    guard::retire(old.begin, old.capacity * sizeof(T), memory_.get());
  }

  void install(ArrayBlock<T>&& block) noexcept {
    leave_others();
    release(block_);
    block_ = std::move(block);
    writable_ = block_.begin;
  }

  static void release(ArrayBlock<T>& block) noexcept {
    if (block.begin != nullptr && !block.buffer) {
      if (__builtin_expect(guard::active, 0)) guard::thaw(block.begin);
      std::allocator<T>().deallocate(block.begin, block.capacity);
    }
    block = ArrayBlock<T>();
  }

  /// This object is modified, so no other thread reads through it.
  void leave_others() noexcept {
    left_ = nullptr;
    sent_ = ArrayBlock<T>();
    release(old_heap_);
  }

  void forget() noexcept {
    leave_others();
    writable_ = nullptr;
    size_ = capacity_ = 0;
  }

  mutable T* writable_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  ArrayBlock<T> block_;
  ArrayBlock<T> spare_;
  mutable std::shared_ptr<MemorySource> memory_;
  mutable SleepLock lock_;
  mutable BufferPtr left_;      ///< what writable() has copied from
  mutable ArrayBlock<T> sent_;  ///< the same elements in a segment, while those on the heap are not written
  ArrayBlock<T> old_heap_;      ///< what writable() has copied from, and nobody else has
};

}  // namespace detail
}  // namespace tzc

#undef TZC_THREAD_SANITIZER
