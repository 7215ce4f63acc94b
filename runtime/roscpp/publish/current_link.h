// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/single_subscriber_publisher.h>
#include <ros/subscriber_link.h>

#include <string>

namespace tzc {
namespace detail {

/// The link to a subscriber, whether it is on TCPROS or moved to shared memory meanwhile. roscpp hands a connect callback the
/// TCPROS link, however late the callback runs. What went out on a parked one would be overtaken by the next message.
/// Thread-safe.
class CurrentLink : public ros::SubscriberLink {
 public:
  explicit CurrentLink(const ros::SubscriberLinkPtr& tcpros);

  /// \name ros::SubscriberLink
  /// @{
  void enqueueMessage(const ros::SerializedMessage& message, bool ser, bool nocopy) override;
  void drop() override { tcpros_->drop(); }
  std::string getTransportType() override { return tcpros_->getTransportType(); }
  std::string getTransportInfo() override { return tcpros_->getTransportInfo(); }
  /// @}

 private:
  const ros::SubscriberLinkPtr tcpros_;
};

}  // namespace detail
}  // namespace tzc
