// SPDX-License-Identifier: BSD-3-Clause
#include <ros/serialization.h>
#include <unistd.h>
#include <boost/make_shared.hpp>

#include "core/channel_pair.h"
#include "roscpp/contenders.h"
#include "roscpp/image_stamp.h"

namespace tzc {
namespace bench {
namespace {

using Image = ::sensor_msgs::Image;

BufferPtr serialize(const Image& image, SegmentMemory& memory) {
  const std::uint32_t bytes = ros::serialization::serializationLength(image);
  BufferPtr buffer = memory.allocate(bytes);
  if (!buffer) return buffer;
  ros::serialization::OStream stream(buffer->data(), bytes);
  ros::serialization::serialize(stream, image);
  return buffer;
}

void deserialize(const channel::Message& message, Recorder& recorder) {
  const ConstBlock& block = message.blocks().front();
  // The stream's type is the same for reading and writing; it reads here.
  ros::serialization::IStream stream(const_cast<std::uint8_t*>(block.data),
                                     static_cast<std::uint32_t>(block.size));
  const auto image = boost::make_shared<Image>();
  ros::serialization::deserialize(stream, *image);
  record(*image, recorder);
}

class AslContender final : public Contender {
 public:
  const char* name() const override { return "asl"; }
  std::size_t memory_bytes(const Setup& setup) const override { return shared_memory_bytes(setup, true); }

  void subscribe(const Setup& setup, std::size_t, Recorder& recorder) override {
    channel::SubscriberOptions options;
    options.on_message = [&recorder](const channel::MessagePtr& message) { deserialize(*message, recorder); };
    const auto subscriber = connect(setup, options);
    recorder.ready();
    while (!recorder.stop()) ::usleep(250'000);
  }

  std::function<void(std::uint64_t)> publish(const Setup& setup) override {
    const auto image = std::make_shared<Image>();
    image->data.resize(setup.size_bytes);
    const auto publisher = open_publisher(setup, ros::serialization::serializationLength(*image));
    return [publisher, image, setup](std::uint64_t index) {
      fill_and_stamp(*image, Span(setup, index));
      const BufferPtr buffer = serialize(*image, *publisher->memory());
      publisher->publish(channel::make_record(0, nullptr, 0, {buffer}));
    };
  }
};

}  // namespace

std::unique_ptr<Contender> asl_contender() {
  return std::make_unique<AslContender>();
}

}  // namespace bench
}  // namespace tzc
