// SPDX-License-Identifier: BSD-3-Clause
/// A publisher, one of whose mutexes of roscpp is held as roscpp may hold it. Prints what happened as lines of JSON ("event").
///
/// Private parameter: scene, one of
///   queued   roscpp's poll thread finds that a plain subscriber's connection has ended, while the node sends what waits in roscpp's
///            queue
///   alone    the same, while the node publishes to that subscriber alone
///   away     the node subscribes to a topic while the master does not answer, and a subscriber comes
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <functional>
#include <string>
#include <thread>

#include "image_line.h"
#include "race.h"
#include "roscpp/roscpp_access.h"

namespace members {

using namespace tzc::roscpp_access;

template <class Tag, typename Tag::type Member>
struct GrantHere {
  friend typename Tag::type member(Tag) { return Member; }
};
struct CloseMutex {
  typedef boost::recursive_mutex ros::TransportTCP::* type;
  friend type member(CloseMutex);
};
template struct GrantHere<CloseMutex, &ros::TransportTCP::close_mutex_>;

}  // namespace members

namespace tzc_test {
namespace {

boost::recursive_mutex& close_mutex(ros::TransportSubscriberLink& link) {
  auto& tcp = static_cast<ros::TransportTCP&>(*link.getConnection()->getTransport());
  return tcp.*member(members::CloseMutex());
}

bool is_writing(ros::TransportSubscriberLink& link) {
  const boost::mutex::scoped_lock lock(members::outbox_mutex_(link));
  return members::writing_message_(link);
}

/// The only subscriber that is on TCPROS.
ros::TransportSubscriberLinkPtr plain_link(ros::Publication& publication) {
  const boost::mutex::scoped_lock lock(members::subscriber_links_mutex_(publication));
  for (const ros::SubscriberLinkPtr& link : members::subscriber_links_(publication))
    if (const auto tcp = boost::dynamic_pointer_cast<ros::TransportSubscriberLink>(link)) return tcp;
  return nullptr;
}

/// Does what the poll thread does with a connection that ended (TransportTCP::socketUpdate, Publication::removeSubscriberLink), and takes
/// the second mutex when another thread, which runs `send`, waits for the first one.
void end_while(const std::function<void()>& send) {
  const ros::PublicationPtr publication =
      ros::TopicManager::instance()->lookupPublication(ros::names::resolve("image"));
  ros::TransportSubscriberLinkPtr link;
  eventually([&] { return (link = plain_link(*publication)) != nullptr; });
  std::thread poll([&] {
    const boost::recursive_mutex::scoped_lock closing(close_mutex(*link));
    gate().tell("closing");
    eventually([&] { return is_writing(*link); });
    ros::WallDuration(0.1).sleep();
    boost::mutex::scoped_lock links(members::subscriber_links_mutex_(*publication), boost::defer_lock);
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(3);
    while (!links.try_lock() && ros::WallTime::now() < end) ros::WallDuration(0.001).sleep();
    print_event("removed the link", links.owns_lock());
  });
  gate().wait_for({"closing"});
  send();
  poll.join();
}

// The poll thread is held so that the bytes wait in roscpp's queue.
void queued(ros::NodeHandle& node) {
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  const ros::Publisher other = node.advertise<sensor_msgs::Image>("image", 100);
  eventually(
      [&] { return publisher.statistics().shared_subscribers == 1 && other.getNumSubscribers() == 2; });
  ros::WallDuration(0.5).sleep();  // the move's end
  hold_poll_thread_now();
  sensor_msgs::Image image;
  fill_image(image, 0, 20000);
  other.publish(image);
  end_while([&] { publish(publisher, 1, 2); });
  publish(publisher, 2, 10);
  let_go_and_end();
}

void alone(ros::NodeHandle& node) {
  bool greeted = false;
  const ros::SubscriberStatusCallback greet = [&](const ros::SingleSubscriberPublisher& subscriber) {
    sensor_msgs::Image image;
    fill_image(image, 0, 20000);
    end_while([&] { subscriber.publish(image); });
    greeted = true;
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100, greet);
  eventually([&] {
    ros::spinOnce();
    return greeted;
  });
  publish(publisher, 1, 10);
  let_go_and_end();
}

void away(ros::NodeHandle& node) {
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> ignore = [](const auto&) {};
  const ros::Subscriber own = tzc::subscribe<sensor_msgs::Image>(node, "other", 1, ignore);
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  eventually([&] { return publisher.statistics().shared_subscribers == 1; });
  {
    const boost::mutex::scoped_lock lock(members::subs_mutex_(*ros::TopicManager::instance()));
    ros::WallDuration(1.5).sleep();  // the statistics are written once a second
    print_event("ready", true);
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(30);
    while (publisher.statistics().shared_subscribers < 2 && ros::WallTime::now() < end)
      ros::WallDuration(0.01).sleep();
    print_event("the second subscriber is shared", publisher.statistics().shared_subscribers == 2);
  }
  publish(publisher, 0, 10);
  let_go_and_end();
}

void run(ros::NodeHandle& node, const std::string& scene) {
  if (scene == "queued") queued(node);
  if (scene == "alone") alone(node);
  if (scene == "away") away(node);
}

}  // namespace
}  // namespace tzc_test

int main(int argc, char** argv) {
  ros::init(argc, argv, "locks");
  ros::NodeHandle node;
  ros::PollManager::instance()->addPollThreadListener(tzc_test::hold_poll_thread);
  tzc_test::run(node, ros::NodeHandle("~").param<std::string>("scene", ""));
}
