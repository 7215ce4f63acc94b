// SPDX-License-Identifier: BSD-3-Clause
/// Publishes images whose bytes follow from their number, in one of the ways a node may publish.
///
/// Private parameters: mode (twin, twin_pointer, stranger: twins that another publisher allocates, which is not advertised, of_node: that the node allocates,
/// stock, stock_pointer, plain, handover: a twin's publisher and a plain one, the former ends after half of the images; mixed: every other image as a ShapeShifter; attached: twins, to the topic that
/// others advertised; attached_wrong: stock images, attached for another type; foreign, foreign_pointer: stock images, with a
/// publisher that stays roscpp's; foreign_twin; foreign_handover: two such, the first of which ends after half of the images;
/// foreign_again: it ends then, and another one advertises the topic anew; plain_alternating, foreign_attached_alternating: every other image by pointer), beside (the
/// node has a callback of its own, too), half (the images of the first half), give_up (whether it ends the topic when it has published all), fresh (every so many images lie in a segment
/// of their own), topics (several, separated by blanks), first (number), count, rate (Hz), bytes, latch, rows, encoding (of
/// an image: mono8, bgr8), subscribers (wait for so many), shared (and for so many of them on shared memory), settle (seconds
/// to wait then), echo (a topic: the next image goes out when that one's number has come back on it, or when the image was
/// dropped), echoes (from so many nodes), ahead (or when the number of the image so many before it has), pause (after so many
/// images it waits for SIGUSR2), linger (seconds to stay), queue, memory, policy (worst_effort). SIGUSR1 ends a count that
/// has no end. Says when it has published all.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/UInt8MultiArray.h>
#include <topic_tools/shape_shifter.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

class Talker {
 public:
  Talker(ros::NodeHandle node, ros::NodeHandle options, const std::string& topic)
      : mode_(options.param<std::string>("mode", "twin")),
        bytes_(options.param("bytes", 100000)),
        rows_(static_cast<std::uint32_t>(options.param("rows", 1))),
        encoding_(options.param<std::string>("encoding", "mono8")) {
    const int queue = options.param("queue", 10);
    const bool latch = options.param("latch", false);
    const int memory = options.param("memory", 0);
    fresh_ = static_cast<std::uint32_t>(options.param("fresh", 0));
    half_ = static_cast<std::uint32_t>(options.param("half", options.param("count", 100) / 2));
    const bool attached = mode_ == "attached" || mode_ == "attached_wrong";
    is_foreign_ = mode_.compare(0, 7, "foreign") == 0;
    is_plain_ = mode_.compare(0, 5, "plain") == 0;
    alternates_ = mode_.find("alternating") != std::string::npos;
    if (options.param("beside", false)) beside_ = node.subscribe(topic, 1, see);
    if (is_plain_ || mode_ == "handover" || attached || is_foreign_)
      plain_ = node.advertise<sensor_msgs::Image>(topic, queue, latch);
    if (mode_.compare(0, 16, "foreign_attached") == 0) plain_ = tzc::attached<sensor_msgs::Image>(plain_);
    if (is_foreign_)
      advertise_again_ = [=]() mutable { return node.advertise<sensor_msgs::Image>(topic, queue, latch); };
    if (mode_ == "foreign_handover" || mode_ == "foreign_attached_handover") second_ = advertise_again_();
    if (mode_ == "attached") shared_ = tzc::attach_publisher<tzc::sensor_msgs::Image>(plain_, memory);
    if (mode_ == "attached_wrong") shared_ = tzc::attach_publisher<std_msgs::UInt8MultiArray>(plain_, memory);
    if (!is_plain_ && !attached && !is_foreign_)
      shared_ =
          tzc::advertise<tzc::sensor_msgs::Image>(node, topic, queue, publisher_options(options), latch);
  }

  void publish(std::uint32_t number) {
    if (mode_ == "twin" || mode_ == "twin_pointer" || mode_ == "stranger" || mode_ == "of_node" ||
        mode_ == "attached" || (mode_ == "handover" && number < half_))
      return publish_twin(number);
    if (mode_ == "mixed") return number % 2 == 0 ? publish_as_bytes(number) : publish_twin(number);
    if (mode_ == "handover" && number == half_) shared_.shutdown();
    if (is_foreign_ && number == half_) change_publisher();
    if (mode_ == "foreign_twin") return publish_foreign_twin(number);
    const auto image = boost::make_shared<sensor_msgs::Image>();
    fill(*image, number);
    if (alternates_) return number % 2 == 0 ? plain_.publish(*image) : plain_.publish(image);
    if (mode_ == "foreign_attached" || mode_ == "foreign_attached_handover") return plain_.publish(*image);
    if (mode_ == "foreign_attached_pointer") return plain_.publish(image);
    if (mode_ == "foreign_pointer") return tzc::publish(plain_, image);
    if (is_foreign_) return tzc::publish(plain_, *image);
    if (mode_ == "plain" || mode_ == "handover") return plain_.publish(*image);
    if (mode_ == "stock_pointer") return shared_.publish(image);
    shared_.publish(*image);
  }

