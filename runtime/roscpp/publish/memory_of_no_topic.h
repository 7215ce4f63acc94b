// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace detail {

/// From now on there is a memory_of_no_topic(): a topic of this process has shared memory. Thread-safe.
void note_topic_with_memory();

}  // namespace detail
}  // namespace tzc
