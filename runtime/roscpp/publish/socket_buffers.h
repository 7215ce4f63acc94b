// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tzc {
namespace detail {

/// What the socket buffers of a TCPROS connection on one machine hold, in bytes. Besides its queue, which roscpp cuts to its
/// size, a TCPROS link has a message that is being written and these: so many more survive while the subscriber does not read.
/// By default Linux lets a receive buffer grow to 6 MB and a send buffer to 4 MB (net.ipv4.tcp_rmem, tcp_wmem), of which the
/// kernel's own structures take half. Measured: 4.1 to 4.2 MB, with messages of 60 bytes to 4 MB.
constexpr std::size_t kSocketBuffers = std::size_t{4} << 20;

/// A channel's room for as much. Twice, because its blocks count in whole pages, and some for what counts for each record.
constexpr std::size_t kBufferedBytes = 2 * kSocketBuffers + (std::size_t{1} << 20);

}  // namespace detail
}  // namespace tzc
