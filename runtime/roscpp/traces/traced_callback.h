// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscription_callback_helper.h>

#include <string>

namespace tzc {
namespace detail {

/// Stands for a callback in roscpp and writes each of its calls to the trace, whatever the message came through.
class TracedCallback final : public ros::SubscriptionCallbackHelper {
 public:
  TracedCallback(ros::SubscriptionCallbackHelperPtr callback, const std::string& resolved_topic);

  ros::VoidConstPtr deserialize(const ros::SubscriptionCallbackHelperDeserializeParams& params) override;
  void call(ros::SubscriptionCallbackHelperCallParams& params) override;
  const std::type_info& getTypeInfo() override { return callback_->getTypeInfo(); }
  bool isConst() override { return callback_->isConst(); }
  bool hasHeader() override { return callback_->hasHeader(); }

  const ros::SubscriptionCallbackHelper& callback() const { return *callback_; }

 private:
  std::uint64_t came_over_tcpros(const ros::SubscriptionCallbackHelperDeserializeParams& params);

  const ros::SubscriptionCallbackHelperPtr callback_;
  const char* const topic_;
};

/// The same callback, in the trace when this process writes one.
ros::SubscriptionCallbackHelperPtr traced(const ros::SubscriptionCallbackHelperPtr& callback,
                                          const std::string& resolved_topic);
/// The user's callback, whether it is traced or not.
const ros::SubscriptionCallbackHelper& untraced(const ros::SubscriptionCallbackHelper& callback);

}  // namespace detail
}  // namespace tzc
