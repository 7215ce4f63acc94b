// SPDX-License-Identifier: BSD-3-Clause
/// A camera or its viewer, both through the image_transport and message_filters wrappers.
///
/// Private parameters: role (camera, viewer, busy_camera: large stock images by reference, and on another thread
/// something small on another topic; counts how often that began and ended while an image was published). Camera: count, subscribers (of each topic, waited for), stock
/// (messages), pointer (publish by pointer), attached (to publishers that other code
/// advertised), kept (publishers that stay image_transport's; plain: nothing attaches them), calls (likewise, with tzc::image_transport::publish). Viewer: plain (image_transport's own), transport (raw, compressed); its
/// lines tell which of its callbacks saw an image: "camera" (CameraSubscriber), "image" (Subscriber), "both"
/// (two topics synchronized by message_filters); kept (filters that stay what they are instead: "image" is image_transport's,
/// "second" message_filters').
#include <image_transport/subscriber_filter.h>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <ros/ros.h>
#include <tzc/direct_dispatch.h>
#include <tzc/image_transport.h>
#include <tzc/message_filters.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/CameraInfo.h>
#include <tzc/sensor_msgs/Image.h>

#include <algorithm>
#include <atomic>
#include <boost/bind/bind.hpp>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <thread>

#include "image_line.h"

namespace {

using sensor_msgs::CameraInfoConstPtr;
using sensor_msgs::ImageConstPtr;

void print_copied_bytes(std::uint64_t bytes) {
  std::printf("{\"copied_bytes\": %llu}\n", (unsigned long long)bytes);
  std::fflush(stdout);
}

void print(const char* callback, const sensor_msgs::Image& image) {
  tzc_test::print_image(image, std::string("\"callback\": \"") + callback + "\", ");
}

void print_both(const ImageConstPtr& one, const ImageConstPtr&) {
  print("both", *one);
}

/// As code has it that never defines the constant: whoever takes it by reference does not link.
struct Queue {
  static const int size = 100;
};

template <class Image>
class Camera {
 public:
  Camera(ros::NodeHandle& node, const ros::NodeHandle& options)
      : transport_(node), by_pointer_(options.param("pointer", false)) {
    if (options.param("attached", false)) {
      camera_ = tzc::image_transport::attach_publisher(transport_.advertiseCamera("image", 100));
      second_ = tzc::image_transport::attach_publisher(transport_.advertise("second", 100), 4000000);
    } else {
      camera_ = tzc::image_transport::advertiseCamera(transport_, "image", Queue::size);
      second_ = tzc::image_transport::advertise(transport_, "second", Queue::size);
    }
  }

  std::uint32_t subscribers() const {
    return std::min(camera_.getNumSubscribers(), second_.getNumSubscribers());
  }

  void publish(std::uint32_t number) {
    const auto image = make(number);
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
    info->header = image->header;
    if (by_pointer_)
      camera_.publish(image, info);
    else
      camera_.publish(*image, *info);
    if (by_pointer_)
      second_.publish(image);
    else
      second_.publish(*image);
  }

  void report() const {
    print_copied_bytes(camera_.statistics().copied_bytes + second_.statistics().copied_bytes);
  }

 private:
  boost::shared_ptr<tzc::sensor_msgs::Image> allocated(tzc::sensor_msgs::Image*) const {
    const auto image = boost::make_shared<tzc::sensor_msgs::Image>();
    camera_.allocate(*image);
    return image;
  }
  boost::shared_ptr<sensor_msgs::Image> allocated(sensor_msgs::Image*) const {
    return boost::make_shared<sensor_msgs::Image>();
  }
  boost::shared_ptr<Image> make(std::uint32_t number) const {
    const boost::shared_ptr<Image> image = allocated(static_cast<Image*>(nullptr));
    tzc_test::fill_image(*image, number, 64 * 64);
    image->height = image->width = image->step = 64;
    return image;
  }

  image_transport::ImageTransport transport_;
  tzc::image_transport::CameraPublisher camera_;
  tzc::image_transport::Publisher second_;
  const bool by_pointer_;
};

/// Its publishers stay image_transport's.
class KeptCamera {
 public:
  KeptCamera(ros::NodeHandle& node, const ros::NodeHandle& options)
      : transport_(node),
        camera_(transport_.advertiseCamera("image", 100)),
        second_(transport_.advertise("second", 100)),
        by_pointer_(options.param("pointer", false)) {
    if (options.param("plain", false)) return;
    camera_ = tzc::image_transport::attached(camera_);
    second_ = tzc::image_transport::attached(second_);
  }

  std::uint32_t subscribers() const {
    return std::min(camera_.getNumSubscribers(), second_.getNumSubscribers());
  }

