// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <string>

namespace tzc {
namespace detail {

/// This process writes a trace (docs/traces.md). Set when the library is loaded, and not changed afterwards.
extern bool writes_trace;

/// A call of roscpp's publish, for the trace: a step for each subscriber on TCPROS.
class RoscppPublish {
 public:
  /// `stamp` of the message's header; null: it has none.
  RoscppPublish(const std::string& topic, const ros::Time* stamp);
  ~RoscppPublish();
  RoscppPublish(const RoscppPublish&) = delete;
  RoscppPublish& operator=(const RoscppPublish&) = delete;

 private:
  const std::string topic_;
  const ros::Time stamp_;
  const std::uint64_t begin_ns_;
};

template <class Allocator>
const ros::Time* stamp_of_header(const ::std_msgs::Header_<Allocator>& header) {
  return &header.stamp;
}
/// Null: the message has no std_msgs::Header. Not ros::message_traits::timeStamp, whose specialization for PCL's clouds
/// declares a static member that pcl_ros defines nowhere.
template <class M>
auto stamp_of(const M& message, int) -> decltype(stamp_of_header(message.header)) {
  return stamp_of_header(message.header);
}
template <class M>
const ros::Time* stamp_of(const M&, long) {
  return nullptr;
}

/// Calls `publish`, which publishes this message through that roscpp publisher.
template <class Publisher, class M, class Publish>
void publish_by_roscpp(const Publisher& publisher, const M& message, const Publish& publish) {
  if (!writes_trace) return publish();
  const RoscppPublish step(publisher.getTopic(), stamp_of(message, 0));
  publish();
}

}  // namespace detail
}  // namespace tzc
