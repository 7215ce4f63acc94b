// SPDX-License-Identifier: BSD-3-Clause
// What may stand behind `array =`: all that may behind `vector =`.
#include <gtest/gtest.h>
#include <tzc/array.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "test_memory.h"

namespace tzc {
namespace {

/// As cv::Mat_<T>, which becomes a vector of what it is asked for.
struct Convertible {
  template <class T>
  operator std::vector<T>() const {
    return std::vector<T>(3, T(7));
  }
};

TEST(ArrayAssignment, takes_all_that_a_vector_takes) {
  const std::uint8_t bytes[] = {1, 2, 3};
  Array<std::uint8_t> array;
  std::vector<std::uint8_t> vector;
  array = {bytes, bytes + 2};
  vector = {bytes, bytes + 2};
  EXPECT_EQ(array, vector);
  array = {4, 5};
  vector = {4, 5};
  EXPECT_EQ(array, vector);
  array = {vector};
  EXPECT_EQ(array, vector);
  array = {std::vector<std::uint8_t>(2, 3)};
  EXPECT_EQ(array, std::vector<std::uint8_t>(2, 3));
  array = Convertible();
  vector = Convertible();
  EXPECT_EQ(array, vector);
  array = {};
  EXPECT_TRUE(array.empty());
  array = vector;
  EXPECT_EQ(array, vector);
  const auto* const elements = vector.data();
  array = std::move(vector);
  EXPECT_EQ(elements, static_cast<const Array<std::uint8_t>&>(array).data()) << "its memory was taken over";
}

// Or best_effort would take the block from subscribers, although the array itself still had it.
TEST(ArrayAssignment, lets_published_elements_go_before_it_takes_memory) {
  constexpr std::size_t size = 1 << 20;
  const auto memory_of_one_block = std::make_shared<test::TestMemory>(size);
  const std::vector<std::uint8_t> values(size, 7);
  Array<std::uint8_t> array;
  array.bind(memory_of_one_block);
  const std::function<void()> ways[] = {
      [&] { array.assign(values.begin(), values.end()); },
      [&] { array.resize(size, uninitialized); },
      [&] { array.assign(size, 3); },
      [&] { array = values; },
  };
  for (const auto& overwrite : ways) {
    overwrite();
    EXPECT_TRUE(array.buffer());
    static_cast<const Array<std::uint8_t>&>(array).storage().share();
  }
}

}  // namespace
}  // namespace tzc
