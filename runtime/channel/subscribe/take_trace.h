// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "trace/trace.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// The subscriber's steps of each message in the trace: it wakes up, takes the message, and calls back. Only called while
/// trace::active; by one thread at a time.
class TakeTrace {
 public:
  /// `connection`: SharedPage::trace_number().
  TakeTrace(const SubscriberOptions& options, std::uint64_t connection);

  /// This thread has got the packet that completes a message.
  void woken();
  /// It looks at the record.
  void taking();
  /// It has taken the record. Returns what traces call the message.
  std::uint64_t taken(std::uint32_t sequence, std::size_t bytes) const;
  /// Calls on_message.
  void call_back(const SubscriberOptions& options, const MessagePtr& message) const;

 private:
  TakeTrace(const trace::ChannelName& name, std::uint64_t connection, bool calls_back);

  const char* const topic_;
  const std::uint64_t connection_;
  const bool calls_back_, passes_on_;
  std::uint64_t woken_ns_ = 0, taking_ns_ = 0;
};

}  // namespace channel
}  // namespace tzc
