// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/parameter_adapter.h>
#include <ros/subscribe_options.h>
#include <ros/subscriber.h>
#include <tzc/detail/codec.h>

#include <boost/function.hpp>
#include <boost/make_shared.hpp>
#include <string>
#include <type_traits>
#include <utility>

namespace tzc {

namespace detail {

/// Lets publishers of the resolved topic send to this process over shared memory. Idempotent and thread-safe.
/// A subscription that is already connected asks its publishers for an upgrade.
void attach_topic(const std::string& resolved_topic, const MessageCodec& codec);

/// Messages of a type without a partial form stay on TCPROS.
template <class M>
void attach_type(const std::string& resolved_topic, std::true_type) {
  attach_topic(resolved_topic, make_codec<M>());
}
template <class M>
void attach_type(const std::string&, std::false_type) {}

/// A node handle that subscribes: a variable or a temporary (`tzc::subscribe(getNodeHandle(), ...)`).
class Node {
 public:
  Node(ros::NodeHandle& handle) : handle_(handle) {}   // NOLINT: stands for the handle
  Node(ros::NodeHandle&& handle) : handle_(handle) {}  // NOLINT: as above
  operator ros::NodeHandle&() const { return handle_; }
  ros::NodeHandle* operator->() const { return &handle_; }

 private:
  ros::NodeHandle& handle_;
};

/// The message type of a callback with parameter P.
template <class P>
using MessageOf = typename ros::ParameterAdapter<P>::Message;

/// roscpp's own subscribe; the callback is in the trace when this process writes one.
ros::Subscriber subscribe_by_options(ros::NodeHandle& node, ros::SubscribeOptions& options);

}  // namespace detail

/// Attaches an existing or future subscription of this process; `node` resolves the topic. M is the stock
/// message type of the callbacks; they keep their signatures and get views of the shared bytes. Callbacks
/// that may write to the message (by value, by non-const pointer) get a private copy. Does nothing for types
/// without a partial form (message::HasPartialForm): topic_tools::ShapeShifter, types with a hand-written
/// serializer. Thread-safe and idempotent.
template <class M>
void attach(const ros::NodeHandle& node, const std::string& topic) {
  detail::attach_type<M>(node.resolveName(topic), message::HasPartialForm<M>());
}
/// The same for a topic name that is already resolved, such as Subscriber::getTopic().
template <class M>
void attach(const std::string& resolved_topic) {
  detail::attach_type<M>(resolved_topic, message::HasPartialForm<M>());
}

namespace detail {

/// The callback; one for events gets events that copy the message for whoever may write to it: an event can be passed on to such code without
/// a cast (a filter's signalMessage, ros::MessageEvent<M>), and a view of shared memory must not be resized.
template <class P>
boost::function<void(P)> with_copies_for_writers(const boost::function<void(P)>& callback) {
  return callback;
}
template <class M>
boost::function<void(const ros::MessageEvent<M const>&)> with_copies_for_writers(
    const boost::function<void(const ros::MessageEvent<M const>&)>& callback) {
  return [callback](const ros::MessageEvent<M const>& event) {
    const bool writers_need_a_copy = true;
    callback(ros::MessageEvent<M const>(event, writers_need_a_copy));
  };
}

/// Does what the overloads of ros::NodeHandle::subscribe do. `tracked`: the callback ends with that object.
template <class P>
ros::Subscriber subscribe_callback(Node node, const std::string& topic, std::uint32_t queue_size,
                                   const boost::function<void(P)>& given, const ros::TransportHints& hints,
                                   const ros::VoidConstPtr& tracked = ros::VoidConstPtr()) {
  attach<MessageOf<P>>(node, topic);
  const boost::function<void(P)> callback = with_copies_for_writers(given);
  ros::SubscribeOptions options;
  options.initByFullCallbackType<P>(topic, queue_size, callback);
  // The user's own callback, and no library's that passes the message on: it reads what it is given to read.
  if (ros::ParameterAdapter<P>::is_const) options.helper = boost::make_shared<ReadingCallbackT<P>>(callback);
  options.tracked_object = tracked;
  options.transport_hints = hints;
  return subscribe_by_options(node, options);
}

/// A member function of an object as a function of its parameter.
template <class P, class T, class Member>
boost::function<void(P)> bound(Member callback, T* object) {
  return [callback, object](P message) { (object->*callback)(std::forward<P>(message)); };
}

}  // namespace detail

/// \name ros::NodeHandle::subscribe in all its overloads, with shared memory
/// `nh.subscribe(args...)` becomes `tzc::subscribe(nh, args...)`, and `nh.subscribe<M>(args...)` becomes
/// `tzc::subscribe<M>(nh, args...)`. The signatures are roscpp's, so that overload resolution is, too.
/// @{

/// A member function of an object that outlives the subscription.
template <class P, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(P), T* object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<P>(node, topic, queue_size, detail::bound<P>(callback, object), hints);
}
template <class P, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(P) const, T* object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<P>(node, topic, queue_size, detail::bound<P>(callback, object), hints);
}
template <class M, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(const boost::shared_ptr<M const>&), T* object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<const boost::shared_ptr<M const>&>(
      node, topic, queue_size, detail::bound<const boost::shared_ptr<M const>&>(callback, object), hints);
}
template <class M, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(const boost::shared_ptr<M const>&) const, T* object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<const boost::shared_ptr<M const>&>(
      node, topic, queue_size, detail::bound<const boost::shared_ptr<M const>&>(callback, object), hints);
}

