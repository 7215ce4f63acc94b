// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/fault_ready_callback.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>

#include <boost/make_shared.hpp>

#include "roscpp/spin/heard_queue.h"

namespace tzc {
namespace detail {
namespace {

/// Tries again, and is ready, every other time.
class Reluctant final : public ros::CallbackInterface {
 public:
  CallResult call() override { return ++calls_ % 2 != 0 ? TryAgain : Success; }
  bool ready() override { return ++looks_ % 2 == 0; }
  int calls() const { return calls_; }

 private:
  int calls_ = 0, looks_ = 0;
};

TEST(FaultReadyCallback, answers_as_the_callback_does) {
  const auto callback = boost::make_shared<Reluctant>();
  const ros::CallbackInterfacePtr ready = fault_ready(callback);
  EXPECT_FALSE(ready->ready());
  EXPECT_TRUE(ready->ready());
  EXPECT_EQ(ready->call(), ros::CallbackInterface::TryAgain);
  EXPECT_EQ(ready->call(), ros::CallbackInterface::Success);
}

TEST(FaultReadyCallback, is_made_once) {
  const ros::CallbackInterfacePtr ready = fault_ready(boost::make_shared<Reluctant>());
  EXPECT_EQ(fault_ready(ready), ready);
}

TEST(FaultReadyCallback, waits_in_the_global_queue_as_the_callback_would) {
  const auto callback = boost::make_shared<Reluctant>();
  HeardQueue queue;
  queue.addCallback(callback, 1);
  EXPECT_EQ(queue.callOne(), ros::CallbackQueue::TryAgain) << "it is not ready";
  EXPECT_EQ(queue.callOne(), ros::CallbackQueue::TryAgain) << "it says so itself";
  EXPECT_EQ(callback->calls(), 1);
  queue.removeByID(1);
  EXPECT_TRUE(queue.isEmpty());
}

}  // namespace
}  // namespace detail
}  // namespace tzc
