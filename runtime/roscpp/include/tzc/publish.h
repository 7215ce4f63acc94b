// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publisher.h>
#include <tzc/attach.h>
#include <tzc/publisher.h>

#include <boost/shared_ptr.hpp>
#include <type_traits>

namespace tzc {

namespace detail {
/// The message type of what is published: the message itself, or a pointer to one.
template <class Message>
struct PublishedType {
  typedef Message type;
};
template <class M>
struct PublishedType<boost::shared_ptr<M> > {
  typedef typename std::remove_const<M>::type type;
};
}  // namespace detail

/// `publisher.publish(message)`, through shared memory where subscribers can use it. For a publisher that other code advertised and
/// keeps as ros::Publisher: a member of a library's base class, a parameter. The first call attaches shared memory to the topic,
/// sized by queue and message, for as long as the program advertises it; roscpp's own publisher is not changed, and ends the topic
/// as before. `message`: a message, or a boost::shared_ptr to one, stock or tzc::. A stock message is copied once. What is
/// published before subscribers have moved to shared memory, of another type than the topic's, or of one without a partial form, goes the
/// publisher's own way. Thread-safe like ros::Publisher; errors are roscpp's own.
template <class Message>
void publish(const ros::Publisher& publisher, const Message& message) {
  typedef typename detail::PublishedType<Message>::type M;
  Publisher(publisher, detail::lasting_attachment<M>(publisher)).publish(message);
}

}  // namespace tzc
