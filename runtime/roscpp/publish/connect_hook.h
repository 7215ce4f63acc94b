// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/advertise_options.h>
#include <ros/forwards.h>

#include <functional>

namespace tzc {
namespace detail {

/// What is called on the clerk's thread with each subscriber that connects. It lives as long as the advertisement that it was
/// added to.
using OnSubscriber = std::function<void(const ros::SubscriberLinkPtr&)>;

/// Adds it to an advertisement that other code is about to make, in front of that code's own callback.
void hook(ros::AdvertiseOptions& options, const OnSubscriber& on_subscriber);
/// Adds it to one of the advertisements that a publication has already, and calls it for the subscribers of now, too; at once, whether or
/// not the program calls what is in its queue. Unlike an
/// advertisement of TZC's own it does not keep the topic when the program gives it up. Returns that advertisement's callbacks; null: it has
/// none left, or a callback of one is being queued.
ros::SubscriberCallbacksPtr hook(const ros::PublicationPtr& publication, const OnSubscriber& on_subscriber);
/// Whether these are still callbacks of the publication: a copy of its publisher may keep those of an advertisement that was ended. Never
/// waits, and then takes it for granted.
bool has_callbacks(ros::Publication& publication, const ros::SubscriberCallbacksPtr& callbacks);

}  // namespace detail
}  // namespace tzc
