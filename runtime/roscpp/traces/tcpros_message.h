// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace tzc {
namespace detail {

/// A message on a TCPROS connection, as both ends know it.
struct TcprosMessage {
  std::string topic, publisher, subscriber;
  std::uint32_t stamp_s = 0, stamp_ns = 0;  ///< of its header
};

/// What both ends call it in a trace. 0: its stamp is 0 (no header, or one that nobody has stamped), so nothing tells it
/// from others. Pure.
std::uint64_t trace_id(const TcprosMessage& message);

}  // namespace detail
}  // namespace tzc