  std::uint32_t subscribers() const {
    const bool by_plain = is_plain_ || mode_ == "handover" || is_foreign_;
    return by_plain ? plain_.getNumSubscribers() : shared_.getNumSubscribers();
  }

  std::uint32_t shared() const { return static_cast<std::uint32_t>(shared_.statistics().shared_subscribers); }

  void give_up() { plain_.shutdown(); }

  std::uint64_t dropped() const { return shared_.statistics().dropped; }

  void report(int last) const {
    const tzc::PublisherStatistics s = shared_.statistics();
    std::printf(
        "{\"last\": %d, \"shared\": %llu, \"serialized\": %llu, \"copied_bytes\": %llu, \"exhausted\": %llu, "
        "\"dropped\": "
        "%llu, \"revoked\": %llu}\n",
        last, (unsigned long long)s.shared, (unsigned long long)s.serialized,
        (unsigned long long)s.copied_bytes, (unsigned long long)s.exhausted, (unsigned long long)s.dropped,
        (unsigned long long)s.revoked);
    std::fflush(stdout);
  }

 private:
  static void see(const sensor_msgs::ImageConstPtr&) {}

  static tzc::PublisherOptions publisher_options(const ros::NodeHandle& options) {
    tzc::PublisherOptions in_code;
    in_code.memory_size = static_cast<std::size_t>(options.param("memory", 0));
    if (options.param<std::string>("policy", "") == "worst_effort")
      in_code.policy = tzc::Policy::worst_effort();
    return in_code;
  }

  template <class Image>
  void fill(Image& image, std::uint32_t number) const {
    tzc_test::fill_image(image, number, bytes_);
    image.encoding = encoding_;
    image.height = rows_;
    image.step = static_cast<std::uint32_t>(bytes_) / rows_;
    image.width = image.step / (encoding_ == "bgr8" ? 3 : 1);
  }

  /// In a type that has no twin: roscpp queues what it serializes.
  void publish_as_bytes(std::uint32_t number) {
    sensor_msgs::Image image;
    fill(image, number);
    ros::SerializedMessage bytes = ros::serialization::serializeMessage(image);
    ros::serialization::IStream stream(bytes.message_start, static_cast<std::uint32_t>(bytes.num_bytes - 4));
    topic_tools::ShapeShifter shifter;
    shifter.morph(ros::message_traits::md5sum(image), ros::message_traits::datatype(image),
                  ros::message_traits::definition(image), "0");
    shifter.read(stream);
    shared_.publish(shifter);
  }

  void allocate(tzc::sensor_msgs::Image& image) {
    if (mode_ == "of_node")
      tzc::allocate(image);
    else
      (mode_ == "stranger" ? not_advertised_ : shared_).allocate(image);
  }

  void publish_twin(std::uint32_t number) {
    const auto image = boost::make_shared<tzc::sensor_msgs::Image>();
    if (fresh_ != 0 && number % fresh_ == 0)
      tzc::message::allocate(*image, fresh_memory());
    else
      allocate(*image);
    fill(*image, number);
    if (mode_ == "twin_pointer")
      shared_.publish(image);
    else
      shared_.publish(*image);
  }

  /// A copy of the old publisher stays, and with it roscpp's object that had its callbacks.
  void change_publisher() {
    if (mode_ == "foreign_attached_handover") plain_ = second_;  // the first one is gone, and leaves no copy
    if (mode_ != "foreign_handover" && mode_ != "foreign_again") return;
    first_ = plain_;
    plain_.shutdown();
    plain_ = mode_ == "foreign_again" ? advertise_again_() : second_;
  }

  void publish_foreign_twin(std::uint32_t number) const {
    tzc::sensor_msgs::Image image;
    fill(image, number);
    tzc::publish(plain_, image);
  }

