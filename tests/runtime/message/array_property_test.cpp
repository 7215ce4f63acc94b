// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of operations on tzc::Array and on std::vector, the oracle: after each the two are equal,
// and what was published keeps the bytes that it was published with.
#include <tzc/array.h>

#include <functional>
#include <list>
#include <random>
#include <sstream>

#include "test_memory.h"

namespace tzc {
namespace {

struct Padded {
  std::uint8_t tag;
  double value;
  Padded(int n = 0) : tag(static_cast<std::uint8_t>(n)), value(n) {}
  friend bool operator==(const Padded& a, const Padded& b) { return a.tag == b.tag && a.value == b.value; }
};

/// Publishes, as encode does it. Without a buffer: there is no memory, or no element.
template <class T>
detail::ArrayBlock<T> send(const Array<T>& array, const std::shared_ptr<test::TestMemory>& memory) {
  auto shared = array.storage().share();
  if (!shared.buffer && !array.empty()) {
    shared.buffer = memory->allocate(array.size() * sizeof(T));
    if (!shared.buffer) return shared;
    std::memcpy(shared.buffer->data(), shared.begin, array.size() * sizeof(T));
    shared.begin = reinterpret_cast<T*>(shared.buffer->data());
    array.storage().note_sent(memory, shared.buffer, shared.buffer->data());
  }
  if (shared.buffer) shared.buffer->seal();
  return shared;
}

/// An array and a vector that the same things happen to.
template <class T>
class Pair {
 public:
  Pair(std::shared_ptr<test::TestMemory> memory, unsigned seed) : memory_(std::move(memory)), random_(seed) {}

  void run(int steps) {
    for (int step = 0; step < steps && !::testing::Test::HasFatalFailure(); ++step) {
      const std::size_t operation = number(operations.size());
      SCOPED_TRACE("step " + std::to_string(step) + ", operation " + std::to_string(operation));
      operations[operation](*this);
      check();
    }
  }

 private:
  using Operation = std::function<void(Pair&)>;

  /// What a subscriber of an earlier publish sees, and must go on seeing.
  struct Published {
    BufferPtr buffer;
    const T* data;
    std::vector<T> expected;
  };

  std::size_t number(std::size_t bound) { return random_() % bound; }
  T value() { return T(static_cast<int>(number(100))); }
  std::size_t position() { return number(vector_.size() + 1); }
  std::vector<T> values() {
    std::vector<T> some(number(40));
    for (T& one : some) one = value();
    return some;
  }

  void check() {
    const Array<T>& array = array_;
    ASSERT_EQ(vector_.size(), array.size());
    ASSERT_GE(array.capacity(), array.size());
    ASSERT_TRUE(array == vector_);
    for (const Published& old : published_) {
      ASSERT_TRUE(std::equal(old.expected.begin(), old.expected.end(), old.data))
          << "a write reached subscribers";
    }
  }

  void publish() {
    const Array<T>& array = array_;
    const T* const elements = array.data();
    const auto shared = send(array, memory_);
    ASSERT_EQ(elements, array.data()) << "other threads may read them";
    if (!shared.buffer) return;
    published_.push_back(Published{shared.buffer, shared.begin, vector_});
    if (published_.size() > 8) published_.pop_front();
  }

  void same_offset(std::size_t array_offset, std::size_t vector_offset) {
    ASSERT_EQ(vector_offset, array_offset);
  }

  static const std::vector<Operation> operations;