/// A member function of a tracked object: once the object is destroyed the callback is not called any more.
template <class P, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(P), const boost::shared_ptr<T>& object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<P>(node, topic, queue_size, detail::bound<P>(callback, object.get()),
                                       hints, object);
}
template <class P, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(P) const, const boost::shared_ptr<T>& object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<P>(node, topic, queue_size, detail::bound<P>(callback, object.get()),
                                       hints, object);
}
template <class M, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(const boost::shared_ptr<M const>&),
                          const boost::shared_ptr<T>& object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<const boost::shared_ptr<M const>&>(
      node, topic, queue_size, detail::bound<const boost::shared_ptr<M const>&>(callback, object.get()),
      hints, object);
}
template <class M, class T>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (T::*callback)(const boost::shared_ptr<M const>&) const,
                          const boost::shared_ptr<T>& object,
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<const boost::shared_ptr<M const>&>(
      node, topic, queue_size, detail::bound<const boost::shared_ptr<M const>&>(callback, object.get()),
      hints, object);
}

/// A function.
template <class P>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (*callback)(P), const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<P>(node, topic, queue_size, callback, hints);
}
template <class M>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          void (*callback)(const boost::shared_ptr<M const>&),
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<const boost::shared_ptr<M const>&>(node, topic, queue_size, callback,
                                                                       hints);
}

/// Anything that converts to the boost::function; the caller names M.
template <class M>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          const boost::function<void(const boost::shared_ptr<M const>&)>& callback,
                          const ros::VoidConstPtr& tracked_object = ros::VoidConstPtr(),
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<const boost::shared_ptr<M const>&>(node, topic, queue_size, callback,
                                                                       hints, tracked_object);
}
template <class M, class P>
ros::Subscriber subscribe(detail::Node node, const std::string& topic, std::uint32_t queue_size,
                          const boost::function<void(P)>& callback,
                          const ros::VoidConstPtr& tracked_object = ros::VoidConstPtr(),
                          const ros::TransportHints& hints = ros::TransportHints()) {
  return detail::subscribe_callback<P>(node, topic, queue_size, callback, hints, tracked_object);
}

/// By options; the caller names M, the message type that the options were made for.
template <class M>
ros::Subscriber subscribe(detail::Node node, ros::SubscribeOptions& options) {
  attach<M>(node, options.topic);
  return detail::subscribe_by_options(node, options);
}
/// @}

}  // namespace tzc
