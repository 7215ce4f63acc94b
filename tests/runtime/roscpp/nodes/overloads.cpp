// SPDX-License-Identifier: BSD-3-Clause
/// One subscription by each overload of ros::NodeHandle::subscribe, each to a topic of its own, named after
/// it; a line for each image (image_line.h).
///
/// Private parameter: list (print the names, and whether the callback may write to its message, and end).
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <topic_tools/shape_shifter.h>
#include <tzc/ros.h>

#include <boost/bind/bind.hpp>
#include <boost/make_shared.hpp>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

using boost::placeholders::_1;
using sensor_msgs::Image;
using sensor_msgs::ImageConstPtr;
using sensor_msgs::ImagePtr;
using ConstEvent = ros::MessageEvent<Image const>;
using Event = ros::MessageEvent<Image>;

void print(const std::string& topic, const Image& image) {
  tzc_test::print_image(image, "\"topic\": \"" + topic + "\", ");
}

/// Callbacks of each kind, as members and as functions; they know their topic by the instantiation.
template <int Number>
struct Callbacks {
  static std::string topic;

  void pointer(const ImageConstPtr& image) { print(topic, *image); }
  void pointer_const(const ImageConstPtr& image) const { print(topic, *image); }
  void reference(const Image& image) { print(topic, image); }
  void reference_const(const Image& image) const { print(topic, image); }
  void event(const ConstEvent& event) { print(topic, *event.getMessage()); }
  void writable(const ImagePtr& image) { print(topic, *image); }
  void overloaded(const ImageConstPtr& image) { print(topic, *image); }
  void overloaded(const std_msgs::StringConstPtr&) {}
  void bound(const ImageConstPtr& image, const std::string& name) { print(name, *image); }

  static void function(const ImageConstPtr& image) { print(topic, *image); }
  static void by_copy_of_pointer(ImageConstPtr image) { print(topic, *image); }
  static void by_reference(const Image& image) { print(topic, image); }
  static void by_value(Image image) { print(topic, image); }
  static void by_writable_pointer(const ImagePtr& image) { print(topic, *image); }
  static void by_event(const ConstEvent& event) { print(topic, *event.getMessage()); }
  static void by_writable_event(const Event& event) { print(topic, *event.getMessage()); }
  static void shapeless(const topic_tools::ShapeShifter::ConstPtr& message) {
    print(topic, *message->instantiate<Image>());
  }
};
template <int Number>
std::string Callbacks<Number>::topic;

struct Overloads {
  ros::NodeHandle node;
  bool list;
  std::vector<ros::Subscriber> subscribers;
  boost::shared_ptr<ros::CallbackQueue> queue = boost::make_shared<ros::CallbackQueue>();
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();

  template <int Number, class Subscribe>
  void add(const std::string& topic, bool shared, Subscribe subscribe) {
    if (list) {
      std::printf("{\"overload\": \"%s\", \"shared\": %s}\n", topic.c_str(), shared ? "true" : "false");
      return;
    }
    typedef Callbacks<Number> C;
    C::topic = topic;
    subscribers.push_back(subscribe(topic, boost::make_shared<C>()));
  }
};

// Each statement below is what a node would write, with `nh.subscribe(` replaced by `tzc::subscribe(nh, `.
#define OVERLOAD(name, shared, ...)                                                                      \
  overloads.add<__LINE__>(name, shared,                                                                  \
                          [&](const std::string& topic,                                                  \
                              const boost::shared_ptr<Callbacks<__LINE__>>& object) -> ros::Subscriber { \
                            typedef Callbacks<__LINE__> C;                                               \
                            static C kept;                                                               \
                            (void)object, (void)kept;                                                    \
                            __VA_ARGS__                                                                  \
                          })

void members(Overloads& overloads, ros::NodeHandle& nh) {
  OVERLOAD("member", true, return tzc::subscribe(nh, topic, 100, &C::pointer, &kept););
  OVERLOAD("const_member", true,
           return tzc::subscribe(nh, topic, 100, &C::pointer_const, &kept, overloads.hints););
  OVERLOAD("member_reference", true, return tzc::subscribe(nh, topic, 100, &C::reference, &kept););
  OVERLOAD("const_member_reference", true,
           return tzc::subscribe(nh, topic, 100, &C::reference_const, &kept););
  OVERLOAD("member_event", true, return tzc::subscribe(nh, topic, 100, &C::event, &kept););
  OVERLOAD("member_writable", false, return tzc::subscribe(nh, topic, 100, &C::writable, &kept););
  OVERLOAD("overloaded_member", true, return tzc::subscribe<Image>(nh, topic, 100, &C::overloaded, &kept););
}

