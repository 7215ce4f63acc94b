// SPDX-License-Identifier: BSD-3-Clause
// What may stand behind `array =`: all that may behind `vector =`.
#include <gtest/gtest.h>
#include <tzc/array.h>

#include <utility>

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

}  // namespace
}  // namespace tzc
