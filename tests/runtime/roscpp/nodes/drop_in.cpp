// SPDX-License-Identifier: BSD-3-Clause
/// What a node can see of its publisher, as lines of JSON: the same for ros::Publisher and tzc::Publisher.
///
/// Private parameter: plain (ros::Publisher).
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <map>
#include <string>
#include <vector>

namespace {

void say(const std::string& what, const std::string& value) {
  std::printf("{\"what\": \"%s\", \"value\": \"%s\"}\n", what.c_str(), value.c_str());
  std::fflush(stdout);
}
void say(const std::string& what, long value) {
  say(what, std::to_string(value));
}

bool is_advertised(const ros::NodeHandle& node, const std::string& topic) {
  ros::V_string topics;
  ros::this_node::getAdvertisedTopics(topics);
  return std::count(topics.begin(), topics.end(), node.resolveName(topic)) != 0;
}

struct Plain {
  typedef ros::Publisher Publisher;
  template <class M>
  static Publisher advertise(ros::NodeHandle& node, const std::string& topic, bool latch = false) {
    return node.advertise<M>(topic, 10, latch);
  }
  template <class M>
  static Publisher advertise(ros::NodeHandle& node, const std::string& topic,
                             const ros::SubscriberStatusCallback& came,
                             const ros::SubscriberStatusCallback& left, const ros::VoidConstPtr& tracked,
                             bool latch = false) {
    return node.advertise<M>(topic, 10, came, left, tracked, latch);
  }
  static Publisher advertise_by(ros::NodeHandle& node, ros::AdvertiseOptions& options) {
    return node.advertise(options);
  }
  static bool has_all_it_needs(const Publisher& publisher) { return publisher != nullptr; }
};

struct Ours {
  typedef tzc::Publisher Publisher;
  template <class M, class... Args>
  static Publisher advertise(ros::NodeHandle& node, const std::string& topic, Args&&... args) {
    return tzc::advertise<M>(node, topic, 10, std::forward<Args>(args)...);
  }
  static Publisher advertise_by(ros::NodeHandle& node, ros::AdvertiseOptions& options) {
    return tzc::advertise<sensor_msgs::Image>(node, options);
  }
  static bool has_all_it_needs(const Publisher& publisher) { return publisher.memory() != nullptr; }
};

template <class Kind>
class Trial {
 public:
  void run() {
    an_empty_one();
    copies();
    moved();
    several();
    the_last_copy();
    a_node_handle_that_shuts_down();
    conflicts();
    status_callbacks();
    a_tracked_object();
    options();
  }

 private:
  typedef typename Kind::Publisher Publisher;
  typedef sensor_msgs::Image Image;

  static void describe(const std::string& what, const Publisher& publisher) {
    say(what + ": valid", publisher ? 1 : 0);
    say(what + ": topic", publisher.getTopic());
    if (publisher) say(what + ": latched", publisher.isLatched());  // else roscpp ends the process
    say(what + ": subscribers", publisher.getNumSubscribers());
  }

  void an_empty_one() {
    Publisher empty;
    describe("empty", empty);
    say("empty ones are equal", empty == Publisher() && !(empty != Publisher()) && !(empty < Publisher()));
    empty.shutdown();
    describe("empty, shut down", empty);
  }

  void copies() {
    Publisher first = Kind::template advertise<Image>(node_, "copies", true);
    Publisher copy = first, assigned;
    assigned = copy;
    describe("a copy", assigned);
    say("copies are equal", first == copy && copy == assigned && !(first != copy) && !(first < copy));
    say("not null", first != nullptr && static_cast<void*>(first) != nullptr);
    copy.shutdown();
    describe("the original of one that was shut down", first);
    describe("the copy that was shut down", copy);
    say("still advertised", is_advertised(node_, "copies"));
#ifdef NDEBUG  // otherwise both end the process
    first.publish(Image());
    first.publish(boost::make_shared<Image>());
#endif
    first.shutdown();
  }

  /// ros::Publisher copies where it could move.
  void moved() {
    Publisher first = Kind::template advertise<Image>(node_, "moved");
    Publisher second(static_cast<Publisher&&>(first)), third;
    third = static_cast<Publisher&&>(second);
    describe("one that was moved from", first);
    say("each is whole",
        Kind::has_all_it_needs(first) && Kind::has_all_it_needs(second) && Kind::has_all_it_needs(third));
    third.shutdown();
    describe("one whose copy was shut down", first);
  }

  void several() {
    const Publisher one = Kind::template advertise<Image>(node_, "one");
    const Publisher again = Kind::template advertise<Image>(node_, "one");
    const Publisher other = Kind::template advertise<Image>(node_, "other");
    say("one topic twice", one != again && one != other && !(one == again));
    say("ordered", (one < other) != (other < one) && (one < again) != (again < one));
    std::map<Publisher, int> numbers;
    numbers[one] = 1, numbers[other] = 2, numbers[Publisher()] = 3;
    say("in a map", numbers.at(one) * 100 + numbers.at(other) * 10 + static_cast<long>(numbers.size()));
  }

