// SPDX-License-Identifier: BSD-3-Clause
/// Callbacks of events that pass them on, without a cast, to code that writes to the message: a filter's lone writer, and an event of a message
/// that may be written to. Prints whether both have got a message that is theirs, and what a reader sees of it.
#include <message_filters/simple_filter.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>

#include "race.h"

namespace {

typedef ros::MessageEvent<sensor_msgs::Image const> Event;

struct Filter : message_filters::SimpleFilter<sensor_msgs::Image> {
  void pass_on(const Event& event) { signalMessage(event); }
};

int filtered = 0, converted = 0;

void double_size(const sensor_msgs::ImagePtr& image) {
  image->data.resize(2 * image->data.size());
  ++filtered;
}

void convert(const Event& event) {
  ros::MessageEvent<sensor_msgs::Image>(event).getMessage()->data.resize(1 << 20);
  ++converted;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "event_writer");
  ros::NodeHandle node;
  Filter filter;
  filter.registerCallback(boost::function<void(const sensor_msgs::ImagePtr&)>(double_size));
  const ros::Subscriber one = tzc::subscribe(node, "image", 100, &Filter::pass_on, &filter);
  tzc_test::print_event("filtered", tzc_test::eventually([] { return ros::spinOnce(), filtered == 10; }));
  const ros::Subscriber other = tzc::subscribe(node, "other", 100, convert);
  tzc_test::print_event("converted", tzc_test::eventually([] { return ros::spinOnce(), converted == 10; }));
}
