// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/channel.h>

#include <cstddef>

namespace tzc {
namespace detail {

/// A record with what the counters need. Empty when the message was dropped.
struct OutgoingMessage {
  channel::RecordPtr record;
  bool shared = false;    ///< true: a control part; false: a whole message
  std::size_t bytes = 0;  ///< of its control part, or of the whole message
};

}  // namespace detail
}  // namespace tzc
