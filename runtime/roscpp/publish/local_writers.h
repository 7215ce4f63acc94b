// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>
#include <tzc/detail/codec.h>

namespace tzc {
namespace detail {

/// True when a callback of this process may write to a message of type `codec.type` that the publication
/// passes to it by pointer. roscpp copies for such a callback only when the subscription has others besides.
/// Takes subscriber_links_mutex_ and the subscription's callbacks_mutex_, briefly.
bool has_local_writers(ros::Publication& publication, const MessageCodec& codec);

}  // namespace detail
}  // namespace tzc
