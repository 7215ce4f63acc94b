// SPDX-License-Identifier: BSD-3-Clause
/// Publishers that other code gives up, while the program still has a copy of each with shared memory attached to it. Prints as JSON
/// whether the topic is advertised before and after.
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/image_transport.h>
#include <tzc/ros.h>

#include <algorithm>
#include <string>

#include "race.h"

namespace {

bool is_advertised(const std::string& topic) {
  ros::V_string topics;
  ros::this_node::getAdvertisedTopics(topics);
  return std::find(topics.begin(), topics.end(), topic) != topics.end();
}

template <class Stock, class Attach>
void give_up(Stock of_a_library, const std::string& topic, Attach attach) {
  const auto copy = attach(of_a_library);
  tzc_test::print_event(topic + " before", is_advertised(topic) && copy.memory() != nullptr);
  of_a_library.shutdown();
  tzc_test::print_event(topic + " after", is_advertised(topic));
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "given_up");
  ros::NodeHandle node;
  give_up(node.advertise<sensor_msgs::Image>("/plain", 10), "/plain", [](const ros::Publisher& publisher) {
    return tzc::attach_publisher<sensor_msgs::Image>(publisher);
  });
  image_transport::ImageTransport transport(node);
  const auto attach = [](const auto& publisher) { return tzc::image_transport::attach_publisher(publisher); };
  give_up(transport.advertise("/image", 10), "/image", attach);
  give_up(transport.advertiseCamera("/camera", 10), "/camera", attach);
}