  void publish(std::uint32_t number) const {
    const auto image = boost::make_shared<sensor_msgs::Image>();
    tzc_test::fill_image(*image, number, 256 * 256);
    image->height = image->width = image->step = 256;
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
    info->header = image->header;
    if (by_pointer_) {
      camera_.publish(image, info);
      second_.publish(image);
    } else {
      camera_.publish(*image, *info);
      second_.publish(*image);
    }
  }

  void report() const {}

 private:
  image_transport::ImageTransport transport_;
  image_transport::CameraPublisher camera_;
  image_transport::Publisher second_;
  const bool by_pointer_;
};

/// Its publishers stay, too, and its images are built in shared memory.
template <class Image>
class CallingCamera {
 public:
  CallingCamera(ros::NodeHandle& node, const ros::NodeHandle& options)
      : transport_(node),
        camera_(transport_.advertiseCamera("image", 100)),
        second_(transport_.advertise("second", 100)),
        by_pointer_(options.param("pointer", false)) {
    publish(std::numeric_limits<std::uint32_t>::max());  // the first call attaches
    copied_before_ = copied_bytes();
  }

  std::uint32_t subscribers() const {
    return std::min(camera_.getNumSubscribers(), second_.getNumSubscribers());
  }

  void publish(std::uint32_t number) const {
    const auto image = boost::make_shared<Image>();
    allocate(*image);
    tzc_test::fill_image(*image, number, 256 * 256);
    image->height = image->width = image->step = 256;
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
    info->header = image->header;
    if (by_pointer_) {
      tzc::image_transport::publish(camera_, image, info);
      tzc::image_transport::publish(second_, image);
    } else {
      if (number % 2 == 0)
        tzc::image_transport::publish(camera_, *image, *info);
      else
        tzc::image_transport::publish(camera_, *image, *info, ros::Time(image->header.stamp));
      tzc::image_transport::publish(second_, *image);
    }
  }

  void report() const { print_copied_bytes(copied_bytes() - copied_before_); }

 private:
  std::uint64_t copied_bytes() const {
    return tzc::image_transport::attach_publisher(camera_).statistics().copied_bytes +
           tzc::image_transport::attach_publisher(second_).statistics().copied_bytes;
  }
  static void allocate(tzc::sensor_msgs::Image& image) { tzc::allocate(image); }
  static void allocate(sensor_msgs::Image&) {}

  image_transport::ImageTransport transport_;
  image_transport::CameraPublisher camera_;
  image_transport::Publisher second_;
  const bool by_pointer_;
  std::uint64_t copied_before_ = 0;
};

template <class Kind>
void run_camera(ros::NodeHandle& node, const ros::NodeHandle& options) {
  Kind camera(node, options);
  const auto wanted = static_cast<std::uint32_t>(options.param("subscribers", 1));
  while (ros::ok() && camera.subscribers() < wanted) ros::WallDuration(0.01).sleep();
  ros::WallDuration(1.0).sleep();
  for (int number = 0; ros::ok() && number < options.param("count", 50); ++number) {
    camera.publish(static_cast<std::uint32_t>(number));
    ros::WallDuration(0.01).sleep();
  }
  ros::WallDuration(0.5).sleep();
  camera.report();
}

/// Publishes on a topic of its own for as long as it lives.
class Bystander {
 public:
  explicit Bystander(ros::NodeHandle& node)
      : publisher_(node.advertise<sensor_msgs::CameraInfo>("other", 1)), thread_([this] { run(); }) {}
  ~Bystander() {
    ends_ = true;
    thread_.join();
  }
  /// An image is being published, or not: odd or even.
  void step() { ++step_; }
  std::uint32_t published_meanwhile() const { return meanwhile_; }

 private:
  void run() {
    while (!ends_) {
      const std::uint32_t before = step_;
      publisher_.publish(sensor_msgs::CameraInfo());
      if (before % 2 == 1 && step_ == before) ++meanwhile_;
      ros::WallDuration(0.001).sleep();
    }
  }

