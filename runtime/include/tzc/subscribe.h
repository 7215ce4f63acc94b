// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/parameter_adapter.h>
#include <ros/subscribe_options.h>
#include <ros/subscriber.h>
#include <tzc/detail/codec.h>

#include <boost/function.hpp>
#include <string>
#include <type_traits>
#include <utility>

namespace tzc {

namespace detail {

/// Lets publishers of the resolved topic hand this process their messages through shared memory. Idempotent and
/// thread-safe. A subscription that is already connected asks its publishers to come over.
void attach_topic(const std::string& resolved_topic, const MessageCodec& codec);

/// "Find the message type in the callback's signature", as ros::NodeHandle::subscribe does without template arguments.
struct Deduce {};

template <class Callback>
struct CallbackParameter {};
template <class P>
struct CallbackParameter<void (*)(P)> {
  typedef P type;
};
template <class T, class P>
struct CallbackParameter<void (T::*)(P)> {
  typedef P type;
};
template <class T, class P>
struct CallbackParameter<void (T::*)(P) const> {
  typedef P type;
};

/// How a subscribe call is passed on to roscpp, with or without its written template argument.
template <class M>
struct SubscribeCall {
  template <class Callback>
  using Message = typename ros::ParameterAdapter<M>::Message;

  template <class... Args>
  static ros::Subscriber call(ros::NodeHandle& node, Args&&... args) {
    return node.subscribe<M>(std::forward<Args>(args)...);
  }
};
template <>
struct SubscribeCall<Deduce> {
  template <class Callback>
  using Message = typename ros::ParameterAdapter<typename CallbackParameter<Callback>::type>::Message;

  template <class... Args>
  static ros::Subscriber call(ros::NodeHandle& node, Args&&... args) {
    return node.subscribe(std::forward<Args>(args)...);
  }
};

}  // namespace detail

/// Attaches an existing or coming subscription of this process by topic, as `node` resolves it. M is the stock message
/// type of the callbacks; they keep their signatures and get views of the shared bytes. Callbacks that may write to
/// the message (by value, by non-const pointer) get a private copy.
template <class M>
void attach(const ros::NodeHandle& node, const std::string& topic) {
  detail::attach_topic(node.resolveName(topic), detail::make_codec<M>());
}
/// The same for a topic name that is already resolved, such as Subscriber::getTopic().
template <class M>
void attach(const std::string& resolved_topic) {
  detail::attach_topic(resolved_topic, detail::make_codec<M>());
}

/// ros::NodeHandle::subscribe in all its overloads, with shared memory: `nh.subscribe(args...)` becomes
/// `tzc::subscribe(nh, args...)` and `nh.subscribe<M>(args...)` becomes `tzc::subscribe<M>(nh, args...)`.
/// @param callback a function, a member function (then the object follows), or with a written M anything that converts
///        to boost::function<void(const boost::shared_ptr<M const>&)>
/// @param rest object, tracked object, transport hints: as for the ros::NodeHandle::subscribe that is called
template <class M = detail::Deduce, class Callback, class... Rest>
ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                          Callback&& callback, Rest&&... rest) {
  typedef detail::SubscribeCall<M> Call;
  attach<typename Call::template Message<typename std::decay<Callback>::type>>(node, topic);
  return Call::call(node, topic, queue_size, std::forward<Callback>(callback), std::forward<Rest>(rest)...);
}

/// ros::NodeHandle::subscribe<M, C> with a boost::function<void(C)>.
template <class M, class C>
ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                          const boost::function<void(C)>& callback,
                          const ros::VoidConstPtr& tracked_object = ros::VoidConstPtr(),
                          const ros::TransportHints& hints = ros::TransportHints()) {
  attach<M>(node, topic);
  return node.subscribe<M, C>(topic, queue_size, callback, tracked_object, hints);
}

/// By options; M: the message type that the options were made for.
template <class M>
ros::Subscriber subscribe(ros::NodeHandle& node, ros::SubscribeOptions& options) {
  attach<M>(node, options.topic);
  return node.subscribe(options);
}

/// Every form also for a temporary node handle (`tzc::subscribe(getNodeHandle(), ...)`).
template <class M = detail::Deduce, class... Args>
ros::Subscriber subscribe(ros::NodeHandle&& node, Args&&... args) {
  return subscribe<M>(static_cast<ros::NodeHandle&>(node), std::forward<Args>(args)...);
}

}  // namespace tzc
