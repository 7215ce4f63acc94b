// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/time.h>

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

/// Calls `publish`, which publishes this message through that roscpp publisher.
template <class Publisher, class M, class Publish>
void publish_by_roscpp(const Publisher& publisher, const M& message, const Publish& publish) {
  if (!writes_trace) return publish();
  const RoscppPublish step(publisher.getTopic(), ros::message_traits::timeStamp(message));
  publish();
}

}  // namespace detail
}  // namespace tzc
