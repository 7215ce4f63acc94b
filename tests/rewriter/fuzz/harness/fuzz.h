// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What generated programs use besides ROS. To tzc-rewrite it is a foreign library.
//
//   talker   : runs the programs; each publish is followed by sent()
//   listener : runs their subscribers, in a process of its own, and writes down what they receive
//   recorder : writes down the bytes of every message, as any ROS tool would see them

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/serialization.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace fuzz {

/// \name Contents, the same in every run
/// @{
std::uint32_t value(int index, int k);
/// How many elements a message has; small, sometimes none, sometimes more than a page.
int size(int k, int seed);
template <class T>
T element_of(int index, int k, std::false_type) {
  return static_cast<T>(value(index, k));
}
template <class T>
T element_of(int index, int k, std::true_type) {
  T one;
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(one));
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(value(index, k) % 60);
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(in, one);
  return one;
}
/// A number, or a message with something in each field.
template <class T>
T element(int index, int k) {
  return element_of<T>(index, k, std::is_class<T>());
}
template <class T>
std::vector<T> elements(int count, int k) {
  std::vector<T> all;
  for (int i = 0; i < count; ++i) all.push_back(element<T>(i, k));
  return all;
}
/// A library function that takes a vector.
template <class T>
void fill(std::vector<T>& array, int count, int k) {
  array = elements<T>(count, k);
}
/// @}

/// \name Code of a library that calls the program's
/// @{
const std::vector<int> once = {1};
void call(const std::function<void()>& function);
/// Long enough for another thread to come first.
void pause();
/// At the next spinOnce().
void later(const std::function<void()>& function);
/// @}

/// Advertises by itself what others publish.
struct Outlet {
  ros::Publisher out;
  template <class M>
  void open(ros::NodeHandle& node, const std::string& topic) {
    out = node.advertise<M>(topic, 50);
  }
};

/// \name A library that is given publishers of the program
/// @{
/// Nothing shows what it does with one.
template <class P>
void borrow(P&) {}
template <class P, class M>
void publish_for(const P& publisher, const M& message) {
  publisher.publish(message);
}
/// @}

/// \name The talker
/// @{
/// Leaves the program's name in a file, for when it ends the talker: the logs end earlier, since queued messages are lost.
void running(const std::string& program);
void sent(const std::string& topic);
/// A relay in this process has passed a message of `topic` on.
void handled(const std::string& topic);
/// Returns when `topic` has its subscribers.
void wait(const std::string& topic);
/// Returns when listener and recorder have everything that was sent on `topic`.
void drain(const std::string& topic);
void expect(const std::string& topic, unsigned subscribers, unsigned relays);
void wait_for_all();
/// Returns when the relays have handled everything.
void settle();
void round_done();
/// What TZC has counted for each topic so far, while the publishers live; nothing without a monitor.
void write_counters(const std::string& file);
int finish();
/// @}

/// \name The listener
/// @{
void note(const std::string& topic, const std::vector<std::uint8_t>& bytes, const void* data);
template <class M>
auto data_of(const M& message, int) -> decltype(static_cast<const void*>(message.data.data())) {
  return message.data.data();
}
template <class M>
auto data_of(const M& message, int) -> decltype(static_cast<const void*>(message.ranges.data())) {
  return message.ranges.data();
}
template <class M>
auto data_of(const M& message, int) -> decltype(static_cast<const void*>(message.points.data())) {
  return message.points.data();
}
template <class M>
const void* data_of(const M&, long) {
  return nullptr;
}
template <class M>
std::vector<std::uint8_t> bytes_of(const M& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}
template <class M>
void received(const std::string& topic, const M& message) {
  note(topic, bytes_of(message), data_of(message, 0));
}
/// Looks at the message again, each time that another one is received and at the end: it must stay as it was received.
void keep(const std::string& topic, std::function<std::vector<std::uint8_t>()> bytes);
template <class M>
void keep(const std::string& topic, const boost::shared_ptr<const M>& message) {
  keep(topic, [message] { return bytes_of(*message); });
}
int listen();
/// @}

/// The name of the node: "talker" or "listener", the program's only argument.
std::string role(int argc, char** argv);
bool listens();

}  // namespace fuzz
