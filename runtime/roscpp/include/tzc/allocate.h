// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/attachment.h>
#include <tzc/detail/message_impl.h>

namespace tzc {

/// Binds the message's arrays to shared memory of the node, now or as they grow, where the message is built far from its publisher: any
/// publisher of the process can publish it without a copy. May be called before or after the sizes are set. All such messages share
/// one memory, so prefer publisher.allocate(message) where the publisher is known: one topic with slow subscribers then takes no
/// memory from others. False: none is left, or no topic of the node has shared memory (yet); the message stays usable.
template <class M>
bool allocate(M& message) {
  return message::allocate(message, detail::memory_of_no_topic());
}

}  // namespace tzc