  void the_last_copy() {
    std::vector<Publisher> copies;
    {
      ros::NodeHandle gone;
      copies.assign(2, Kind::template advertise<Image>(gone, "last"));
    }
    copies.pop_back();
    say("advertised by one copy", is_advertised(node_, "last"));
    copies.clear();
    say("advertised by none", is_advertised(node_, "last"));
    Publisher replaced = Kind::template advertise<Image>(node_, "before");
    replaced = Kind::template advertise<Image>(node_, "after");
    say("replaced", 10 * is_advertised(node_, "before") + is_advertised(node_, "after"));
  }

  void a_node_handle_that_shuts_down() {
    ros::NodeHandle node("below");
    const Publisher publisher = Kind::template advertise<Image>(node, "handle");
    describe("before its handle shuts down", publisher);
    node.shutdown();
    say("valid afterwards", publisher ? 1 : 0);
    say("advertised afterwards", is_advertised(node_, "below/handle"));
  }

  void conflicts() {
    const Publisher image = Kind::template advertise<Image>(node_, "conflict");
    const Publisher string = Kind::template advertise<std_msgs::String>(node_, "conflict");
    say("another type on one topic", string ? 1 : 0);
    try {
      Kind::template advertise<Image>(node_, "not a name");
      say("a bad name", "is accepted");
    } catch (const ros::InvalidNameException&) {
      say("a bad name", "InvalidNameException");
    }
  }

  /// Called on the node handle's own queue and nowhere else, for a subscriber of this process.
  void status_callbacks() {
    ros::CallbackQueue queue;
    ros::NodeHandle node;
    node.setCallbackQueue(&queue);
    int came = 0, left = 0;
    const Publisher publisher = Kind::template advertise<Image>(
        node, "status", [&](const ros::SingleSubscriberPublisher&) { ++came; },
        [&](const ros::SingleSubscriberPublisher&) { ++left; }, ros::VoidConstPtr());
    ros::Subscriber subscriber = node_.subscribe<Image>(
        "status", 1, boost::function<void(const sensor_msgs::ImageConstPtr&)>([](const auto&) {}));
    await([&] { return publisher.getNumSubscribers() == 1; });
    say("called before its queue is", came);
    await([&] { return queue.callAvailable(), came == 1; });
    subscriber.shutdown();
    await([&] { return queue.callAvailable(), left == 1; });
    say("came and left", 10 * came + left);
    say("subscribers left", publisher.getNumSubscribers());
  }

  void a_tracked_object() {
    ros::CallbackQueue queue;
    ros::NodeHandle node;
    node.setCallbackQueue(&queue);
    int came = 0;
    boost::shared_ptr<int> tracked = boost::make_shared<int>(0);
    const Publisher publisher = Kind::template advertise<Image>(
        node, "tracked", [&](const ros::SingleSubscriberPublisher&) { ++came; },
        ros::SubscriberStatusCallback(), tracked, true);
    describe("with a tracked object", publisher);
    tracked.reset();
    const ros::Subscriber subscriber = node_.subscribe<Image>(
        "tracked", 1, boost::function<void(const sensor_msgs::ImageConstPtr&)>([](const auto&) {}));
    await([&] { return publisher.getNumSubscribers() == 1; });
    queue.callAvailable(ros::WallDuration(0.2));
    say("called for a tracked object that is gone", came);
  }

  void options() {
    ros::CallbackQueue queue;
    int came = 0;
    ros::AdvertiseOptions options = ros::AdvertiseOptions::create<Image>(
        "options", 5, [&](const ros::SingleSubscriberPublisher&) { ++came; }, ros::SubscriberStatusCallback(),
        ros::VoidConstPtr(), &queue);
    options.latch = true;
    const Publisher publisher = Kind::advertise_by(node_, options);
    describe("by options", publisher);
    say("the options' name", options.topic);
    const ros::Subscriber subscriber = node_.subscribe<Image>(
        "options", 1, boost::function<void(const sensor_msgs::ImageConstPtr&)>([](const auto&) {}));
    await([&] { return queue.callAvailable(), came == 1; });
    say("called by the options' queue", came);
  }

  /// False, and said so, when it does not happen within ten seconds.
  template <class Condition>
  static void await(Condition condition) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(10);
    while (!condition()) {
      if (ros::WallTime::now() > end) return say("in vain", "waited");
      ros::spinOnce();
      ros::WallDuration(0.002).sleep();
    }
  }

  ros::NodeHandle node_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "drop_in");
  ros::NodeHandle options("~");
  if (options.param("plain", false))
    Trial<Plain>().run();
  else
    Trial<Ours>().run();
}
