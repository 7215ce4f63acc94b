// SPDX-License-Identifier: BSD-3-Clause
// What tzc::Array promises beyond being a vector: where its elements live, and what is copied when.
#include <tzc/array.h>

#include <iterator>
#include <sstream>

#include "test_memory.h"

namespace tzc {
namespace {

using Bytes = Array<std::uint8_t>;
using Vector = std::vector<std::uint8_t>;

static_assert(!std::is_convertible<Vector, Bytes>::value, "a silent copy is a defect");
static_assert(!std::is_convertible<Bytes, Vector>::value, "a silent copy is a defect");
static_assert(std::is_constructible<Vector, const Bytes&>::value, "explicitly it works");
static_assert(std::is_constructible<Bytes, const Vector&>::value, "explicitly it works");
static_assert(std::is_nothrow_default_constructible<Bytes>::value, "as std::vector");
static_assert(std::is_nothrow_move_constructible<Bytes>::value, "as std::vector");
static_assert(std::is_nothrow_move_assignable<Bytes>::value, "as std::vector");
static_assert(detail::HasVectorWords<Vector>::value, "this platform's vectors can lend and borrow");

class ArrayInMemory : public ::testing::Test {
 protected:
  /// An array of n elements 0, 1, 2, ... in shared memory.
  Bytes bound(std::size_t n) {
    Bytes array;
    array.bind(memory_);
    array.resize(n);
    for (std::size_t i = 0; i < n; ++i) array[i] = static_cast<std::uint8_t>(i);
    return array;
  }
  static void publish(const Bytes& array) { array.storage().share(); }
  static const std::uint8_t* address(const Bytes& array) { return array.data(); }