  std::shared_ptr<test::TestMemory> memory_;
  std::mt19937 random_;
  Array<T> array_;
  std::vector<T> vector_;
  Array<T> other_array_;
  std::vector<T> other_vector_;
  std::list<Published> published_;
};

template <class T>
const std::vector<typename Pair<T>::Operation> Pair<T>::operations = {
    [](Pair& p) { p.publish(); },
    [](Pair& p) { p.publish(); },
    [](Pair& p) { p.array_.bind(p.memory_); },
    [](Pair& p) { p.array_.bind(nullptr); },
    [](Pair& p) { p.memory_->exhausted = p.number(4) == 0; },
    [](Pair& p) {
      const T v = p.value();
      p.array_.push_back(v), p.vector_.push_back(v);
    },
    [](Pair& p) {
      if (p.vector_.empty()) return;
      p.array_.push_back(p.array_[0]), p.vector_.push_back(p.vector_[0]);
    },
    [](Pair& p) {
      const int n = static_cast<int>(p.number(9));
      p.array_.emplace_back(n) = T(n + 1);
      p.vector_.emplace_back(n), p.vector_.back() = T(n + 1);
    },
    [](Pair& p) {
      if (!p.vector_.empty()) p.array_.pop_back(), p.vector_.pop_back();
    },
    [](Pair& p) { p.array_.clear(), p.vector_.clear(); },
    [](Pair& p) {
      const std::size_t n = p.number(300);
      p.array_.resize(n), p.vector_.resize(n);
    },
    [](Pair& p) {
      const std::size_t n = p.number(100);
      const T v = p.value();
      p.array_.resize(n, v), p.vector_.resize(n, v);
    },
    [](Pair& p) {
      const std::size_t n = p.number(100);
      p.array_.resize(n, uninitialized), p.vector_.resize(n);
      for (std::size_t i = 0; i < n; ++i) p.array_[i] = p.vector_[i] = p.value();
    },
    [](Pair& p) {
      const std::size_t n = p.number(400);
      p.array_.reserve(n), p.vector_.reserve(n);
      ASSERT_GE(p.array_.capacity(), n);
    },
    [](Pair& p) { p.array_.shrink_to_fit(), p.vector_.shrink_to_fit(); },
    [](Pair& p) {
      const std::size_t n = p.number(100);
      const T v = p.value();
      p.array_.assign(n, v), p.vector_.assign(n, v);
    },
    [](Pair& p) {
      const auto some = p.values();
      p.array_.assign(some.begin(), some.end()), p.vector_.assign(some.begin(), some.end());
    },
    [](Pair& p) { p.array_ = {T(1), T(2), T(3)}, p.vector_ = {T(1), T(2), T(3)}; },
    [](Pair& p) {
      const auto some = p.values();
      p.array_ = some, p.vector_ = some;
    },
    [](Pair& p) {
      auto some = p.values();
      p.vector_ = some, p.array_ = std::move(some);
    },
    [](Pair& p) {
      const std::size_t at = p.position();
      const T v = p.value();
      const auto i = p.array_.insert(p.array_.cbegin() + at, v);
      const auto j = p.vector_.insert(p.vector_.cbegin() + at, v);
      p.same_offset(i - p.array_.begin(), j - p.vector_.begin());
    },
    [](Pair& p) {
      const std::size_t at = p.position(), n = p.number(20);
      const T v = p.value();
      const auto i = p.array_.insert(p.array_.begin() + at, n, v);
      const auto j = p.vector_.insert(p.vector_.begin() + at, n, v);
      p.same_offset(i - p.array_.begin(), j - p.vector_.begin());
    },
    [](Pair& p) {
      const std::size_t at = p.position();
      const auto some = p.values();
      const auto i = p.array_.insert(p.array_.cbegin() + at, some.begin(), some.end());
      const auto j = p.vector_.insert(p.vector_.cbegin() + at, some.begin(), some.end());
      p.same_offset(i - p.array_.begin(), j - p.vector_.begin());
    },
    [](Pair& p) {
      const std::size_t at = p.position();
      p.array_.insert(p.array_.cbegin() + at, {T(7), T(8)}),
          p.vector_.insert(p.vector_.cbegin() + at, {T(7), T(8)});
    },
    [](Pair& p) {
      const std::size_t at = p.position();
      p.array_.emplace(p.array_.cbegin() + at, 5), p.vector_.emplace(p.vector_.cbegin() + at, 5);
    },
    [](Pair& p) {
      if (p.vector_.empty()) return;
      const std::size_t at = p.number(p.vector_.size());
      const auto i = p.array_.erase(p.array_.cbegin() + at);
      const auto j = p.vector_.erase(p.vector_.cbegin() + at);
      p.same_offset(i - p.array_.begin(), j - p.vector_.begin());
    },
    [](Pair& p) {
      const std::size_t to = p.position(), from = p.number(to + 1);
      const auto i = p.array_.erase(p.array_.cbegin() + from, p.array_.cbegin() + to);
      const auto j = p.vector_.erase(p.vector_.cbegin() + from, p.vector_.cbegin() + to);
      p.same_offset(i - p.array_.begin(), j - p.vector_.begin());
    },
    [](Pair& p) {
      for (T& element : p.array_) element = T(3);
      for (T& element : p.vector_) element = T(3);
    },
    [](Pair& p) {
      std::reverse(p.array_.begin(), p.array_.end()), std::reverse(p.vector_.begin(), p.vector_.end());
    },
    [](Pair& p) {
      if (p.vector_.empty()) return;
      const std::size_t at = p.number(p.vector_.size());
      p.array_.at(at) = p.vector_.at(at) = p.value();
      p.array_.front() = p.vector_.front() = p.value();
      p.array_.back() = p.vector_.back() = p.value();
      *p.array_.rbegin() = *p.vector_.rbegin() = p.value();
      p.array_.data()[at] = p.vector_.data()[at] = p.value();
    },
    [](Pair& p) { p.array_.swap(p.other_array_), p.vector_.swap(p.other_vector_); },
    [](Pair& p) { p.array_ = p.other_array_, p.vector_ = p.other_vector_; },
    [](Pair& p) { p.other_array_ = p.array_, p.other_vector_ = p.vector_; },
    [](Pair& p) {
      p.array_ = std::move(p.other_array_), p.vector_ = std::move(p.other_vector_);
      p.other_array_.clear(), p.other_vector_.clear();
    },
    [](Pair& p) {
      Array<T> copy(p.array_);
      for (T& element : copy) element = T(9);
    },
    [](Pair& p) { p.array_ = Array<T>(p.array_), p.array_ = Array<T>(std::move(p.array_)); },
    [](Pair& p) {
      auto some = p.values(), same = some;
      p.array_.swap(some), p.vector_.swap(same);
      ASSERT_EQ(same, some);
    },
    [](Pair& p) {
      const std::vector<T> copy(p.array_);
      ASSERT_EQ(p.vector_, copy);
    },
};

enum class Place { heap, segment, published, published_from_the_heap };

/// An array of 40 elements without room for more.
template <class T>
Array<T> made(Place place, const std::shared_ptr<test::TestMemory>& memory) {
  Array<T> array;
  if (place == Place::segment || place == Place::published) array.bind(memory);
  array.reserve(40);
  for (int i = 0; i < 40; ++i) array.push_back(T(i));
  if (place == Place::published || place == Place::published_from_the_heap) send(array, memory);
  return array;
}

template <class T>
class ArrayProperty : public ::testing::Test {
 protected:
  template <class Check>
  void in_each_place(Check check) {
    for (const Place place :
         {Place::heap, Place::segment, Place::published, Place::published_from_the_heap}) {
      SCOPED_TRACE("place " + std::to_string(static_cast<int>(place)));
      check([&] { return made<T>(place, memory_); });
    }
  }

