// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
namespace tzc {
class Publisher {
 public:
  template <class M>
  void publish(const boost::shared_ptr<M>&) const {}
  template <class M>
  void publish(const M&) const {}
  template <class M>
  bool allocate(M&) const {  // does nothing for a stock message
    return true;
  }
  uint32_t getNumSubscribers() const { return 1; }
  std::string getTopic() const { return ""; }
  void shutdown() {}
  operator void*() const { return nullptr; }
};
template <class M>
bool allocate(M&) {
  return true;
}
template <class Map>
const typename Map::mapped_type& find_publisher(const Map& map, const typename Map::key_type&) {
  return map.begin()->second;
}
template <class Sequence, class Index>
auto find_publisher(const Sequence& sequence, Index) -> decltype(sequence[0u]) {
  return sequence[0u];
}
template <class M>
Publisher advertise(const ros::NodeHandle&, const std::string&, uint32_t, std::size_t = 0, bool = false) {
  return {};
}
template <class M, class Bool>
std::enable_if_t<std::is_same<Bool, bool>::value, Publisher> advertise(const ros::NodeHandle&,
                                                                       const std::string&, uint32_t, Bool) {
  return {};
}
template <class M>
Publisher advertise(const ros::NodeHandle&, const std::string&, uint32_t,
                    const ros::SubscriberStatusCallback&, const ros::SubscriberStatusCallback& = {},
                    const ros::VoidConstPtr& = {}, bool = false) {
  return {};
}
template <class M>
Publisher advertise(const ros::NodeHandle&, const std::string&, uint32_t, std::size_t,
                    const ros::SubscriberStatusCallback&, const ros::SubscriberStatusCallback& = {},
                    const ros::VoidConstPtr& = {}, bool = false) {
  return {};
}
template <class M>
Publisher advertise(const ros::NodeHandle&, ros::AdvertiseOptions&, std::size_t = 0) {
  return {};
}
template <class M>
Publisher attach_publisher(const ros::Publisher&, std::size_t = 0) {
  return {};
}
template <class M>
ros::Publisher attached(const ros::Publisher& publisher) {
  return publisher;
}
template <class M>
void publish(const ros::Publisher&, const M&) {}
template <class... A>
ros::Subscriber subscribe(ros::NodeHandle nh, A&&... a) {
  return nh.subscribe(std::forward<A>(a)...);
}
template <class M, class... A>
ros::Subscriber subscribe(ros::NodeHandle nh, A&&... a) {
  return nh.subscribe<M>(std::forward<A>(a)...);
}
template <class M>
ros::Subscriber subscribe(ros::NodeHandle nh, ros::SubscribeOptions& options) {
  return nh.subscribe(options);
}
template <class M, class C, class... A>
ros::Subscriber subscribe(ros::NodeHandle nh, const std::string& topic, uint32_t queue, A&&... a) {
  return nh.subscribe<M, C>(topic, queue, std::forward<A>(a)...);
}
}  // namespace tzc
