// SPDX-License-Identifier: BSD-3-Clause
/// Two topics through all that message_filters has for them; each line (image_line.h) names the filter that
/// passed its image on.
///
/// Private parameter: plain (message_filters' own Subscriber).
#include <message_filters/cache.h>
#include <message_filters/chain.h>
#include <message_filters/pass_through.h>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <message_filters/time_sequencer.h>
#include <message_filters/time_synchronizer.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tzc/message_filters.h>

#include <boost/bind/bind.hpp>
#include <boost/make_shared.hpp>
#include <string>

#include "image_line.h"

namespace {

using boost::placeholders::_1;
using boost::placeholders::_2;
using sensor_msgs::Image;
using sensor_msgs::ImageConstPtr;
namespace policies = message_filters::sync_policies;

void print(const char* way, const ImageConstPtr& image) {
  tzc_test::print_image(*image, std::string("\"callback\": \"") + way + "\", ");
}
void print_both(const char* way, const ImageConstPtr& one, const ImageConstPtr& other) {
  if (one->header.stamp == other->header.stamp) print(way, one);
}

template <class Subscriber>
void run(ros::NodeHandle& node) {
  const int queue = 100;
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  Subscriber left(node, "image", queue, hints), right(node, "second", queue);

  message_filters::TimeSynchronizer<Image, Image> time(left, right, queue);
  time.registerCallback(boost::bind(print_both, "time", _1, _2));
  message_filters::Synchronizer<policies::ExactTime<Image, Image>> exact(queue);
  exact.connectInput(left, right);
  exact.registerCallback(boost::bind(print_both, "exact", _1, _2));
  message_filters::Synchronizer<policies::ApproximateTime<Image, Image>> approximate(
      policies::ApproximateTime<Image, Image>(queue), left, right);
  approximate.registerCallback(boost::bind(print_both, "approximate", _1, _2));

  message_filters::Cache<Image> cache(left, queue);
  cache.registerCallback(boost::bind(print, "cache", _1));
  message_filters::TimeSequencer<Image> sequencer(left, ros::Duration(0.05), ros::Duration(0.01), queue,
                                                  node);
  sequencer.registerCallback(boost::bind(print, "sequencer", _1));
  message_filters::Chain<Image> chain;
  chain.addFilter(boost::make_shared<Subscriber>(boost::ref(node), "image", queue));
  chain.addFilter(boost::make_shared<message_filters::PassThrough<Image>>());
  chain.registerCallback(boost::bind(print, "chain", _1));

  ros::CallbackQueue own;
  Subscriber later;
  message_filters::SubscriberBase& base = later;
  base.subscribe(node, "second", queue, hints, &own);
  base.unsubscribe();
  base.subscribe();
  later.registerCallback(boost::bind(print, "again", _1));
  const message_filters::Connection connection = later.registerCallback(boost::bind(print, "never", _1));
  message_filters::Connection(connection).disconnect();
  std::printf("{\"topic\": \"%s\", \"resolved\": \"%s\"}\n", later.getTopic().c_str(),
              later.getSubscriber().getTopic().c_str());
  while (ros::ok()) {
    ros::spinOnce();
    own.callAvailable(ros::WallDuration(0.005));
  }
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "filters");
  ros::NodeHandle node;
  if (ros::NodeHandle("~").param("plain", false))
    run<message_filters::Subscriber<Image>>(node);
  else
    run<tzc::message_filters::Subscriber<Image>>(node);
}
