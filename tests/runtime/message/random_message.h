// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/message.h>

#include <random>
#include <string>
#include <vector>

namespace tzc {
namespace test {

/// A stream that "reads" random content, so that any generated message type can be filled through its
/// serializer.
class RandomStream {
 public:
  static const ros::serialization::StreamType stream_type = ros::serialization::stream_types::Input;

  RandomStream(unsigned seed, std::size_t most_elements) : random_(seed), most_(most_elements) {}

  template <class T>
  void next(T& value) {
    ros::serialization::deserialize(*this, value);
  }
  void next(float& value) { value = static_cast<float>(random_() % 1000) / 8; }
  void next(double& value) { value = static_cast<double>(random_() % 1000) / 8; }
  void next(std::string& text) { text = std::string(random_() % 9, static_cast<char>('a' + random_() % 26)); }
  template <class T, class A>
  void next(std::vector<T, A>& vector) {
    fill(vector, ros::message_traits::IsFixedSize<T>::value ? random_() % (most_ + 1) : random_() % 4);
  }
  template <class T>
  void next(Array<T>& array) {
    fill(array, random_() % (most_ + 1));
  }

  std::uint8_t* advance(std::uint32_t size) {
    bytes_.resize(size);
    for (std::uint8_t& byte : bytes_) byte = static_cast<std::uint8_t>(random_());
    return bytes_.data();
  }
  std::uint32_t getLength() const { return 1u << 30; }

 private:
  template <class Sequence>
  void fill(Sequence& sequence, std::size_t size) {
    sequence.resize(size);
    for (auto& element : sequence) next(element);
  }

  std::mt19937 random_;
  std::size_t most_;
  std::vector<std::uint8_t> bytes_;
};

template <class M>
M random_message(unsigned seed, std::size_t most_elements = 60) {
  M message;
  RandomStream stream(seed, most_elements);
  ros::serialization::deserialize(stream, message);
  return message;
}

/// A stream that shows each data array of a message to visit(address, bytes) and counts the control bytes.
template <class Visit>
class DataArrays {
 public:
  static const ros::serialization::StreamType stream_type = ros::serialization::stream_types::Output;

  explicit DataArrays(Visit visit) : visit_(visit) {}

  template <class T>
  void next(const T& value) {
    ros::serialization::serialize(*this, value);
  }
  template <class T>
  void next(const Array<T>& array) {
    show(array);
  }
  template <class T, class A>
  void next(const std::vector<T, A>& vector) {
    next_vector(vector, typename ros::message_traits::IsFixedSize<T>::type());
  }
  std::uint8_t* advance(std::uint32_t size) {
    bytes_.resize(size);
    return bytes_.data();
  }

 private:
  template <class Sequence>
  void show(const Sequence& sequence) {
    if (!sequence.empty()) visit_(sequence.data(), sequence.size() * sizeof(*sequence.data()));
  }
  template <class Vector>
  void next_vector(const Vector& vector, ros::message_traits::TrueType) {
    show(vector);
  }
  template <class Vector>
  void next_vector(const Vector& vector, ros::message_traits::FalseType) {
    for (const auto& element : vector) next(element);
  }

  Visit visit_;
  std::vector<std::uint8_t> bytes_;
};

template <class M, class Visit>
void visit_arrays(const M& message, Visit visit) {
  DataArrays<Visit> stream(visit);
  ros::serialization::serialize(stream, message);
}

template <class M>
std::size_t data_size(const M& message) {
  std::size_t size = 0;
  visit_arrays(message, [&](const void*, std::size_t bytes) { size += bytes; });
  return size;
}

inline std::vector<ConstBlock> blocks_of(const message::Encoded& encoded) {
  std::vector<ConstBlock> blocks;
  for (const BufferPtr& buffer : encoded.buffers)
    blocks.push_back(ConstBlock{buffer->data(), buffer->size()});
  return blocks;
}

}  // namespace test
}  // namespace tzc