  std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>();
};

TEST_F(ArrayInMemory, vector_words_are_what_we_think_they_are) {
  EXPECT_TRUE(detail::vector_words_are_as_expected()) << "everything still works, but views are deep copies";
}

TEST_F(ArrayInMemory, grows_on_the_heap_until_bound) {
  Bytes array(10);
  EXPECT_FALSE(in_segment(address(array)));
  array.bind(memory_);
  EXPECT_FALSE(in_segment(address(array))) << "binding moves nothing";
  array.resize(1000);
  EXPECT_TRUE(in_segment(address(array)));
  EXPECT_EQ(array.buffer(), find_buffer(address(array), array.size()));
}

TEST_F(ArrayInMemory, falls_back_to_the_heap_when_exhausted) {
  Bytes array = bound(10);
  memory_->exhausted = true;
  array.resize(5000);
  EXPECT_FALSE(in_segment(address(array)));
  EXPECT_EQ(9, array[9]);
  memory_->exhausted = false;
  array.resize(50000);
  EXPECT_TRUE(in_segment(address(array)));
  EXPECT_EQ(9, array[9]);
}

TEST_F(ArrayInMemory, writes_after_publish_get_fresh_memory) {
  Bytes array = bound(100);
  publish(array);
  const BufferPtr published = array.buffer();
  array[3] = 200;
  EXPECT_NE(published, array.buffer());
  EXPECT_TRUE(in_segment(address(array)));
  EXPECT_EQ(3, published->data()[3]);
  EXPECT_EQ(4, array[4]);
}

TEST_F(ArrayInMemory, what_a_write_after_publish_copies_is_counted) {
  MemoryOptions options;
  options.size = 1 << 20;
  const std::shared_ptr<SegmentMemory> memory = SegmentMemory::create(options).value();
  Bytes array;
  array.bind(memory);
  array.resize(100);
  array.resize(300);
  EXPECT_EQ(0u, memory->copied_bytes()) << "nobody has them";
  publish(array);
  EXPECT_EQ(0, static_cast<const Bytes&>(array)[3]);
  EXPECT_EQ(0u, memory->copied_bytes());
  array[3] = 200;
  array[4] = 200;
  EXPECT_EQ(300u, memory->copied_bytes());
  publish(array);
  array.push_back(1);
  EXPECT_EQ(600u, memory->copied_bytes());
  publish(array);
  array.clear();
  array.push_back(1);
  EXPECT_EQ(600u, memory->copied_bytes()) << "no old element is kept";
}

TEST_F(ArrayInMemory, reading_after_publish_copies_nothing) {
  Bytes array = bound(100);
  publish(array);
  const auto* const before = address(array);
  const int allocations = memory_->allocations;
  const Bytes& read = array;
  EXPECT_EQ(9, read[9] + read.front());
  EXPECT_EQ(99, *(read.end() - 1));
  array.pop_back();
  array.resize(50);
  EXPECT_EQ(before, address(array));
  EXPECT_EQ(allocations, memory_->allocations);
}

TEST_F(ArrayInMemory, overwriting_after_publish_copies_nothing) {
  Bytes array = bound(100);
  publish(array);
  array.clear();
  EXPECT_FALSE(array.buffer()) << "the old elements are let go";
  EXPECT_EQ(100u, array.capacity());
  const int allocations = memory_->allocations;
  for (int i = 0; i < 100; ++i) array.push_back(7);
  EXPECT_EQ(allocations + 1, memory_->allocations) << "the capacity that clear() kept";

  publish(array);
  array.resize(80, uninitialized);
  EXPECT_EQ(allocations + 2, memory_->allocations);
}

TEST_F(ArrayInMemory, assignment_keeps_the_place_of_the_elements_where_there_is_room) {
  const Bytes published = bound(100);
  publish(published);
  Bytes array(200);
  std::uint8_t* const held = &array[10];
  array = published;
  EXPECT_EQ(held, &array[10]);
  EXPECT_EQ(10, *held);
  *held = 99;
  EXPECT_EQ(10, published[10]);
  EXPECT_EQ(100u, array.size());
}

TEST_F(ArrayInMemory, copies_share_only_what_is_published) {
  Bytes array = bound(100);
  const Bytes deep(array);
  EXPECT_FALSE(in_segment(address(deep)));
  publish(array);
  Bytes shared(array);
  EXPECT_EQ(address(array), address(shared));
  shared[0] = 55;
  EXPECT_EQ(0, address(array)[0]);
  EXPECT_EQ(0, deep[0]);
}

TEST_F(ArrayInMemory, moves_carry_the_binding) {
  Bytes array = bound(100);
  const auto* const before = address(array);
  Bytes moved(std::move(array));
  EXPECT_EQ(before, address(moved));
  moved.resize(1000);
  EXPECT_TRUE(in_segment(address(moved)));

  Bytes target;
  target.bind(memory_);
  target = Bytes(5);
  target.resize(1000);
  EXPECT_TRUE(in_segment(address(target))) << "assignment keeps the target's binding";
}

TEST_F(ArrayInMemory, an_array_without_memory_gets_it_from_one_it_is_swapped_with) {
  for (const bool bound_first : {true, false}) {
    Bytes one = bound(10), other(20);
    bound_first ? one.swap(other) : other.swap(one);
    one.clear(), other.clear();
    one.resize(100), other.resize(100);
    EXPECT_TRUE(in_segment(address(one)));
    EXPECT_TRUE(in_segment(address(other)));
  }
}

TEST_F(ArrayInMemory, swaps_with_vectors_without_copying) {
  Vector vector(1000, 3);
  const auto* const memory = vector.data();
  Bytes array(10);
  const auto* const old = address(array);
  array.swap(vector);
  EXPECT_EQ(memory, address(array));
  EXPECT_EQ(old, vector.data());
  swap(vector, array);
  EXPECT_EQ(memory, vector.data());
  array = std::move(vector);
  EXPECT_EQ(memory, address(array));
}

TEST_F(ArrayInMemory, takes_a_vector_into_its_own_buffer_when_that_has_room) {
  Bytes array = bound(100);
  const auto* const memory = address(array);
  array = Vector(60, 3);
  EXPECT_EQ(memory, address(array));
  EXPECT_EQ(Vector(60, 3), Vector(array));
}

TEST_F(ArrayInMemory, a_vector_that_it_copies_from_is_empty_as_if_moved) {
  Bytes array = bound(100);
  Vector values(60, 3);
  array = std::move(values);
  EXPECT_TRUE(values.empty());
}

TEST_F(ArrayInMemory, swaps_with_vectors_from_shared_memory) {
  Bytes array = bound(5);
  publish(array);
  Vector vector{9};
  array.swap(vector);
  EXPECT_EQ((Vector{0, 1, 2, 3, 4}), vector);
  EXPECT_EQ(Vector{9}, Vector(array));
}

TEST_F(ArrayInMemory, fresh_elements_are_zero_even_in_reused_memory) {
  for (int round = 0; round < 50; ++round) {
    Bytes array;
    array.bind(memory_);
    array.resize(100000);
    EXPECT_EQ(array.end(), std::find_if(array.begin(), array.end(), [](int byte) { return byte != 0; }));
    std::fill(array.begin(), array.end(), 0xff);
  }
}

/// An array that no one bound: its elements are on the heap when they are published.
class ArrayOnTheHeap : public ArrayInMemory {
 protected:
  ArrayOnTheHeap() : array_(100, 7) {}
  void send() {
    sent_ = memory_->allocate(array_.size());
    std::copy(read().begin(), read().end(), sent_->data());
    read().storage().note_sent(memory_, sent_, sent_->data());
    sent_->seal();
  }
  const Bytes& read() const { return array_; }

