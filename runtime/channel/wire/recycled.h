// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace tzc {
namespace channel {

/// Values that wait for their next use: a few places, each with at most one. Lock-free, never waits, allocates nothing;
/// any thread.
template <class T, std::size_t places>
class Spares {
 public:
  /// A spare value into `value`. False: there is none.
  bool take(T& value) {
    for (Place& place : places_) {
      if (!place.change(State::full, State::busy)) continue;
      value = std::move(place.value);
      place.state.store(State::empty, std::memory_order_release);
      return true;
    }
    return false;
  }

  /// Keeps the value. False: every place is occupied, and `value` is unchanged.
  bool put(T& value) {
    for (Place& place : places_) {
      if (!place.change(State::empty, State::busy)) continue;
      place.value = std::move(value);
      place.state.store(State::full, std::memory_order_release);
      return true;
    }
    return false;
  }

 private:
  enum class State : unsigned char { empty, busy, full };
  struct Place {
    bool change(State from, State to) {
      return state.load(std::memory_order_relaxed) == from &&
             state.compare_exchange_strong(from, to, std::memory_order_acquire, std::memory_order_relaxed);
    }
    std::atomic<State> state{State::empty};
    T value{};
  };

  Place places_[places];
};

/// How many messages can come to an end at once and still leave their memory to the next ones.
constexpr std::size_t most_spares = 16;

/// The allocator of an object that each message has one of. What is given back serves the next message, so the steady
/// state asks malloc for nothing: on a real-time thread malloc may take its lock from a thread of a lower priority, or
/// fault a page in. For single objects; any thread.
template <class T>
struct RecyclingAllocator {
  using value_type = T;

  RecyclingAllocator() = default;
  template <class Other>
  RecyclingAllocator(const RecyclingAllocator<Other>&) {}  // NOLINT: implicit, as the standard wants it

  T* allocate(std::size_t count) {
    void* memory = nullptr;
    if (count == 1 && spares().take(memory)) return static_cast<T*>(memory);
    return std::allocator<T>().allocate(count);
  }
  void deallocate(T* object, std::size_t count) noexcept {
    void* memory = object;
    if (count != 1 || !spares().put(memory)) std::allocator<T>().deallocate(object, count);
  }

  friend bool operator==(RecyclingAllocator, RecyclingAllocator) { return true; }
  friend bool operator!=(RecyclingAllocator, RecyclingAllocator) { return false; }

 private:
  // Never destroyed: a message may end after the program's statics.
  static Spares<void*, most_spares>& spares() {
    static auto* const all = new Spares<void*, most_spares>;
    return *all;
  }
};

/// std::make_shared, with memory of an earlier object of this kind where there is some.
template <class T, class... Arguments>
std::shared_ptr<T> make_recycled(Arguments&&... arguments) {
  return std::allocate_shared<T>(RecyclingAllocator<std::remove_const_t<T>>(),
                                 std::forward<Arguments>(arguments)...);
}

}  // namespace channel
}  // namespace tzc
