// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/guest_call.h"

#include <utility>

#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

struct LeftMessage {
  DirectCall call;
  boost::shared_ptr<void> decoded;
};
thread_local LeftMessage left;

void call_what_was_left() {
  sync_point("guest: calls");
  LeftMessage mine = std::exchange(left, LeftMessage());  // its callback may spin, and be left another one
  if (!mine.call) return;                                 // there was no memory for the message
  mine.call.call([&mine](bool) { return std::move(mine.decoded); }, DirectCall::Thrown::leaves);
}

}  // namespace

// Callbacks that several threads may call at once have no turn: a thread that unsubscribes would have to wait for them in roscpp's queue.
bool leave_to_guest(HeardQueue& queue, ros::Subscription& subscription, const DirectMessage& message,
                    const Decode& decode) {
  DirectCall call = DirectCall::prepare(subscription, message, queue, DirectCall::Turn::at_once);
  if (!call || !queue.leave_call(&call_what_was_left)) return false;
  sync_point("guest: decodes");
  const bool writes = call.writes();
  left = LeftMessage{std::move(call), decode(writes)};
  return true;
}

}  // namespace detail
}  // namespace tzc
