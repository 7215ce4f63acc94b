// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/array_storage.h>
#include <tzc/detail/element_copy.h>
#include <tzc/detail/vector_words.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace tzc {

/// Tag for `resize(n, tzc::uninitialized)`.
struct uninitialized_t {
  explicit constexpr uninitialized_t(int) {}  // not from {}, which means T() in resize(n, {})
};
constexpr uninitialized_t uninitialized{0};

/// A data array of a message: std::vector<T>'s interface and value semantics, in shared memory.
///
/// *Where the elements live.* On the heap until the array is bound to a publisher's memory (bind(), or
/// tzc::message::allocate for a whole message), then in that memory. Growth stays there; when the memory is
/// exhausted the elements move to the heap, nothing is lost, and publishing copies them once.
///
/// *Publishing* shares the elements with subscribers, or copies those on the heap once for all subscribers, and binds an
/// array that was not bound. It moves no element. The first later write through this object gets fresh
/// memory (copy-on-write), so no write reaches a subscriber. clear(), assign(), = and resize(n,
/// uninitialized) copy nothing then; every other non-const access to elements, begin() and operator[]
/// included, copies them all: read a published array through a const reference. Copies of a published array
/// share its memory too, unless they are assigned to an array that has room of its own; copies of any other
/// array are deep and live on the heap.
///
/// *Differences from std::vector<T>*: publishing invalidates pointers, references and iterators; T must be
/// trivially copyable; conversion to a vector is explicit; swap() keeps each object's binding; no allocator
/// but std::allocator; std::erase and std::erase_if (C++20) are std::vector's alone.
///
/// *Thread-safety* as std::vector's: concurrent const access is safe, publishing and copying count as const;
/// so is concurrent access to different elements, also the first one after publishing: one thread copies, the
/// others wait for it. But a begin() and an end() may belong to different memory, const or not, when in between another thread is
/// the first to write after publishing; and such a writer may give the memory back that a const reader still reads. Where threads share a
/// published array, let all of them read it by const access, and write to copies.
/// *Errors*: std::length_error, std::out_of_range and std::bad_alloc where std::vector throws them.
template <class T>
class Array {
  static_assert(std::is_trivially_copyable<T>::value, "elements of a data array are copied as bytes");
  static_assert(!std::is_same<T, bool>::value, "ROS represents bool[] by std::vector<uint8_t>");

  template <class It>
  using IfIterator =
      typename std::enable_if<std::is_convertible<typename std::iterator_traits<It>::iterator_category,
                                                  std::input_iterator_tag>::value>::type;
  template <class It>
  using IfRange = typename std::enable_if<!std::is_convertible<It, T>::value, IfIterator<It> >::type;
  using Element = detail::ElementCopy<T>;

 public:
  using value_type = T;
  using allocator_type = std::allocator<T>;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using reference = T&;
  using const_reference = const T&;
  using pointer = T*;
  using const_pointer = const T*;
  using iterator = T*;
  using const_iterator = const T*;
  using reverse_iterator = std::reverse_iterator<iterator>;
  using const_reverse_iterator = std::reverse_iterator<const_iterator>;

  Array() noexcept = default;
  explicit Array(const allocator_type&) noexcept {}
  explicit Array(size_type n, const allocator_type& = allocator_type()) { resize(n); }
  Array(size_type n, const T& value, const allocator_type& = allocator_type()) { assign(n, value); }
  template <class It, class = IfIterator<It> >
  Array(It first, It last, const allocator_type& = allocator_type()) {
    assign(first, last);
  }
  Array(std::initializer_list<T> values, const allocator_type& = allocator_type()) { assign(values); }
  Array(const Array& other) { copy_from(other); }
  Array(Array&& other) noexcept {
    storage_.swap_elements(other.storage_);
    storage_.take_memory_of(other.storage_);
  }
  explicit Array(const std::vector<T>& values) { assign(values.begin(), values.end()); }
  explicit Array(std::vector<T>&& values) { take(values); }
  ~Array() = default;

