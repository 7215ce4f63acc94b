// SPDX-License-Identifier: BSD-3-Clause
/// Runs each of the transport's races in the order of steps that once went wrong. Prints what happened as lines of
/// JSON ("event"); a subscriber prints its images, too.
///
/// Private parameters: pid (of the other side), queue (by_reference, busy_queue), race, one of
///   by_reference  a publisher: a message goes by reference, since no subscriber takes pointers, while a subscriber
///                 moves over
///   late_header   a publisher: the subscriber is offered shared memory before its TCPROS header is written
///   slow_reader   a subscriber: the last TCPROS message is read and not delivered yet when the first shared
///                 one arrives
///   busy_queue    a publisher: a subscriber goes back to TCPROS while roscpp's queue is full of what it has
///                 already
///   silent        a publisher: the subscriber (pid) is stopped when it is called with the offer, and goes on
///                 when the call is given up
///   two_at_once   a direct subscriber: a message of another publisher arrives while the callback for the first
///                 one runs
///   slow_move     a publisher: the thread that moves the subscriber is held for longer than the subscriber waits
///   late_attach   a subscriber: it attaches when it is connected, the publisher (pid) is stopped when it is
///                 asked for an offer, and goes on when the call is given up
///   cut_short     a subscriber: its first channel ends before it is noted
///   unsubscribe   a subscriber with two threads of tzc::AsyncSpinner: it unsubscribes while its callback runs past the queue
///   concurrent    a direct subscriber whose callbacks may run at once: another thread unsubscribes while one of them runs
///   no_memory     a subscriber with tzc::spin: there is no memory for its first shared message
///   exit          a subscriber: the program exits while its reader thread has a message for a queue that exit() destroys
///   planted       a subscriber with a data race of its own, for ThreadSanitizer to find
#include <ros/poll_manager.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <signal.h>
#include <sys/socket.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "dying_queue.h"
#include "image_line.h"
#include "race.h"
#include "slow_queue.h"
#include "stop.h"
#include "sync_point/sync_point.h"

namespace {

using tzc_test::eventually;
using tzc_test::gate;
using tzc_test::hold_poll_thread;
using tzc_test::hold_poll_thread_now;
using tzc_test::let_go_and_end;
using tzc_test::print_event;
using tzc_test::publish;

// The service thread comes to the move while the main thread has decided for TCPROS and not published yet. It
// must not get through in between: the message would wait in roscpp's queue for a link that has moved, and be
// overtaken.
void by_reference(ros::NodeHandle& node, std::uint32_t queue_size) {
  tzc::sync_point_hook = [](const char* step) {
    const std::string name = step;
    if (name == "move: begins") {
      gate().tell("moving");
      gate().wait_for({"chosen"});
    } else if (name == "move: parked") {
      gate().tell("parked");
    } else if (name == "publish: by reference" && gate().happened("moving") && !gate().happened("chosen")) {
      gate().tell("chosen");
      print_event("moved in between", gate().wait_for({"parked"}, std::chrono::milliseconds(500)));
    }
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", queue_size);
  gate().wait_for({"moving"});
  hold_poll_thread_now();
  publish(publisher, 0, 1);
  print_event("parked", gate().wait_for({"parked"}));
  publish(publisher, 1, 10);
  let_go_and_end();
}

/// Holds the thread that adds a callback, which is the one that adds a subscriber.
class HoldingQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr&, std::uint64_t) override {
    gate().tell("connecting");
    gate().wait_for({"let go"});
  }
  void removeByID(std::uint64_t) override {}
};

// The poll thread is held after it has told of the subscriber and before it writes the TCPROS header.
void late_header(ros::NodeHandle& node) {
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  HoldingQueue queue;
  ros::AdvertiseOptions options = ros::AdvertiseOptions::create<sensor_msgs::Image>(
      "image", 100, [](const ros::SingleSubscriberPublisher&) {}, ros::SubscriberStatusCallback(),
      ros::VoidConstPtr(), &queue);
  const ros::Publisher second = node.advertise(options);
  print_event("connecting", gate().wait_for({"connecting"}));
  print_event("parked", eventually([&] { return publisher.statistics().shared_subscribers == 1; }));
  gate().tell("let go");
  publish(publisher, 0, 10);
  let_go_and_end();
}

// Messages are in the channel, and as bytes in roscpp's queue for a plain subscriber, when the channel
// breaks: one more segment than a connection takes.
void busy_queue(ros::NodeHandle& node, std::uint32_t queue_size) {
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) == "move: returned") gate().tell("returned");
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", queue_size);
  eventually(
      [&] { return publisher.getNumSubscribers() == 2 && publisher.statistics().shared_subscribers == 1; });
  ros::WallDuration(0.5).sleep();  // the move's end; what is published before it would only be less of a test
  publish(publisher, 0, 10);
  hold_poll_thread_now();
  std::vector<tzc::sensor_msgs::Image> hoard(300);
  std::uint32_t number = 10;
  for (tzc::sensor_msgs::Image& image : hoard) {
    tzc::MemoryOptions memory;
    memory.size = 65536;
    tzc::message::allocate(image, std::shared_ptr<tzc::MemorySource>(*tzc::SegmentMemory::create(memory)));
    tzc_test::fill_image(image, number++, 20000);
    publisher.publish(image);
  }
  print_event("returned", gate().wait_for({"returned"}, std::chrono::seconds(30)));
  publish(publisher, 310, 330);
  let_go_and_end();
}

