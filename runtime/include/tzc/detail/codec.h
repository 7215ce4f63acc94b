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
    return message::make_view<M>(control, size, blocks, std::move(hold));
  }
  static boost::shared_ptr<void> copy(const std::uint8_t* control, std::size_t size,
                                      const std::vector<ConstBlock>& blocks) {
    return message::make_copy<M>(control, size, blocks);
  }
};

/// The codec of message type M as roscpp knows it (a stock type, never a tzc:: one). Adapters specialise
/// CodecFunctions for types whose arrays are not std::vectors (pcl::PointCloud).
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
