// SPDX-License-Identifier: BSD-3-Clause
// Views: how long they hold what they borrow, in this process and in its children.
#include <sys/wait.h>
#include <tzc/message.h>
#include <tzc/sensor_msgs/Image.h>
#include <unistd.h>

#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

namespace stock = ::sensor_msgs;
using sensor_msgs::Image;

class View : public ::testing::Test {
 protected:
  Image image(std::size_t bytes) {
    Image message;
    message.data.resize(bytes);
    for (std::size_t i = 0; i < bytes; ++i) message.data[i] = static_cast<std::uint8_t>(i);
    return message;
  }
  Encoded encoded(const Image& message) {
    Encoded result;
    EXPECT_TRUE(encode(message, memory_, result));
    return result;
  }

  std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>();
};

TEST_F(View, views_outlive_message_and_encoded) {
  boost::shared_ptr<const stock::Image> view;
  {
    Image message = image(1000);
    Encoded result = encoded(message);
    view = stock_view(message, result);
  }
  EXPECT_TRUE(in_segment(view->data.data()));
  EXPECT_EQ(to_stock(image(1000)), *view);
}

TEST_F(View, the_hold_ends_with_the_last_view_pointer) {
  const Encoded result = encoded(image(100));
  const auto hold = std::make_shared<int>();
  auto view =
      make_view<stock::Image>(result.control.data(), result.control.size(), test::blocks_of(result), hold);
  EXPECT_EQ(2, hold.use_count());
  const boost::shared_ptr<const stock::Image> second = view;
  view.reset();
  EXPECT_EQ(2, hold.use_count());
  EXPECT_EQ(100u, second->data.size());
}

TEST_F(View, a_view_that_borrows_nothing_holds_nothing) {
  const Encoded result = encoded(Image());
  const auto hold = std::make_shared<int>();
  const auto view = make_view<stock::Image>(result.control.data(), result.control.size(), {}, hold);
  EXPECT_TRUE(view);
  EXPECT_EQ(1, hold.use_count());
}

TEST_F(View, the_hold_ends_when_the_view_is_refused) {
  const Encoded result = encoded(image(100));
  const auto hold = std::make_shared<int>();
  EXPECT_FALSE(make_view<stock::Image>(result.control.data(), 3, test::blocks_of(result), hold));
  EXPECT_EQ(1, hold.use_count());
}

TEST_F(View, a_view_that_dies_in_a_forked_child_lets_nothing_go) {
  const Encoded result = encoded(image(100));
  int released = 0;
  std::shared_ptr<const void> hold(&released, [](const int* p) { ++*const_cast<int*>(p); });
  auto view = make_view<stock::Image>(result.control.data(), result.control.size(), test::blocks_of(result),
                                      std::move(hold));
  const pid_t child = fork();
  if (child == 0) {
    const bool readable = view->data[7] == 7;
    view.reset();
    _exit(readable && released == 0 ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(child, waitpid(child, &status, 0));
  EXPECT_EQ(0, status);
  view.reset();
  EXPECT_EQ(1, released);
}

}  // namespace
}  // namespace message
}  // namespace tzc