  std::shared_ptr<tzc::MemorySource> fresh_memory() const {
    tzc::MemoryOptions memory;
    memory.size = bytes_ + 4096;
    return *tzc::SegmentMemory::create(memory);
  }

  std::string mode_;
  std::size_t bytes_;
  std::uint32_t rows_, fresh_, half_;
  std::string encoding_;
  bool is_foreign_, is_plain_, alternates_;
  std::function<ros::Publisher()> advertise_again_;
  ros::Publisher plain_, first_, second_;
  ros::Subscriber beside_;
  tzc::Publisher shared_, not_advertised_;
};

std::vector<Talker> make_talkers(ros::NodeHandle node, ros::NodeHandle options) {
  std::vector<Talker> talkers;
  std::istringstream topics(options.param<std::string>("topics", "image"));
  for (std::string topic; topics >> topic;) {
    const bool is_private = topic[0] == '~';
    talkers.emplace_back(is_private ? options : node, options, is_private ? topic.substr(1) : topic);
  }
  return talkers;
}

volatile std::sig_atomic_t is_enough = 0, goes_on = 0;

template <class Condition>
void wait_until(Condition holds) {
  while (ros::ok() && !holds()) ros::WallDuration(0.002).sleep();
}

void wait_for_subscribers(const std::vector<Talker>& talkers, const ros::NodeHandle& options) {
  const auto wanted = static_cast<std::uint32_t>(options.param("subscribers", 1));
  const auto shared = static_cast<std::uint32_t>(options.param("shared", 0));
  for (const Talker& talker : talkers) {
    wait_until([&] { return talker.subscribers() >= wanted; });
    wait_until([&] { return talker.shared() >= shared; });
  }
  ros::WallDuration(options.param("settle", 0.0)).sleep();
}

/// Those who answer each image with one of the same number.
class Echo {
 public:
  Echo(ros::NodeHandle& node, const ros::NodeHandle& options)
      : echoes_(static_cast<std::uint32_t>(options.param("echoes", 1))), ahead_(options.param("ahead", 0)) {
    const std::string topic = options.param<std::string>("echo", "");
    if (topic.empty()) return;
    subscriber_ = node.subscribe(topic, 100, &Echo::take, this);
    wait_until([&] { return subscriber_.getNumPublishers() >= echoes_; });
  }

  /// Until all of them have answered the image that is so many (`ahead`) before this one.
  void wait_for(int number) {
    if (subscriber_)
      wait_until([&] {
        ros::spinOnce();
        return answered() >= number - ahead_;
      });
  }

 private:
  void take(const ros::MessageEvent<const sensor_msgs::Image>& event) {
    last_[event.getPublisherName()] = std::atoi(event.getMessage()->header.frame_id.c_str());
  }

  int answered() const {
    if (last_.size() < echoes_) return -1;
    const auto by_number = [](const auto& a, const auto& b) { return a.second < b.second; };
    return std::min_element(last_.begin(), last_.end(), by_number)->second;
  }

  ros::Subscriber subscriber_;
  std::map<std::string, int> last_;  ///< of each who answers
  std::uint32_t echoes_;
  int ahead_;
};

extern "C" void end_soon(int) {
  is_enough = 1;
}
extern "C" void go_on(int) {
  goes_on = 1;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "talker");
  std::signal(SIGUSR1, end_soon);
  std::signal(SIGUSR2, go_on);
  ros::NodeHandle node, options("~");
  std::vector<Talker> talkers = make_talkers(node, options);
  wait_for_subscribers(talkers, options);
  Echo echo(node, options);
  ros::WallRate rate(options.param("rate", 100.0));
  const int first = options.param("first", 0), count = options.param("count", 100);
  const int pause = options.param("pause", -1);
  int number = first;
  for (; ros::ok() && !is_enough && (count == 0 || number < first + count); ++number) {
    if (number == first + pause) wait_until([] { return goes_on != 0; });
    const std::uint64_t dropped = talkers.front().dropped();
    for (Talker& talker : talkers) talker.publish(static_cast<std::uint32_t>(number));
    if (talkers.front().dropped() == dropped) echo.wait_for(number);
    rate.sleep();
  }
  if (options.param("give_up", false))
    for (Talker& talker : talkers) talker.give_up();
  std::printf("{\"event\": \"all published\", \"last\": %d}\n", number - 1);
  std::fflush(stdout);
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(options.param("linger", 1.0));
  while (ros::ok() && ros::WallTime::now() < end) ros::WallDuration(0.01).sleep();
  for (const Talker& talker : talkers) talker.report(number - 1);
}
