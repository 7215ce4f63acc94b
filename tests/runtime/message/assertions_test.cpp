// SPDX-License-Identifier: BSD-3-Clause
// Compiled with the C++ library's assertions: an array ends the program where a vector does, so that a port keeps that net.
#include <gtest/gtest.h>
#include <tzc/array.h>

#include <cstdint>
#include <vector>

#ifndef _GLIBCXX_ASSERTIONS
#error "this file is to be compiled with -D_GLIBCXX_ASSERTIONS"
#endif

namespace tzc {
namespace {

template <class Container>
class Assertions : public ::testing::Test {};
using Containers = ::testing::Types<std::vector<std::uint8_t>, Array<std::uint8_t>>;
TYPED_TEST_SUITE(Assertions, Containers);

TYPED_TEST(Assertions, end_a_program_that_leaves_the_elements) {
  TypeParam three(3), none;
  const TypeParam& read = three;
  const TypeParam& read_none = none;
  std::size_t three_elements = 3;
  EXPECT_DEATH(three[three_elements] = 1, "Assertion");
  EXPECT_DEATH(static_cast<void>(read[three_elements] == 1), "Assertion");
  EXPECT_DEATH(none.front() = 1, "Assertion");
  EXPECT_DEATH(static_cast<void>(read_none.front() == 1), "Assertion");
  EXPECT_DEATH(none.back() = 1, "Assertion");
  EXPECT_DEATH(static_cast<void>(read_none.back() == 1), "Assertion");
  EXPECT_DEATH(none.pop_back(), "Assertion");
}

TYPED_TEST(Assertions, let_one_pass_that_stays_inside) {
  TypeParam three(3);
  three[2] = 7;
  EXPECT_EQ(7, three.back());
  three.pop_back();
  three.pop_back();
  three.front() = 5;
  EXPECT_EQ(5, three.back());
  three.pop_back();
  EXPECT_TRUE(three.empty());
}

}  // namespace
}  // namespace tzc
