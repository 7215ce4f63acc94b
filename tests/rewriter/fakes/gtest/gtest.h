// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace testing {

/// Owns a text, as GoogleTest's does: by its type, a result might refer to what was compared.
class AssertionResult {
 public:
  AssertionResult(const AssertionResult& other);
  explicit operator bool() const { return is_right_; }
  const char* failure_message() const { return message_ ? message_->c_str() : ""; }

 private:
  bool is_right_;
  std::unique_ptr<std::string> message_;
};

namespace internal {

template <class T1, class T2>
AssertionResult CmpHelperLT(const char* first, const char* second, const T1& value1, const T2& value2);

class EqHelper {
 public:
  template <class T1, class T2>
  static AssertionResult Compare(const char* first, const char* second, const T1& value1, const T2& value2);
};

void report(const char* message);

}  // namespace internal
}  // namespace testing

#define TZC_FAKE_EXPECT(comparison)                           \
  if (const ::testing::AssertionResult result = (comparison)) \
    ;                                                         \
  else                                                        \
    ::testing::internal::report(result.failure_message())
#define EXPECT_LT(a, b) TZC_FAKE_EXPECT(::testing::internal::CmpHelperLT(#a, #b, a, b))
#define EXPECT_EQ(a, b) TZC_FAKE_EXPECT(::testing::internal::EqHelper::Compare(#a, #b, a, b))
