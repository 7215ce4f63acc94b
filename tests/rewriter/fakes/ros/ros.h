// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
#include <map>
#include <sstream>
namespace ros {
class SingleSubscriberPublisher {
 public:
  template <class M>
  void publish(const M&) const {}
};
typedef boost::function<void(const SingleSubscriberPublisher&)> SubscriberStatusCallback;
class Publisher {
 public:
  template <class M>
  void publish(const boost::shared_ptr<M>&) const {}
  template <class M>
  void publish(const M&) const {}
  uint32_t getNumSubscribers() const { return 1; }
  std::string getTopic() const { return ""; }
  void shutdown() {}
  operator void*() const { return nullptr; }
};
class Subscriber {
 public:
  void shutdown() {}
};
class TransportHints {
 public:
  TransportHints& tcpNoDelay() { return *this; }
  TransportHints& reliable() { return *this; }
  TransportHints& unreliable() { return *this; }
};
typedef boost::shared_ptr<void const> VoidConstPtr;
struct AdvertiseOptions {
  template <class M>
  void init(const std::string&, uint32_t) {}
};
struct SubscribeOptions {
  template <class M>
  static SubscribeOptions create(const std::string&, uint32_t,
                                 const boost::function<void(const boost::shared_ptr<M const>&)>&) {
    return {};
  }
  template <class M>
  void init(const std::string&, uint32_t, const boost::function<void(const boost::shared_ptr<M const>&)>&) {}
};
struct TimerEvent {};
class Timer {};
template <class M>
class MessageEvent {
 public:
  typedef typename std::add_const<M>::type ConstMessage;
  typedef typename std::remove_const<M>::type Message;
  typedef boost::function<boost::shared_ptr<Message>()> CreateFunction;
  MessageEvent() {}
  MessageEvent(const MessageEvent<Message>&) {}
  MessageEvent(const MessageEvent<ConstMessage>&) {}
  MessageEvent(const MessageEvent<Message>&, bool) {}
  MessageEvent(const MessageEvent<ConstMessage>&, bool) {}
  MessageEvent(const boost::shared_ptr<ConstMessage>&) {}
  MessageEvent(const boost::shared_ptr<ConstMessage>&, Time, bool, const CreateFunction&) {}
  void operator=(const MessageEvent<Message>&) {}
  void operator=(const MessageEvent<ConstMessage>&) {}
  boost::shared_ptr<M> getMessage() const { return {}; }
  bool nonConstWillCopy() const { return true; }
};
class NodeHandle {
 public:
  explicit NodeHandle(const std::string& = "") {}
  template <class M>
  Publisher advertise(const std::string&, uint32_t, bool = false) {
    return {};
  }
  template <class M>
  Publisher advertise(const std::string&, uint32_t, const SubscriberStatusCallback&,
                      const SubscriberStatusCallback& = {}, const VoidConstPtr& = {}, bool = false) {
    return {};
  }
  Publisher advertise(AdvertiseOptions&) { return {}; }
  template <class M, class T>
  Subscriber subscribe(const std::string&, uint32_t, void (T::*)(M), T*, const TransportHints& = {}) {
    return {};
  }
  template <class M, class T>
  Subscriber subscribe(const std::string&, uint32_t, void (T::*)(const boost::shared_ptr<M const>&), T*,
                       const TransportHints& = {}) {
    return {};
  }
  template <class M>
  Subscriber subscribe(const std::string&, uint32_t, void (*)(M), const TransportHints& = {}) {
    return {};
  }
  template <class M>
  Subscriber subscribe(const std::string&, uint32_t,
                       const boost::function<void(const boost::shared_ptr<M const>&)>&,
                       const VoidConstPtr& = {}, const TransportHints& = {}) {
    return {};
  }
  template <class M, class C>
  Subscriber subscribe(const std::string&, uint32_t, const boost::function<void(C)>&,
                       const VoidConstPtr& = {}, const TransportHints& = {}) {
    return {};
  }
  Subscriber subscribe(SubscribeOptions&) { return {}; }
  template <class T>
  Timer createTimer(Duration, void (T::*)(const TimerEvent&), T*) {
    return {};
  }
  Timer createTimer(Duration, const boost::function<void(const TimerEvent&)>&) { return {}; }
};
inline void init(int, char**, const char*) {}
inline void spin() {}
inline void spinOnce() {}
inline bool ok() {
  return true;
}
namespace console {
inline void print(const char*, ...) {}
}  // namespace console
}  // namespace ros
#define ROS_INFO(...)                       \
  do {                                      \
    ::ros::console::print(__VA_ARGS__);     \
    static_cast<void>(__PRETTY_FUNCTION__); \
  } while (false)
#define ROS_WARN_STREAM(args)                  \
  do {                                         \
    std::stringstream text;                    \
    text << args;                              \
    ::ros::console::print(text.str().c_str()); \
  } while (false)