pid_t other_pid = 0;

void silent(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    const std::string name = step;
    if (name == "offer: calls" && !gate().happened("called")) {
      tzc_test::stop(other_pid);
      gate().tell("called");
    } else if (name == "offer: waits") {
      gate().tell("unanswered");
    }
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  print_event("unanswered", gate().wait_for({"unanswered"}));
  kill(other_pid, SIGCONT);
  print_event("parked", eventually([&] { return publisher.statistics().shared_subscribers == 1; }));
  publish(publisher, 0, 10);
  let_go_and_end();
}

// A publisher that is busy under roscpp's locks. The subscriber waits for its welcome for two seconds.
void slow_move(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    const std::string name = step;
    if (name == "move: begins") gate().wait_for({"never"}, std::chrono::milliseconds(3000));
    if (name == "move: parked") gate().tell("parked");
    if (name == "move: returned") gate().tell("returned");
  };
  const tzc::Publisher publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  print_event("parked", gate().wait_for({"parked"}));
  publish(publisher, 0, 10);
  print_event("returned", gate().wait_for({"returned"}, std::chrono::milliseconds(500)));
}

// With a publisher by_reference: its first message surely comes over TCPROS, after this node agreed to move.
void slow_reader(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    const std::string name = step;
    if (name == "switch: waits for the reader") gate().tell("waiting");
    if (name == "switch: the reader is done") gate().tell("done");
  };
  static auto* const queue = new tzc_test::SlowQueue([] { gate().wait_for({"let in"}); });
  node.setCallbackQueue(queue);
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> print =
      [](const sensor_msgs::ImageConstPtr& image) { tzc_test::print_image(*image); };
  const ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", 100, print);
  print_event("waited", gate().wait_for({"waiting"}));
  print_event("went on at once", gate().wait_for({"done"}, std::chrono::milliseconds(500)));
  gate().tell("let in");
  while (ros::ok()) {
    queue->call_available();
    ros::WallDuration(0.01).sleep();
  }
}

// The second message cannot be called back yet, and nothing else will come that could take it along.
void two_at_once(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) == "direct: waits for a callback") gate().tell("second");
  };
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> print =
      [](const sensor_msgs::ImageConstPtr& image) {
        print_event("second came meanwhile", gate().wait_for({"second"}));
        tzc_test::print_image(*image);
      };
  const ros::Subscriber subscriber = tzc::subscribe_direct<sensor_msgs::Image>(node, "image", 100, print);
  ros::spin();
}

void late_attach(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    const std::string name = step;
    if (name == "request: calls" && !gate().happened("called")) {
      tzc_test::stop(other_pid);
      gate().tell("called");
    } else if (name == "request: waits") {
      kill(other_pid, SIGCONT);
    }
  };
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> print =
      [](const sensor_msgs::ImageConstPtr& image) {
        gate().tell("connected");
        tzc_test::print_image(*image);
      };
  const ros::Subscriber subscriber = node.subscribe<sensor_msgs::Image>("image", 100, print);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  gate().wait_for({"connected"});
  tzc::attach<sensor_msgs::Image>(node, "image");
  ros::waitForShutdown();
}

/// Ends the channels of this process, as a peer that breaks off.
void cut_channels() {
  for (int fd = 3; fd < 1024; ++fd) {
    int type = 0;
    socklen_t size = sizeof type;
    if (getsockopt(fd, SOL_SOCKET, SO_TYPE, &type, &size) == 0 && type == SOCK_SEQPACKET)
      shutdown(fd, SHUT_RDWR);
  }
}

/// A subscriber returns to TCPROS while messages by pointer wait that were left to their bytes, so as not to overtake one by reference.
void left_to_bytes(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) == "move: returned") gate().tell("returned");
  };
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> local =
      [](const sensor_msgs::ImageConstPtr&) {};
  const ros::Subscriber subscriber = node.subscribe<sensor_msgs::Image>("image", 100, local);
  const tzc::Publisher attached = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  const ros::Publisher plain = node.advertise<sensor_msgs::Image>("image", 100);
  eventually([&] { return plain.getNumSubscribers() == 2 && attached.statistics().shared_subscribers == 1; });
  ros::WallDuration(0.5).sleep();  // the move's end
  const auto make = [](std::uint32_t number) {
    const auto image = boost::make_shared<sensor_msgs::Image>();
    tzc_test::fill_image(*image, number, 20000);
    return image;
  };
  hold_poll_thread_now();
  plain.publish(*make(0));
  for (std::uint32_t number = 1; number < 5; ++number) plain.publish(make(number));
  cut_channels();
  print_event("returned", gate().wait_for({"returned"}, std::chrono::seconds(30)));
  let_go_and_end();
}

