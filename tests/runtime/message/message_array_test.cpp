// SPDX-License-Identifier: BSD-3-Clause
// tzc::MessageArray: where the arrays of elements lie that a message gets after allocate, and that it is a std::vector.
#include <tzc/message.h>
#include <tzc/message_array.h>
#include <tzc/sensor_msgs/PointCloud.h>
#include <tzc/visualization_msgs/InteractiveMarker.h>

#include <random>

#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

using sensor_msgs::PointCloud;
using Channel = sensor_msgs::ChannelFloat32;
using Channels = MessageArray<Channel>;
using Vector = std::vector<Channel>;

Channel channel(std::size_t values, const char* name = "") {
  Channel made;
  made.name = name;
  made.values.assign(values, 1.5F);
  return made;
}

bool is_shared_memory(const Channel& channel) {
  return in_segment(channel.values.data());
}

class ArrayOfMessages : public ::testing::Test {
 protected:
  ArrayOfMessages() { EXPECT_TRUE(allocate(cloud_, memory_)); }

  std::size_t copied_by_publish() {
    Encoded encoded;
    EXPECT_TRUE(encode(cloud_, memory_, encoded));
    EXPECT_EQ(to_stock(cloud_), *stock_view(cloud_, encoded));
    return encoded.copied_bytes;
  }

  std::shared_ptr<test::TestMemory> memory_ = std::make_shared<test::TestMemory>();
  PointCloud cloud_;
  Channels& channels_ = cloud_.channels;
};

TEST_F(ArrayOfMessages, elements_that_are_made_after_allocate_grow_in_shared_memory) {
  channels_.resize(2);
  channels_.emplace_back();
  channels_.emplace(channels_.begin());
  channels_.resize(6, Channel());
  for (Channel& element : channels_) element.values.resize(100);
  EXPECT_TRUE(std::all_of(channels_.begin(), channels_.end(), is_shared_memory));
  EXPECT_EQ(0u, copied_by_publish());
}

TEST_F(ArrayOfMessages, an_element_is_copied_into_shared_memory) {
  const Channel local = channel(100, "intensity");
  channels_.push_back(local);
  channels_.push_back(channels_.front());  // of its own, which may move meanwhile
  EXPECT_EQ((Vector{local, local}), channels_);
  channels_ = Vector(3, local);  // moved
  EXPECT_EQ(1200u, copied_by_publish());
  const Vector others(4, local);
  channels_ = others;
  EXPECT_EQ(others, channels_);
  EXPECT_EQ(0u, copied_by_publish());
}

TEST_F(ArrayOfMessages, what_is_moved_or_inserted_is_copied_by_publish) {
  channels_.push_back(channel(10));
  channels_.insert(channels_.begin(), channel(10));
  channels_.insert(channels_.end(), 2, channel(10));
  channels_.insert(channels_.end(), {channel(10)});
  channels_.emplace_back(channel(10));
  EXPECT_EQ(240u, copied_by_publish());
  channels_.clear();
  channels_.assign(2, channel(5));
  EXPECT_EQ(40u, copied_by_publish());
  channels_.clear();
  channels_ = {channel(5), channel(6)};
  EXPECT_EQ(44u, copied_by_publish());
  for (Channel& element : channels_) element.values.resize(1000);
  EXPECT_EQ(0u, copied_by_publish()) << "they are bound all the same";
}

/// A message that lasts, and that nobody allocated.
TEST_F(ArrayOfMessages, publishing_binds_it) {
  PointCloud lasting;
  for (int i = 0; i < 3; ++i) {
    lasting.channels.clear();
    lasting.channels.resize(1);
    lasting.channels[0].values.assign(100, static_cast<float>(i));
    Encoded encoded;
    ASSERT_TRUE(encode(lasting, memory_, encoded));
    EXPECT_EQ(i == 0 ? 400u : 0u, encoded.copied_bytes);
    EXPECT_EQ(to_stock(lasting), *stock_view(lasting, encoded));
  }
}

TEST_F(ArrayOfMessages, publishing_leaves_the_memory_it_is_bound_to) {
  const auto other = std::make_shared<test::TestMemory>();
  Encoded encoded;
  ASSERT_TRUE(encode(cloud_, other, encoded));
  channels_.resize(1);
  channels_[0].values.resize(10);
  EXPECT_EQ(other->allocations, 0);
}

TEST_F(ArrayOfMessages, only_the_first_elements_are_bound) {
  channels_.resize(Channels::most_bound + 2);
  channels_.push_back(channel(10));
  for (Channel& element : channels_) element.values.resize(10);
  EXPECT_TRUE(is_shared_memory(channels_[Channels::most_bound - 1]));
  EXPECT_FALSE(is_shared_memory(channels_[Channels::most_bound]));
  EXPECT_EQ(3 * 40u, copied_by_publish());
}