  Array& operator=(const Array& other) {
    if (this != &other) copy_from(other);
    return *this;
  }
  /// Keeps this object's own binding if it has one.
  Array& operator=(Array&& other) noexcept {
    if (this == &other) return *this;
    storage_.reset();
    storage_.swap_elements(other.storage_);
    if (!storage_.memory()) storage_.take_memory_of(other.storage_);
    return *this;
  }
  Array& operator=(std::initializer_list<T> values) {
    assign(values);
    return *this;
  }
  /// array = {first, last}, of one type: as std::vector's constructor. Throws std::length_error for another number of iterators.
  template <class It, class = IfRange<It> >
  Array& operator=(std::initializer_list<It> ends) {
    if (ends.size() != 2) throw std::length_error("tzc::Array: a range has two ends");
    assign(*ends.begin(), *(ends.begin() + 1));
    return *this;
  }
  Array& operator=(const std::vector<T>& values) {
    assign(values.begin(), values.end());
    return *this;
  }
  /// Takes over the vector's memory, or copies into this array's own segment memory if that is large enough. The
  /// vector is empty afterwards.
  Array& operator=(std::vector<T>&& values) {
    if (!bound_buffer_has_room(values.size())) {
      take(values);
      return *this;
    }
    assign(values.begin(), values.end());
    values.clear();
    return *this;
  }

  explicit operator std::vector<T>() const {
    std::vector<T> vector;
    copy_to(vector);
    return vector;
  }
  /// Assigns the elements to a std::vector<T> with any allocator, also while other threads read, publish or copy this array.
  template <class Vector>
  void copy_to(Vector& vector) const {
    const T* const first = data();  // asked for twice it might have moved meanwhile
    vector.assign(first, first + size());
  }

  void assign(size_type n, const T& value) {
    const Element copy(value);
    std::fill_n(replace(n), n, *copy);
  }
  template <class It, class = IfIterator<It> >
  void assign(It first, It last) {
    assign_range(first, last, typename std::iterator_traits<It>::iterator_category());
  }
  void assign(std::initializer_list<T> values) { assign(values.begin(), values.end()); }
  allocator_type get_allocator() const noexcept { return allocator_type(); }

  TZC_ALWAYS_INLINE iterator begin() { return data(); }
  TZC_ALWAYS_INLINE const_iterator begin() const noexcept { return data(); }
  const_iterator cbegin() const noexcept { return data(); }
  TZC_ALWAYS_INLINE iterator end() { return data() + size(); }
  TZC_ALWAYS_INLINE const_iterator end() const noexcept { return data() + size(); }
  const_iterator cend() const noexcept { return data() + size(); }
  reverse_iterator rbegin() { return reverse_iterator(end()); }
  const_reverse_iterator rbegin() const noexcept { return const_reverse_iterator(end()); }
  const_reverse_iterator crbegin() const noexcept { return const_reverse_iterator(end()); }
  reverse_iterator rend() { return reverse_iterator(begin()); }
  const_reverse_iterator rend() const noexcept { return const_reverse_iterator(begin()); }
  const_reverse_iterator crend() const noexcept { return const_reverse_iterator(begin()); }

  bool empty() const noexcept { return storage_.size() == 0; }
  TZC_ALWAYS_INLINE size_type size() const noexcept { return storage_.size(); }
  size_type max_size() const noexcept { return std::numeric_limits<difference_type>::max() / sizeof(T); }
  size_type capacity() const noexcept { return storage_.capacity(); }
  void reserve(size_type n) {
    if (n <= capacity()) return;
    if (storage_.is_shared() && !storage_.on_heap()) return storage_.set_capacity(checked(n));
    storage_.remake(checked(n), size());
  }
  void shrink_to_fit() {
    if (capacity() == size()) return;
    if (storage_.on_heap()) return size() == 0 ? storage_.reset() : storage_.remake(size(), size());
    storage_.set_capacity(size());
  }
  void resize(size_type n) { resize_with(n); }
  void resize(size_type n, const T& value) { resize_with(n, value); }
  /// Copies nothing and fills nothing: the value of every element is unspecified, so the caller must write
  /// all of them. Unwritten elements may show earlier bytes of this publisher, never another's.
  void resize(size_type n, uninitialized_t) {
    if (n == 0) return clear();
    if (n > capacity() || !storage_.is_writable()) remake_unfilled(std::max(checked(n), capacity()));
    storage_.set_size(n);
  }