  const std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>(4 << 20);
};
using Elements = ::testing::Types<std::uint8_t, float, std::int64_t, Padded>;
TYPED_TEST_SUITE(ArrayProperty, Elements);

TYPED_TEST(ArrayProperty, behaves_as_a_vector) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Pair<TypeParam>(std::make_shared<test::TestMemory>(4 << 20), seed).run(200);
    if (this->HasFatalFailure()) return;
  }
}

// For a vector that has to move, what is inserted is read before the old elements go.
TYPED_TEST(ArrayProperty, inserts_elements_of_its_own) {
  this->in_each_place([](const auto& make) {
    for (const int at : {0, 17, 40}) {
      for (const int from : {0, 10, 39}) {
        Array<TypeParam> array = make();
        const Array<TypeParam>& read = array;
        std::vector<TypeParam> expected(read.begin(), read.end());
        expected.insert(expected.begin() + at, read.begin() + from, read.end());
        const auto gap = array.insert(read.cbegin() + at, read.begin() + from, read.end());
        EXPECT_EQ(at, gap - array.begin());
        EXPECT_TRUE(array == expected) << "from " << from << " at " << at;
      }
    }
  });
}

TYPED_TEST(ArrayProperty, inserts_elements_that_moved_when_it_was_asked_for_a_place) {
  this->in_each_place([](const auto& make) {
    Array<TypeParam> array = make();
    const Array<TypeParam>& read = array;
    std::vector<TypeParam> expected(read.begin(), read.end());
    expected.insert(expected.end(), read.begin(), read.end());
    const auto first = read.begin(), last = read.end();
    array.insert(array.end(), first, last);
    EXPECT_TRUE(array == expected);
  });
}

TYPED_TEST(ArrayProperty, assigns_elements_of_its_own) {
  this->in_each_place([](const auto& make) {
    for (const int from : {0, 1, 39, 40}) {
      Array<TypeParam> array = make();
      const Array<TypeParam>& read = array;
      const std::vector<TypeParam> expected(read.begin() + from, read.end());
      array.assign(read.begin() + from, read.end());
      EXPECT_TRUE(array == expected) << "from " << from;
    }
  });
}

TYPED_TEST(ArrayProperty, assigns_what_iterators_make_of_its_elements) {
  this->in_each_place([](const auto& make) {
    Array<TypeParam> array = make();
    const Array<TypeParam>& read = array;
    const std::vector<TypeParam> expected(read.rbegin(), read.rend());
    if (read.storage().is_writable()) return;  // in place, as a vector does it
    array.assign(std::make_move_iterator(read.rbegin()), std::make_move_iterator(read.rend()));
    EXPECT_TRUE(array == expected);
  });
}

}  // namespace
}  // namespace tzc
