// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/partial_input.h>
#include <tzc/detail/vector_words.h>
#include <tzc/detail/view.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tzc {
namespace message {
namespace detail {

/// The stream in which the serializers of generated messages read ROS's wire format. A data array borrows its elements from there if they
/// are the same bytes in memory, and aligned; it is listed in `borrowed`. Every read is checked: a relay publishes bytes that it received.
class WireInput : public ControlReader {
 public:
  static const ros::serialization::StreamType stream_type = ros::serialization::stream_types::Input;

  WireInput(const std::uint8_t* bytes, std::size_t size, std::vector<void*>& borrowed)
      : ControlReader(bytes, size, no_blocks()), borrowed_(borrowed) {}

  template <class T>
  void next(T& value) {
    ros::serialization::deserialize(*this, value);
  }
  template <class T, class Allocator>
  void next(std::vector<T, Allocator>& vector) {
    const std::size_t count = vector_size(least_control_size<T>());
    if (count != 0) next_elements(vector, count, typename ros::message_traits::IsSimple<T>::type());
  }

 private:
  static const std::vector<ConstBlock>& no_blocks() {
    static const std::vector<ConstBlock> none;
    return none;
  }

  template <class Vector>
  void next_elements(Vector& vector, std::size_t count, ros::message_traits::TrueType) {
    using T = typename Vector::value_type;
    if (count > UINT32_MAX / sizeof(T)) throw_malformed();
    const std::uint8_t* const bytes = advance(static_cast<std::uint32_t>(count * sizeof(T)));
    if (tzc::detail::can_use_vector_words<Vector>() &&
        reinterpret_cast<std::uintptr_t>(bytes) % alignof(T) == 0)
      return borrow(vector, reinterpret_cast<const T*>(bytes), count, borrowed_);
    vector.resize(count);
    std::memcpy(vector.data(), bytes, count * sizeof(T));
  }
  template <class Vector>
  void next_elements(Vector& vector, std::size_t count, ros::message_traits::FalseType) {
    vector.resize(count);
    for (auto& element : vector) next(element);
  }

  std::vector<void*>& borrowed_;
};

}  // namespace detail
}  // namespace message
}  // namespace tzc
