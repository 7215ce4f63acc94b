// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/contenders.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <unistd.h>

#include <vector>

#include "roscpp/image_stamp.h"

namespace tzc {
namespace bench {
namespace {

constexpr std::uint32_t queue_size = 10;

void start_node(const Setup& setup, const std::string& role) {
  ros::M_string remappings;
  ros::init(remappings, "bench_" + role + std::to_string(::getpid()), ros::init_options::NoSigintHandler);
  (void)setup;
}

std::string topic_of(const Setup& setup) {
  std::string topic = "/" + setup.name;
  for (char& c : topic)
    if (c == '-') c = '_';
  return topic;
}

using Callback = boost::function<void(const ::sensor_msgs::ImageConstPtr&)>;

Callback recording(Recorder& recorder) {
  return [&recorder](const ::sensor_msgs::ImageConstPtr& image) { record(*image, recorder); };
}

/// Base of the contenders of several processes.
class NodeContender : public Contender {
 public:
  Daemon needs() const override { return Daemon::rosmaster; }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    start_node(setup, "subscriber");
    ros::NodeHandle node;
    const ros::Subscriber subscriber = subscribe_node(node, topic_of(setup), recording(recorder));
    recorder.ready();
    spin();
  }

 protected:
  virtual ros::Subscriber subscribe_node(ros::NodeHandle& node, const std::string& topic,
                                         const Callback& callback) = 0;
  virtual void spin() { ros::spin(); }
};

/// Publishes one message by reference, again and again.
std::function<void(std::uint64_t)> publish_by_reference(const ros::Publisher& publisher, const Setup& setup) {
  const auto image = std::make_shared<::sensor_msgs::Image>();
  image->data.resize(setup.size_bytes);
  return [publisher, image, setup](std::uint64_t index) {
    fill_and_stamp(*image, Span(setup, index));
    publisher.publish(*image);
  };
}

class TcprosContender final : public NodeContender {
 public:
  const char* name() const override { return "tcpros"; }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    start_node(setup, "publisher");
    const auto node = std::make_shared<ros::NodeHandle>();
    const ros::Publisher publisher = node->advertise<::sensor_msgs::Image>(topic_of(setup), queue_size);
    if (!wait_until(setup, [&] { return publisher.getNumSubscribers() >= setup.subscribers; })) return {};
    return [node, publish = publish_by_reference(publisher, setup)](std::uint64_t index) { publish(index); };
  }

 protected:
  ros::Subscriber subscribe_node(ros::NodeHandle& node, const std::string& topic,
                                 const Callback& callback) override {
    return node.subscribe<::sensor_msgs::Image>(topic, queue_size, callback, ros::VoidConstPtr(),
                                                ros::TransportHints().tcpNoDelay());
  }
};

class AttachedContender final : public NodeContender {
 public:
  const char* name() const override { return "tzc-attached"; }
  std::size_t memory_bytes(const Setup& setup) const override { return shared_memory_bytes(setup, false); }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    start_node(setup, "publisher");
    const auto node = std::make_shared<ros::NodeHandle>();
    const ros::Publisher publisher =
        attached<::sensor_msgs::Image>(node->advertise<::sensor_msgs::Image>(topic_of(setup), queue_size));
    {
      const Publisher topic = attach_publisher<::sensor_msgs::Image>(publisher);
      if (!wait_until(setup, [&] { return topic.statistics().shared_subscribers >= setup.subscribers; }))
        return {};
    }
    return [node, publish = publish_by_reference(publisher, setup)](std::uint64_t index) { publish(index); };
  }

 protected:
  ros::Subscriber subscribe_node(ros::NodeHandle& node, const std::string& topic,
                                 const Callback& callback) override {
    return tzc::subscribe<::sensor_msgs::Image>(node, topic, queue_size, callback);
  }
};