void tracked_members(Overloads& overloads, ros::NodeHandle& nh) {
  static std::vector<boost::shared_ptr<void>> alive;
  OVERLOAD("tracked", true, alive.push_back(object);
           return tzc::subscribe(nh, topic, 100, &C::pointer, object););
  OVERLOAD("tracked_const", true, alive.push_back(object);
           return tzc::subscribe(nh, topic, 100, &C::pointer_const, object, overloads.hints););
  OVERLOAD("tracked_reference", true, alive.push_back(object);
           return tzc::subscribe(nh, topic, 100, &C::reference, object););
  OVERLOAD("tracked_const_reference", true, alive.push_back(object);
           return tzc::subscribe(nh, topic, 100, &C::reference_const, object););
  OVERLOAD("tracked_gone", true, return tzc::subscribe(nh, topic, 100, &C::pointer, object););
}

void functions(Overloads& overloads, ros::NodeHandle& nh) {
  OVERLOAD("function", true, return tzc::subscribe(nh, topic, 100, C::function););
  OVERLOAD("function_hints", true, return tzc::subscribe(nh, topic, 100, &C::function, overloads.hints););
  OVERLOAD("function_by_copy_of_pointer", true,
           return tzc::subscribe(nh, topic, 100, C::by_copy_of_pointer););
  OVERLOAD("function_by_reference", true, return tzc::subscribe(nh, topic, 100, C::by_reference););
  OVERLOAD("function_by_event", true, return tzc::subscribe(nh, topic, 100, C::by_event););
  OVERLOAD("function_by_value", false, return tzc::subscribe(nh, topic, 100, C::by_value););
  OVERLOAD("function_by_writable_pointer", false,
           return tzc::subscribe(nh, topic, 100, C::by_writable_pointer););
  OVERLOAD("function_by_writable_event", false, return tzc::subscribe(nh, topic, 100, C::by_writable_event););
  OVERLOAD("function_of_type", true, return tzc::subscribe<Image>(nh, topic, 100, C::function););
  OVERLOAD("shape_shifter", false, return tzc::subscribe(nh, topic, 100, C::shapeless););
}

void function_objects(Overloads& overloads, ros::NodeHandle& nh) {
  OVERLOAD("bind", true,
           return tzc::subscribe<Image>(nh, topic, 100, boost::bind(&C::bound, &kept, _1, topic)););
  OVERLOAD("boost_function", true, const boost::function<void(const ImageConstPtr&)> function = C::function;
           return tzc::subscribe<Image>(nh, topic, 100, function, ros::VoidConstPtr(), overloads.hints););
  OVERLOAD("lambda_of_two_types", true,
           return (tzc::subscribe<Image, const Image&>(
               nh, topic, 100, [topic](const Image& image) { print(topic, image); })););
  OVERLOAD("event_of_two_types", true,
           return (tzc::subscribe<Image, const ConstEvent&>(nh, topic, 100, boost::bind(C::by_event, _1))););
  OVERLOAD("temporary_handle", true, return tzc::subscribe(ros::NodeHandle(), topic, 100, C::function););
  OVERLOAD("temporary_handle_of_two_types", true,
           return (tzc::subscribe<Image, const Image&>(ros::NodeHandle(), topic, 100, C::by_reference)););
  OVERLOAD("direct", true, return tzc::subscribe_direct(nh, topic, 100, &C::pointer, &kept););
  OVERLOAD("direct_of_type", true,
           return tzc::subscribe_direct<Image>(nh, topic, 100, boost::bind(&C::pointer, &kept, _1)););
}

void options(Overloads& overloads, ros::NodeHandle& nh) {
  OVERLOAD("options", true, ros::SubscribeOptions options; options.init<Image>(topic, 100, C::function);
           return tzc::subscribe<Image>(nh, options););
  OVERLOAD("options_with_a_queue", true,
           ros::SubscribeOptions options = ros::SubscribeOptions::create<Image>(
               topic, 100, C::function, ros::VoidConstPtr(), overloads.queue.get());
           return tzc::subscribe<Image>(nh, options););
  OVERLOAD("options_concurrent", true, ros::SubscribeOptions options;
           options.initByFullCallbackType<const Image&>(topic, 100, C::by_reference);
           options.allow_concurrent_callbacks = true;
           return tzc::subscribe<Image>(ros::NodeHandle(), options););
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "overloads");
  ros::NodeHandle node;
  Overloads overloads{node, ros::NodeHandle("~").param("list", false), {}};
  members(overloads, node);
  tracked_members(overloads, node);
  functions(overloads, node);
  function_objects(overloads, node);
  options(overloads, node);
  if (overloads.list) return 0;
  while (ros::ok()) {
    ros::spinOnce();
    overloads.queue->callAvailable(ros::WallDuration(0.01));
  }
}