  TZC_ALWAYS_INLINE T& operator[](size_type i) { return data()[expected(i)]; }
  TZC_ALWAYS_INLINE const T& operator[](size_type i) const noexcept { return data()[expected(i)]; }
  TZC_ALWAYS_INLINE T& at(size_type i) { return data()[in_range(i)]; }
  TZC_ALWAYS_INLINE const T& at(size_type i) const { return data()[in_range(i)]; }
  T& front() { return (*this)[0]; }
  const T& front() const noexcept { return (*this)[0]; }
  T& back() { return (*this)[size() - 1]; }
  const T& back() const noexcept { return (*this)[size() - 1]; }
  TZC_ALWAYS_INLINE T* data() { return storage_.writable(); }
  TZC_ALWAYS_INLINE const T* data() const noexcept { return storage_.begin(); }

  void push_back(const T& value) { emplace_back(value); }
  template <class... Args>
  T& emplace_back(Args&&... args) {
    const Element made(std::forward<Args>(args)...);
    return *grow_by(1) = *made;
  }
  void pop_back() noexcept { storage_.set_size(expected(size() - 1)); }
  void clear() noexcept { storage_.drop_elements(); }

  template <class... Args>
  iterator emplace(const_iterator position, Args&&... args) {
    return insert_copies(position, 1, Element(std::forward<Args>(args)...));
  }
  iterator insert(const_iterator position, const T& value) { return insert(position, size_type(1), value); }
  iterator insert(const_iterator position, size_type n, const T& value) {
    return insert_copies(position, n, Element(value));
  }
  template <class It, class = IfIterator<It> >
  iterator insert(const_iterator position, It first, It last) {
    return insert_range(position, first, last, typename std::iterator_traits<It>::iterator_category());
  }
  iterator insert(const_iterator position, std::initializer_list<T> values) {
    return insert(position, values.begin(), values.end());
  }
  iterator erase(const_iterator position) { return erase(position, position + 1); }
  iterator erase(const_iterator first, const_iterator last) {
    const difference_type at = first - cbegin(), n = last - first;
    iterator gap = begin() + at;
    std::copy(gap + n, end(), gap);
    storage_.set_size(size() - static_cast<size_type>(n));
    return gap;
  }

  /// Exchanges the elements; each object keeps its own binding, and one without takes the other's.
  void swap(Array& other) noexcept {
    storage_.swap_elements(other.storage_);
    storage_.share_memory_with(other.storage_);
  }
  /// Exchanges the elements. Copies none of them unless this array's are in a segment.
  void swap(std::vector<T>& other) {
    std::vector<T> mine = release_to_vector();
    take(other);
    other.swap(mine);
  }

  /// Later growth takes memory from `memory` (from the heap when that is exhausted). Existing elements stay
  /// in place.
  void bind(std::shared_ptr<MemorySource> memory) noexcept { storage_.bind(std::move(memory)); }
  /// The block that holds the elements; null while they are on the heap.
  const BufferPtr& buffer() const noexcept { return storage_.buffer(); }
  /// For the runtime: bind, place and share the memory behind the elements.
  detail::ArrayStorage<T>& storage() noexcept { return storage_; }
  const detail::ArrayStorage<T>& storage() const noexcept { return storage_; }

 private:
  void copy_from(const Array& other);
  void take(std::vector<T>& values);
  std::vector<T> release_to_vector();
  bool bound_buffer_has_room(size_type n) const noexcept;

  T* replace(size_type n);
  void remake_unfilled(size_type capacity);
  T* grow_by(size_type n);
  T* make_room(size_type n) __attribute__((noinline));
  size_type capacity_for(size_type n) const;
  iterator make_gap(const_iterator position, size_type n, detail::ArrayStorage<T>& before);
  template <class... Args>
  void resize_with(size_type n, Args&&... args);
  iterator insert_copies(const_iterator position, size_type n, const Element& element);

  template <class It>
  bool may_lie_here(It first) const;
  template <class It>
  void assign_range(It first, It last, std::input_iterator_tag);
  template <class It>
  void assign_range(It first, It last, std::forward_iterator_tag);
  template <class It>
  iterator insert_range(const_iterator position, It first, It last, std::input_iterator_tag);
  template <class It>
  iterator insert_range(const_iterator position, It first, It last, std::forward_iterator_tag);

  size_type checked(size_type n) const;
  TZC_ALWAYS_INLINE size_type in_range(size_type i) const;
  /// Ends the program where std::vector does: in code that is compiled with the C++ library's assertions (-D_GLIBCXX_ASSERTIONS).
  TZC_ALWAYS_INLINE size_type expected(size_type i) const noexcept;

  detail::ArrayStorage<T> storage_;
};

}  // namespace tzc

#include <tzc/detail/array_impl.h>
#include <tzc/detail/array_operators.h>
