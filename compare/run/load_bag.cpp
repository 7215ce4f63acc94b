// SPDX-License-Identifier: BSD-3-Clause
#include "run/load_bag.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <map>
#include <memory>

#include "engine/comparison.h"
#include "run/failure.h"
#include "run/stop_request.h"

namespace tzc::compare {
namespace {

using Key = std::pair<std::string, std::string>;

Bytes bytes_of(const rosbag::MessageInstance& message) {
  Bytes bytes(message.size());
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.write(stream);
  return bytes;
}

/// One stream while its messages are read.
class StreamLoader {
 public:
  StreamLoader(const Key& key, const rosbag::MessageInstance& first)
      : stream_{key.first, key.second, first.getDataType(), first.getMD5Sum(), first.getMessageDefinition(),
                {},        {}},
        // Without a definition a message is one run of bytes.
        definition_(parse_definition(stream_.datatype, stream_.definition).value_or(Field())),
        masks_(definition_, filter_for(definition_, {true, {}})) {}

  void add(const rosbag::MessageInstance& message) {
    Bytes bytes = bytes_of(message);
    const auto header = header_stamp(definition_, bytes);
    const std::size_t size = bytes.size();
    masks_.apply(bytes);
    stream_.messages.push_back(
        {static_cast<std::int64_t>(message.getTime().toNSec()), header, digest_of(bytes), size});
    instances_.push_back(message);
  }

  Stream finish(const std::shared_ptr<rosbag::Bag>& bag) {
    stream_.read = [bag, instances = std::move(instances_)](std::size_t index) {
      check_for_stop_request();  // here, since a comparison, which may take minutes, knows of no signals
      return bytes_of(instances[index]);
    };
    return std::move(stream_);
  }

 private:
  Stream stream_;
  const Field definition_;
  const Masks masks_;
  std::vector<rosbag::MessageInstance> instances_;
};

std::map<Key, StreamLoader> read_streams(const rosbag::Bag& bag) {
  std::map<Key, StreamLoader> streams;
  rosbag::View view(bag);
  for (const rosbag::MessageInstance& message : view) {
    check_for_stop_request();
    const Key key{message.getTopic(), without_anonymous_part(message.getCallerId())};
    streams.try_emplace(key, key, message).first->second.add(message);
  }
  return streams;
}

}  // namespace

Recording load_recording(const std::string& path, const nlohmann::json& summary) {
  const auto bag = std::make_shared<rosbag::Bag>();
  std::map<Key, Stream> streams;
  try {
    bag->open(path, rosbag::bagmode::Read);
    for (auto& [key, loader] : read_streams(*bag)) streams.emplace(key, loader.finish(bag));
  } catch (const rosbag::BagException& failure) {
    throw Failure("the recording " + path + " cannot be read: " + failure.what());
  }
  for (const auto& topic : summary["topics"]) {
    for (const std::string publisher : topic["publishers"]) {
      const Key key{topic["topic"], without_anonymous_part(publisher)};
      streams.emplace(key, Stream{key.first, key.second, topic["type"], "", "", {}, {}, 0});
    }
  }
  Recording recording;
  for (auto& [key, stream] : streams) {
    stream.recorded_until_ns = summary["now"];
    recording.push_back(std::move(stream));
  }
  return recording;
}

InputTimes load_inputs(const nlohmann::json& summary) {
  InputTimes times;
  for (const auto& entry : summary["inputs"]) times.emplace(entry[0], entry[1]);
  return times;
}

}  // namespace tzc::compare