  const ros::Publisher publisher_;
  std::atomic<bool> ends_{false};
  std::atomic<std::uint32_t> step_{0}, meanwhile_{0};
  std::thread thread_;
};

void run_busy_camera(ros::NodeHandle& node, const ros::NodeHandle& options) {
  image_transport::ImageTransport transport(node);
  const auto camera = tzc::image_transport::advertiseCamera(transport, "image", 100);
  const auto wanted = static_cast<std::uint32_t>(options.param("subscribers", 1));
  while (ros::ok() && camera.getNumSubscribers() < wanted) ros::WallDuration(0.01).sleep();
  ros::WallDuration(1.0).sleep();
  sensor_msgs::Image image;
  const std::uint32_t width = 3000, height = 2000;
  tzc_test::fill_image(image, 0, width * height);
  image.width = image.step = width;
  image.height = height;
  Bystander bystander(node);
  for (int number = 0; ros::ok() && number < 10; ++number) {
    bystander.step();
    camera.publish(image, sensor_msgs::CameraInfo());
    bystander.step();
    ros::WallDuration(0.01).sleep();
  }
  std::printf("{\"meanwhile\": %u}\n", bystander.published_meanwhile());
}

void run_plain_viewer(ros::NodeHandle& node) {
  image_transport::ImageTransport transport(node);
  const image_transport::CameraSubscriber camera = transport.subscribeCamera(
      "image", 100, [](const ImageConstPtr& image, const CameraInfoConstPtr&) { print("camera", *image); },
      ros::VoidPtr());
  const image_transport::Subscriber second = transport.subscribe(
      "second", 100, [](const ImageConstPtr& image) { print("image", *image); }, ros::VoidPtr());
  ros::spin();
}

void run_viewer(ros::NodeHandle& node, const ros::NodeHandle& options) {
  image_transport::ImageTransport transport(node);
  const image_transport::TransportHints hints(options.param<std::string>("transport", "raw"));
  const auto camera = tzc::image_transport::subscribeCamera(
      transport, "image", 100,
      [](const ImageConstPtr& image, const CameraInfoConstPtr&) { print("camera", *image); }, ros::VoidPtr(),
      hints);
  const auto second = tzc::image_transport::subscribe(
      transport, "second", 100, [](const ImageConstPtr& image) { print("image", *image); }, ros::VoidPtr(),
      hints);
  tzc::image_transport::SubscriberFilter first_filter(transport, "image", 100, hints);
  tzc::message_filters::Subscriber<sensor_msgs::Image> second_filter(node, "second", 100);
  typedef message_filters::sync_policies::ExactTime<sensor_msgs::Image, sensor_msgs::Image> Policy;
  message_filters::Synchronizer<Policy> synchronizer(Policy(100), first_filter, second_filter);
  synchronizer.registerCallback(boost::bind(&print_both, boost::placeholders::_1, boost::placeholders::_2));
  ros::spin();
}

/// What ported code does with filters that cannot become TZC's.
void run_kept_viewer(ros::NodeHandle& node, const ros::NodeHandle& options) {
  image_transport::ImageTransport transport(node);
  const image_transport::TransportHints hints(options.param<std::string>("transport", "raw"));
  image_transport::SubscriberFilter first;
  message_filters::Subscriber<sensor_msgs::Image> second;
  first.registerCallback([](const ImageConstPtr& image) { print("image", *image); });
  second.registerCallback([](const ImageConstPtr& image) { print("second", *image); });
  tzc::message_filters::subscribe(first, transport, "image", 100, hints);
  tzc::message_filters::subscribe(second, node, "second", 100);
  second.unsubscribe();
  second.subscribe();
  ros::spin();
}

}  // namespace

/// Linked, and never called.
ros::Subscriber temporaries_with_undefined_constants() {
  tzc::advertise<sensor_msgs::Image>(ros::NodeHandle(), "image", Queue::size);
  const ros::NodeHandle node;
  tzc::image_transport::advertise(image_transport::ImageTransport(node), "image", Queue::size);
  tzc::image_transport::advertiseCamera(image_transport::ImageTransport(node), "image", Queue::size);
  return tzc::subscribe_direct(node, "image", Queue::size,
                               boost::function<void(const ImageConstPtr&)>([](const ImageConstPtr&) {}));
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "camera");
  ros::NodeHandle node, options("~");
  const bool is_viewer = options.param<std::string>("role", "camera") == "viewer";
  if (is_viewer && options.param("plain", false))
    run_plain_viewer(node);
  else if (is_viewer && options.param("kept", false))
    run_kept_viewer(node, options);
  else if (is_viewer)
    run_viewer(node, options);
  else if (options.param<std::string>("role", "camera") == "busy_camera")
    run_busy_camera(node, options);
  else if (options.param("kept", false))
    run_camera<KeptCamera>(node, options);
  else if (options.param("calls", false) && options.param("stock", false))
    run_camera<CallingCamera<sensor_msgs::Image>>(node, options);
  else if (options.param("calls", false))
    run_camera<CallingCamera<tzc::sensor_msgs::Image>>(node, options);
  else if (options.param("stock", false))
    run_camera<Camera<sensor_msgs::Image>>(node, options);
  else
    run_camera<Camera<tzc::sensor_msgs::Image>>(node, options);
}
