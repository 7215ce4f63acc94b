// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/advertise_options.h>
#include <ros/forwards.h>

#include <functional>
#include <string>

namespace tzc {
namespace detail {

/// What is called on the clerk's thread with each subscriber that connects. It lives as long as the advertisement that it was
/// added to.
using OnSubscriber = std::function<void(const ros::SubscriberLinkPtr&)>;

/// Adds it to an advertisement that other code is about to make, whose options name the queue of its callbacks: it is called
/// as soon as a subscriber connects, whether or not the program calls what is in that queue.
void hook(const std::string& resolved_topic, ros::AdvertiseOptions& options,
          const OnSubscriber& on_subscriber);
/// Likewise to a publication that the program has already: for the subscribers of now, too, and as long as it has an advertisement, of whichever
/// there are. Unlike an advertisement of TZC's own it does not keep the topic when the program gives it up. Does so on the clerk's thread, since
/// the caller may hold roscpp's locks; once for each `owner`, which must live as long as `on_subscriber`.
void hook(const ros::PublicationPtr& publication, const void* owner, const OnSubscriber& on_subscriber);
/// Whether an advertisement of the publication has that. None may have it: a copy of a publisher keeps the callbacks of an advertisement that was
/// ended. Never waits, and then takes it for granted.
bool is_hooked(ros::Publication& publication, const void* owner);

}  // namespace detail
}  // namespace tzc
