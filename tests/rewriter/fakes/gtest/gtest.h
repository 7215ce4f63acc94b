// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace testing {

class AssertionResult {
 public:
  explicit AssertionResult(bool is_right) : is_right_(is_right) {}
  explicit operator bool() const { return is_right_; }

 private:
  bool is_right_;
};

namespace internal {

template <class T1, class T2>
AssertionResult CmpHelperLT(const char* first, const char* second, const T1& value1, const T2& value2);

class EqHelper {
 public:
  template <class T1, class T2>
  static AssertionResult Compare(const char* first, const char* second, const T1& value1, const T2& value2);
};

}  // namespace internal
}  // namespace testing

#define EXPECT_LT(a, b) (void)bool(::testing::internal::CmpHelperLT(#a, #b, a, b))
#define EXPECT_EQ(a, b) (void)bool(::testing::internal::EqHelper::Compare(#a, #b, a, b))
