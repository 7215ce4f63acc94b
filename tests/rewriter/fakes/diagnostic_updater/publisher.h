// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
namespace diagnostic_updater {
template <class M>
class DiagnosedPublisher {
 public:
  explicit DiagnosedPublisher(const ros::Publisher& publisher) : publisher_(publisher) {}
  virtual ~DiagnosedPublisher() = default;
  virtual void publish(const boost::shared_ptr<M>& message) { publisher_.publish(message); }
  virtual void publish(const M& message) { publisher_.publish(message); }
  ros::Publisher getPublisher() const { return publisher_; }

 private:
  ros::Publisher publisher_;
};
}  // namespace diagnostic_updater
