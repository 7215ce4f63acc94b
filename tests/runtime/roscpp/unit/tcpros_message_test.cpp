// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/traces/tcpros_message.h"

#include <gtest/gtest.h>

#include <set>

namespace tzc {
namespace detail {
namespace {

TEST(TcprosMessage, has_the_same_name_at_both_ends_and_no_others) {
  const TcprosMessage message{"/image", "/camera", "/viewer", 12, 34};
  EXPECT_EQ(trace_id(message), trace_id({"/image", "/camera", "/viewer", 12, 34}));
  const std::set<std::uint64_t> others{
      trace_id(message),
      trace_id({"/imag", "e/camera", "/viewer", 12, 34}),
      trace_id({"/image", "/camera", "/rviz", 12, 34}),
      trace_id({"/image", "/camera", "/viewer", 12, 35}),
      trace_id({"/image", "/camera", "/viewer", 34, 12}),
  };
  EXPECT_EQ(others.size(), 5U);
}

TEST(TcprosMessage, without_a_stamp_has_no_name) {
  EXPECT_EQ(trace_id({"/image", "/camera", "/viewer", 0, 0}), 0U);
}

}  // namespace
}  // namespace detail
}  // namespace tzc