  Bytes array_;
  BufferPtr sent_;
};

TEST_F(ArrayOnTheHeap, publishing_leaves_the_elements_where_others_read_them) {
  const std::uint8_t* const elements = read().data();
  send();
  EXPECT_EQ(elements, read().data());
  EXPECT_EQ(sent_, read().storage().share().buffer) << "what was not written is not copied again";
  EXPECT_EQ(elements, read().data());
}

TEST_F(ArrayOnTheHeap, the_next_write_moves_them_to_shared_memory) {
  const std::uint8_t* const elements = read().data();
  send();
  array_[3] = 200;
  EXPECT_TRUE(in_segment(read().data()));
  EXPECT_NE(sent_, array_.buffer());
  EXPECT_EQ(7, sent_->data()[3]);
  EXPECT_EQ(7, elements[3]) << "what another thread got at stays readable";
  publish(array_);
  array_[4] = 200;
  EXPECT_EQ(7, elements[4]);
}

TEST_F(ArrayOnTheHeap, overwriting_copies_nothing) {
  send();
  const int allocations = memory_->allocations;
  array_.clear();
  array_.resize(100);
  EXPECT_EQ(allocations + 1, memory_->allocations);
  EXPECT_TRUE(in_segment(read().data()));
}

TEST_F(ArrayOnTheHeap, without_memory_they_are_written_in_place) {
  send();
  const std::uint8_t* const elements = read().data();
  memory_->exhausted = true;
  array_[3] = 200;
  EXPECT_EQ(elements, read().data());
  EXPECT_EQ(7, sent_->data()[3]);
  EXPECT_FALSE(read().storage().share().buffer) << "what was sent is not what is there now";
}

TEST_F(ArrayOnTheHeap, without_memory_there_is_the_room_that_was_reserved) {
  send();
  memory_->exhausted = true;
  array_.reserve(5000);
  const std::uint8_t* const elements = array_.data();
  array_.resize(5000, 8);
  EXPECT_EQ(elements, read().data());
  EXPECT_EQ(7, read()[99]);
}

/// Memory runs out between two publishes, so that elements are on the heap once more.
TEST_F(ArrayOnTheHeap, twice) {
  send();
  array_[0] = 1;
  publish(array_);
  memory_->exhausted = true;
  array_[0] = 2;
  EXPECT_FALSE(in_segment(read().data()));
  memory_->exhausted = false;
  send();
  array_[0] = 3;
  send();
  EXPECT_EQ(3, sent_->data()[0]);
  array_.clear();
  array_.resize(10);
  EXPECT_TRUE(in_segment(read().data()));
}

TEST_F(ArrayOnTheHeap, copies_share_what_was_sent) {
  send();
  const Bytes copy(array_);
  EXPECT_EQ(sent_, copy.buffer());
  Bytes moved(std::move(array_));
  EXPECT_EQ(sent_, static_cast<const Bytes&>(moved).storage().share().buffer);
  moved.resize(50);
  EXPECT_EQ(Bytes(50, 7), Bytes(moved));
}

TEST_F(ArrayOnTheHeap, is_given_to_a_vector_without_a_copy) {
  send();
  const std::uint8_t* const elements = read().data();
  Vector vector(3, 1);
  array_.swap(vector);
  EXPECT_EQ(elements, vector.data());
  EXPECT_FALSE(read().storage().share().buffer);
  vector[0] = 9;
  EXPECT_EQ(7, sent_->data()[0]);
}

TEST(Array, throws_where_vector_does) {
  Array<double> array(3);
  EXPECT_THROW(array.at(3), std::out_of_range);
  EXPECT_THROW(array.reserve(array.max_size() + 1), std::length_error);
  EXPECT_THROW(array.resize(std::size_t(-1)), std::length_error);
  EXPECT_THROW(array.insert(array.begin(), std::size_t(-1), 1.0), std::length_error);
  EXPECT_EQ(3u, array.size());
}

TEST(Array, says_what_vector_says) {
  const auto words = [](const auto& container) {
    try {
      return std::to_string(container.at(7));
    } catch (const std::out_of_range& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(words(std::vector<int>(3)), words(Array<int>(3)));
}

TEST(Array, takes_input_iterators) {
  std::istringstream first("1 2 3"), second("8 9"), third("4 5");
  using Input = std::istream_iterator<int>;
  Array<int> array(Input(first), Input{});
  array.insert(array.begin() + 1, Input(second), Input{});
  EXPECT_EQ((std::vector<int>{1, 8, 9, 2, 3}), std::vector<int>(array));
  array.assign(Input(third), Input{});
  EXPECT_EQ((std::vector<int>{4, 5}), std::vector<int>(array));
}

TEST(Array, compares) {
  const Array<int> a{1, 2}, b{1, 3}, c{1, 2, 0};
  EXPECT_TRUE(a < b && b > c && a <= a && c >= a && a != c && a == a);
  EXPECT_TRUE(a == (std::vector<int>{1, 2}) && (std::vector<int>{1, 3}) != a);
}

TEST(Array, braces_mean_what_they_mean_for_vectors) {
  Array<int> array{3, 1};
  EXPECT_EQ(2u, array.size());
  array.resize(4, {});
  EXPECT_EQ(0, array[3]);
  array = {};
  EXPECT_TRUE(array.empty());
  EXPECT_EQ((std::vector<int>{7, 7}), std::vector<int>(Array<int>(2, 7)));
}

}  // namespace
}  // namespace tzc
