// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tzc {
namespace detail {

/// What the socket buffers of a TCPROS connection on one machine hold before they have grown, in bytes: 4.1 to 4.2 MB measured, with
/// messages of 60 bytes to 4 MB. Besides its queue, which roscpp cuts to its size, a TCPROS link has a message that is being
/// written and these: so many more survive while the subscriber does not read.
constexpr std::size_t kSocketBuffers = std::size_t{4} << 20;

/// A channel's room for as much as they may grow to, in bytes: what this machine's net.ipv4.tcp_rmem and tcp_wmem allow (Linux: 6
/// and 4 MB unless somebody sets them), and some for what counts for each record. The kernel's own structures take half of
/// it, as what whole pages round up may here. At most 64 MB.
std::size_t room_for_a_burst();

}  // namespace detail
}  // namespace tzc
