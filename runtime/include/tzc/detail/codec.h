// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <tzc/memory.h>
#include <tzc/message.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace tzc {
namespace detail {

/// What the transport must be able to do with one C++ message type, its type erased: the transport itself is compiled
/// once, without knowing any message. Functions are stateless and thread-safe.
struct MessageCodec {
  const std::type_info* type;
  std::string datatype;
  std::string md5sum;
  bool has_header;

  /// Partial serialization of the message at `message` (of C++ type `*type`). False: no shared memory left.
  bool (*encode)(const void* message, MemorySource& memory, message::Encoded& encoded);
  /// The stock wire format, four bytes of length in front, as roscpp's own serializeMessage.
  ros::SerializedMessage (*serialize)(const void* message);
  /// A read-only message whose arrays borrow the shared bytes; null when the control part is malformed.
  boost::shared_ptr<void> (*view)(const std::uint8_t* control, std::size_t size, const std::vector<ConstBlock>& blocks,
                                  std::shared_ptr<const void> hold);
  /// The same message in private memory, for whoever may write to it; null when the control part is malformed.
  boost::shared_ptr<void> (*copy)(const std::uint8_t* control, std::size_t size,
                                  const std::vector<ConstBlock>& blocks);
};

template <class>
struct Void {
  typedef void type;
};
/// Message types of another library that ROS knows by an adapter (pcl::PointCloud): neither stock nor generated. They
/// go by pointer as they are, since subscribers of the same process may use the same type.
template <class M, class = void>
struct IsForeign : message::IsTwin<M> {};
template <class M>
struct IsForeign<M, typename Void<typename M::Stock>::type> : std::false_type {};

template <class M>
struct CodecFunctions {
  static bool encode(const void* message, MemorySource& memory, message::Encoded& encoded) {
    return message::encode(*static_cast<const M*>(message), memory, encoded);
  }
  static ros::SerializedMessage serialize(const void* message) {
    return ros::serialization::serializeMessage(*static_cast<const M*>(message));
  }
  static boost::shared_ptr<void> view(const std::uint8_t* control, std::size_t size,
                                      const std::vector<ConstBlock>& blocks, std::shared_ptr<const void> hold) {
    return look(control, size, blocks, std::move(hold), IsForeign<M>());
  }
  static boost::shared_ptr<void> copy(const std::uint8_t* control, std::size_t size,
                                      const std::vector<ConstBlock>& blocks) {
    return message::make_copy<M>(control, size, blocks);
  }

 private:
  static boost::shared_ptr<void> look(const std::uint8_t* control, std::size_t size,
                                      const std::vector<ConstBlock>& blocks, std::shared_ptr<const void> hold,
                                      std::false_type) {
    return message::make_view<M>(control, size, blocks, std::move(hold));
  }
  /// A foreign type's memory has a layout of its own: one copy, as with the library's own conversion.
  static boost::shared_ptr<void> look(const std::uint8_t* control, std::size_t size,
                                      const std::vector<ConstBlock>& blocks, const std::shared_ptr<const void>&,
                                      std::true_type) {
    return copy(control, size, blocks);
  }
};

/// The codec of message type M as roscpp knows it: a stock type or a foreign one, never a tzc:: one.
template <class M>
MessageCodec make_codec() {
  namespace mt = ros::message_traits;
  return MessageCodec{&typeid(M),
                      mt::datatype<M>(),
                      mt::md5sum<M>(),
                      mt::hasHeader<M>(),
                      &CodecFunctions<M>::encode,
                      &CodecFunctions<M>::serialize,
                      &CodecFunctions<M>::view,
                      &CodecFunctions<M>::copy};
}

}  // namespace detail
}  // namespace tzc