TEST_F(ArrayOfMessages, a_copy_is_not_bound_and_a_move_is) {
  PointCloud copy(cloud_);
  copy.channels.resize(1);
  copy.channels[0].values.resize(10);
  EXPECT_FALSE(is_shared_memory(copy.channels[0]));
  PointCloud moved(std::move(cloud_));
  moved.channels.resize(1);
  moved.channels[0].values.resize(10);
  EXPECT_TRUE(is_shared_memory(moved.channels[0]));
  copy.channels.clear();
  copy = std::move(moved);
  copy.channels.resize(2);
  copy.channels[1].values.resize(10);
  EXPECT_TRUE(is_shared_memory(copy.channels[1])) << "it had no memory of its own";
}

TEST_F(ArrayOfMessages, a_swap_leaves_each_its_memory) {
  Vector plain(1);
  std::swap(plain, channels_);
  swap(channels_, plain);
  channels_.swap(plain);
  swap(plain, channels_);
  PointCloud other;
  swap(channels_, other.channels);
  swap(channels_, other.channels);
  channels_.resize(2);
  channels_[1].values.resize(10);
  EXPECT_TRUE(is_shared_memory(channels_[1]));
  other.channels.resize(1);
  other.channels[0].values.resize(10);
  EXPECT_FALSE(is_shared_memory(other.channels[0]));
}

TEST_F(ArrayOfMessages, without_memory_elements_lie_on_the_heap) {
  memory_->exhausted = true;
  channels_.push_back(channel(10));
  const Channel local = channel(10);
  channels_.push_back(local);
  channels_.resize(3);
  channels_[2].values.resize(10);
  memory_->exhausted = false;
  EXPECT_EQ(120u, copied_by_publish());
}

TEST_F(ArrayOfMessages, arrays_inside_its_elements_are_bound) {
  visualization_msgs::InteractiveMarker marker;
  ASSERT_TRUE(allocate(marker, memory_));
  const auto add_points = [&] {
    marker.controls.clear();
    marker.controls.resize(1);
    marker.controls[0].markers.resize(1);
    marker.controls[0].markers[0].points.resize(10);
    return in_segment(marker.controls[0].markers[0].points.data());
  };
  EXPECT_TRUE(add_points());

  visualization_msgs::InteractiveMarker lasting;
  lasting.controls.resize(1);
  Encoded encoded;
  ASSERT_TRUE(encode(lasting, memory_, encoded));
  lasting.controls[0].markers.resize(1);
  lasting.controls[0].markers[0].points.resize(10);
  EXPECT_TRUE(in_segment(lasting.controls[0].markers[0].points.data())) << "bound by publish";
}

using Stock = ::sensor_msgs::ChannelFloat32;

Stock as(const Channel& element, const std::vector<Stock>&) {
  return to_stock(element);
}
Channel as(const Channel& element, const Channels&) {
  return element;
}

template <class Array>
void put(Array& array, unsigned operation, std::size_t at, const Channel& element) {
  auto made = as(element, array);
  const auto there = array.begin() + static_cast<std::ptrdiff_t>(at);
  switch (operation) {
    case 0:
      return array.push_back(made);
    case 1:
      return array.push_back(std::move(made));
    case 2:
      return static_cast<void>(array.emplace_back(to_stock(element)));
    case 3:
      return static_cast<void>(array.insert(there, made));
    case 4:
      return static_cast<void>(array.insert(there, 2, made));
    case 5:
      return static_cast<void>(array.insert(there, {made, made}));
    default:
      if (!array.empty()) array.push_back(array[at % array.size()]);
  }
}

template <class Array>
void replace(Array& array, unsigned operation, std::size_t at, const Channel& element) {
  const auto made = as(element, array);
  switch (operation) {
    case 0:
      return array.resize(at);
    case 1:
      return array.resize(at + 2, made);
    case 2:
      return static_cast<void>(array = std::vector<typename Array::value_type>(at, made));
    case 3:
      return array.assign({made});
    default:
      return static_cast<void>(array = Array(array));
  }
}

/// Every operation by itself, in random order, beside a std::vector of the stock messages.
TEST_F(ArrayOfMessages, it_is_a_vector) {
  std::mt19937 random(7);
  const auto pick = [&](std::size_t n) { return random() % n; };
  std::vector<Stock> oracle;
  for (int step = 0; step < 3000; ++step) {
    const Channel made = channel(pick(9), "made");
    const std::size_t at = pick(channels_.size() + 1);
    const unsigned operation = static_cast<unsigned>(pick(12));
    if (operation < 7) {
      put(channels_, operation, at, made);
      put(oracle, operation, at, made);
    } else {
      replace(channels_, operation - 7, at, made);
      replace(oracle, operation - 7, at, made);
    }
    if (pick(4) == 0) copied_by_publish();
    ASSERT_EQ(oracle, to_stock(cloud_).channels) << "step " << step;
    if (channels_.size() > 100) channels_.clear(), oracle.clear();
  }
}

TEST_F(ArrayOfMessages, converts_to_and_from_a_vector) {
  channels_.push_back(channel(3));
  const Vector copy = channels_;
  Vector& base = channels_;
  EXPECT_EQ(copy, base);
  EXPECT_TRUE(channels_ == copy && !(channels_ != copy));
  EXPECT_EQ(copy, Channels(copy));
  EXPECT_EQ(copy, Channels(copy.begin(), copy.end()));
  EXPECT_EQ(2u, Channels(2).size());
}

}  // namespace
}  // namespace message
}  // namespace tzc