class TzcNodeContender final : public NodeContender {
 public:
  enum class Dispatch { direct, queue, spin };
  explicit TzcNodeContender(Dispatch dispatch) : dispatch_(dispatch) {}
  const char* name() const override {
    if (dispatch_ == Dispatch::direct) return "tzc-direct";
    return dispatch_ == Dispatch::queue ? "tzc-queue" : "tzc-spin";
  }
  std::size_t memory_bytes(const Setup& setup) const override { return shared_memory_bytes(setup, false); }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    start_node(setup, "publisher");
    const auto node = std::make_shared<ros::NodeHandle>();
    Publisher publisher = advertise<sensor_msgs::Image>(*node, topic_of(setup), queue_size, 0);
    if (!wait_until(setup, [&] { return publisher.statistics().shared_subscribers >= setup.subscribers; }))
      return {};
    return [node, publisher, setup](std::uint64_t index) {
      const Span span(setup, index);
      sensor_msgs::Image image;
      publisher.allocate(image);
      image.data.resize(setup.size_bytes, uninitialized);
      fill_and_stamp(image, span);
      publisher.publish(image);
    };
  }

 protected:
  ros::Subscriber subscribe_node(ros::NodeHandle& node, const std::string& topic,
                                 const Callback& callback) override {
    return dispatch_ == Dispatch::direct
               ? subscribe_direct<::sensor_msgs::Image>(node, topic, queue_size, callback)
               : tzc::subscribe<::sensor_msgs::Image>(node, topic, queue_size, callback);
  }
  void spin() override { dispatch_ == Dispatch::spin ? tzc::spin() : ros::spin(); }

 private:
  const Dispatch dispatch_;
};

class IntraprocessContender final : public Contender {
 public:
  const char* name() const override { return "intraprocess"; }
  Daemon needs() const override { return Daemon::rosmaster; }
  bool in_one_process() const override { return true; }

  void subscribe_here(const Setup& setup, std::vector<Recorder>& recorders) override {
    start_node(setup, "nodelets");
    for (Recorder& recorder : recorders) {
      auto inside = std::make_shared<Inside>();
      inside->node.setCallbackQueue(&inside->queue);
      inside->subscriber =
          inside->node.subscribe<::sensor_msgs::Image>(topic_of(setup), queue_size, recording(recorder));
      inside->spinner.start();
      inside_.push_back(inside);
      recorder.ready();
    }
  }

  void subscribe(const Setup&, std::size_t, Recorder&) override {}

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    const auto node = std::make_shared<ros::NodeHandle>();
    ros::Publisher publisher = node->advertise<::sensor_msgs::Image>(topic_of(setup), queue_size);
    // One intraprocess link serves all of them.
    if (!wait_until(setup, [&] { return publisher.getNumSubscribers() >= 1; })) return {};
    return [node, publisher, setup](std::uint64_t index) {
      const Span span(setup, index);
      const auto image = boost::make_shared<::sensor_msgs::Image>();
      image->data.resize(setup.size_bytes);
      fill_and_stamp(*image, span);
      publisher.publish(image);
    };
  }

 private:
  /// A nodelet's worth of subscriber: its own queue and thread.
  struct Inside {
    ros::NodeHandle node;
    ros::CallbackQueue queue;
    ros::Subscriber subscriber;
    ros::AsyncSpinner spinner{1, &queue};
  };
  std::vector<std::shared_ptr<Inside>> inside_;
};

}  // namespace

std::unique_ptr<Contender> tcpros_contender() {
  return std::make_unique<TcprosContender>();
}
std::unique_ptr<Contender> tzc_attached_contender() {
  return std::make_unique<AttachedContender>();
}
std::unique_ptr<Contender> tzc_queue_contender() {
  return std::make_unique<TzcNodeContender>(TzcNodeContender::Dispatch::queue);
}
std::unique_ptr<Contender> tzc_spin_contender() {
  return std::make_unique<TzcNodeContender>(TzcNodeContender::Dispatch::spin);
}
std::unique_ptr<Contender> tzc_direct_contender() {
  return std::make_unique<TzcNodeContender>(TzcNodeContender::Dispatch::direct);
}
std::unique_ptr<Contender> intraprocess_contender() {
  return std::make_unique<IntraprocessContender>();
}

std::string roscpp_version() {
  return std::to_string(ROS_VERSION_MAJOR) + "." + std::to_string(ROS_VERSION_MINOR) + "." +
         std::to_string(ROS_VERSION_PATCH);
}

}  // namespace bench
}  // namespace tzc