void cut_short(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) != "accept: connected" || gate().happened("cut")) return;
    cut_channels();
    gate().tell("cut");
    gate().wait_for({"never"}, std::chrono::milliseconds(1000));
  };
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> print =
      [](const sensor_msgs::ImageConstPtr& image) { tzc_test::print_image(*image); };
  const ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", 100, print);
  std::thread([] { print_event("cut", gate().wait_for({"cut"})); }).detach();
  ros::spin();
}

// As behind roscpp's queue, the thread that unsubscribes waits for the callback's end.
void unsubscribe(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) == "guest: calls") gate().tell("past the queue");
  };
  static std::atomic<bool> inside{false};
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> print =
      [](const sensor_msgs::ImageConstPtr& image) {
        if (!gate().happened("past the queue")) return;  // the first ones may come over TCPROS
        inside = true;
        gate().tell("called");
        gate().wait_for({"never"}, std::chrono::milliseconds(500));
        tzc_test::print_image(*image);
        inside = false;
      };
  ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", 100, print);
  tzc::AsyncSpinner spinner(2);
  spinner.start();
  gate().wait_for({"called"});
  subscriber.shutdown();
  print_event("ended before", !inside);
}

// As with callbacks that take turns.
void concurrent(ros::NodeHandle& node) {
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> print =
      [](const sensor_msgs::ImageConstPtr& image) {
        gate().tell("called");
        gate().wait_for({"let out"});
        tzc_test::print_image(*image);
      };
  ros::SubscribeOptions options = ros::SubscribeOptions::create<sensor_msgs::Image>(
      "image", 100, print, ros::VoidConstPtr(), tzc::direct_dispatch_queue());
  options.allow_concurrent_callbacks = true;
  ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, options);
  gate().wait_for({"called"});
  std::thread other([&subscriber] {
    subscriber.shutdown();
    gate().tell("ended");
  });
  print_event("ended before", gate().wait_for({"ended"}, std::chrono::milliseconds(500)));
  gate().tell("let out");
  print_event("ended afterwards", gate().wait_for({"ended"}));
  other.join();
}

void no_memory(ros::NodeHandle& node) {
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) != "guest: decodes" || gate().happened("refused")) return;
    gate().tell("refused");
    throw std::bad_alloc();
  };
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> print =
      [](const sensor_msgs::ImageConstPtr& image) {
        if (gate().happened("refused")) tzc_test::print_image(*image);
      };
  const ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", 100, print);
  tzc::spin();
}

void exits(ros::NodeHandle& node) {
  static tzc_test::DyingQueue queue;
  tzc::sync_point_hook = [](const char* step) {
    if (std::string(step) != "take: has the subscription" || gate().happened("taking")) return;
    gate().tell("taking");
    gate().wait_for({"never"}, std::chrono::milliseconds(200));
  };
  // Never destroyed, as those of many programs that end by exit().
  auto& own = *new ros::NodeHandle(node);
  own.setCallbackQueue(&queue);
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> nothing =
      [](const sensor_msgs::ImageConstPtr&) {};
  new ros::Subscriber(tzc::subscribe<sensor_msgs::Image>(own, "image", 100, nothing));
  print_event("taking", gate().wait_for({"taking"}));
  std::exit(0);
}

int planted_counter = 0;

// The transport's reader thread writes what the main thread reads.
void planted(ros::NodeHandle& node) {
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> count =
      [](const sensor_msgs::ImageConstPtr& image) {
        ++planted_counter;
        tzc_test::print_image(*image);
      };
  const ros::Subscriber subscriber = tzc::subscribe_direct<sensor_msgs::Image>(node, "image", 100, count);
  eventually([] { return planted_counter >= 20; });
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "racer");
  ros::NodeHandle node, options("~");
  ros::PollManager::instance()->addPollThreadListener(hold_poll_thread);
  const std::string race = options.param<std::string>("race", "");
  if (race == "by_reference") by_reference(node, options.param("queue", 100));
  if (race == "late_header") late_header(node);
  other_pid = options.param("pid", 0);
  if (race == "silent") silent(node);
  if (race == "busy_queue") busy_queue(node, options.param("queue", 1000));
  if (race == "slow_reader") slow_reader(node);
  if (race == "two_at_once") two_at_once(node);
  if (race == "slow_move") slow_move(node);
  if (race == "late_attach") late_attach(node);
  if (race == "left_to_bytes") left_to_bytes(node);
  if (race == "cut_short") cut_short(node);
  if (race == "unsubscribe") unsubscribe(node);
  if (race == "concurrent") concurrent(node);
  if (race == "no_memory") no_memory(node);
  if (race == "exit") exits(node);
  if (race == "planted") planted(node);
  tzc::sync_point_hook = nullptr;
}
