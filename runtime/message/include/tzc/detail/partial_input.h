// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/partial_output.h>
#include <tzc/detail/vector_words.h>
#include <tzc/detail/view.h>
#include <tzc/generated_message_support.h>
#include <tzc/memory.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tzc {
namespace message {
namespace detail {

/// Elements inside a received block, checked: in bounds, aligned, of the expected size.
struct DataArray {
  const std::uint8_t* data;  // null when count is 0
  std::size_t count;
};

/// Reads control bytes that are not trusted. Every read is checked; the first bad one throws Malformed.
class ControlReader {
 public:
  struct Malformed {};

  ControlReader(const std::uint8_t* control, std::size_t size, const std::vector<ConstBlock>& blocks);

  /// The next `size` control bytes. Not const because ROS serializers want it so; they do not write there.
  std::uint8_t* advance(std::uint32_t size) {
    if (size > remaining()) throw_malformed();
    std::uint8_t* const old = const_cast<std::uint8_t*>(at_);
    at_ += size;
    return old;
  }
  std::uint32_t getLength() const { return static_cast<std::uint32_t>(remaining()); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }

  DataArray array(std::size_t element_size, std::size_t alignment);
  /// The length of a vector whose elements take at least `least` control bytes each; of such that may take none only an empty one is
  /// read.
  std::size_t vector_size(std::size_t least);

  [[noreturn]] static void throw_malformed();

 private:
  template <class T>
  T read();

  const std::uint8_t* at_;
  const std::uint8_t* end_;
  const std::vector<ConstBlock>& blocks_;
  std::uint64_t array_bytes_left_;
};

/// The fewest control bytes that a T takes: those of a default-constructed one, whose strings and arrays are
/// empty. An empty array takes as much in the control part as on the wire.
template <class T>
std::size_t least_control_size() {
  static const std::size_t size = ros::serialization::serializationLength(*tzc::detail::ElementCopy<T>());
  return size;
}

/// The stream that ROS serializers read from. Vectors that hold data arrays borrow from the blocks and are
/// listed in `borrowed`, or are copied when that is null.
class PartialInput : public ControlReader {
 public:
  static const ros::serialization::StreamType stream_type = ros::serialization::stream_types::Input;

  PartialInput(const std::uint8_t* control, std::size_t size, const std::vector<ConstBlock>& blocks,
               std::vector<void*>* borrowed)
      : ControlReader(control, size, blocks), borrowed_(borrowed) {}

  template <class T>
  void next(T& value) {
    ros::serialization::deserialize(*this, value);
  }
  template <class T>
  void next(Array<T>& array) {
    const DataArray data = this->array(sizeof(T), alignof(T));
    const T* const first = reinterpret_cast<const T*>(data.data);
    array.assign(first, first + data.count);
  }
  template <class T, class Allocator>
  void next(std::vector<T, Allocator>& vector) {
    next_vector(vector, typename ros::message_traits::IsFixedSize<T>::type());
  }
  /// A data array of elements that are `element_size` bytes each, for hand-written codecs.
  DataArray next_array(std::size_t element_size) { return array(element_size, 1); }

 private:
  template <class Vector>
  void next_vector(Vector& vector, ros::message_traits::TrueType) {
    using T = typename Vector::value_type;
    const DataArray data = array(sizeof(T), alignof(T));
    const T* const first = reinterpret_cast<const T*>(data.data);
    if (borrowed_ != nullptr && tzc::detail::can_use_vector_words<Vector>()) {
      if (data.count != 0) borrow(vector, first, data.count, *borrowed_);
    } else {
      vector.assign(first, first + data.count);
    }
  }
  template <class Vector>
  void next_vector(Vector& vector, ros::message_traits::FalseType) {
    vector.resize(vector_size(least_control_size<typename Vector::value_type>()));
    for (auto& element : vector) next(element);
  }
  std::vector<void*>* borrowed_;
};

}  // namespace detail
}  // namespace message
}  // namespace tzc
