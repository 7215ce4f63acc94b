// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/subscription_callback_helper.h>
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

/// The operations of the transport on one C++ message type, type-erased: the transport is compiled once,
/// without knowing any message. Functions are stateless and thread-safe.
struct MessageCodec {
  const std::type_info* type;
  std::string datatype;
  std::string md5sum;
  bool has_header;

  /// Partial serialization of the message at `message` (of C++ type `*type`). False: no shared memory left.
  bool (*encode)(const void* message, const std::shared_ptr<MemorySource>& memory, message::Encoded& encoded);
  /// The same from the stock wire format, without the length in front. False also when these bytes are no such message, and for types that
  /// gencpp did not generate.
  bool (*encode_serialized)(const std::uint8_t* bytes, std::size_t size,
                            const std::shared_ptr<MemorySource>& memory, message::Encoded& encoded);
  /// The stock wire format, four bytes of length in front, as roscpp's own serializeMessage.
  ros::SerializedMessage (*serialize)(const void* message);
  /// A read-only message whose arrays borrow the shared bytes; null when the control part is malformed.
  boost::shared_ptr<void> (*view)(const std::uint8_t* control, std::size_t size,
                                  const std::vector<ConstBlock>& blocks, std::shared_ptr<const void> hold);
  /// The same message in private memory, for callbacks that may write to it; null when the control part is
  /// malformed.
  boost::shared_ptr<void> (*copy)(const std::uint8_t* control, std::size_t size,
                                  const std::vector<ConstBlock>& blocks);
  /// False for a callback of this message type that may write to its argument.
  bool (*only_reads)(const ros::SubscriptionCallbackHelper& callback);
};

/// Base of callback helpers that only read, although their parameter's type does not say so.
struct ReadingCallback {
  virtual ~ReadingCallback() = default;
};
template <class P>
struct ReadingCallbackT : ros::SubscriptionCallbackHelperT<P>, ReadingCallback {
  using ros::SubscriptionCallbackHelperT<P>::SubscriptionCallbackHelperT;
};

template <class>
struct Void {
  typedef void type;
};
/// True for message types of other libraries that ROS knows through an adapter (pcl::PointCloud): neither
/// stock nor generated. They are published by pointer as they are, since subscribers of the same process may
/// use the same type.
template <class M>
struct IsForeign
    : std::integral_constant<bool, message::IsTwin<M>::value && !message::IsGenerated<M>::value> {};

/// True for what gencpp generates, whose wire format is known.
template <class M>
struct IsStock : std::false_type {};
template <template <class> class Message>
struct IsStock<Message<std::allocator<void> > > : std::true_type {};

template <class M>
struct CodecFunctions {
  static bool encode(const void* message, const std::shared_ptr<MemorySource>& memory,
                     message::Encoded& encoded) {
    return message::encode(*static_cast<const M*>(message), memory, encoded);
  }
  static bool encode_serialized(const std::uint8_t* bytes, std::size_t size,
                                const std::shared_ptr<MemorySource>& memory, message::Encoded& encoded) {
    return encode_bytes(bytes, size, memory, encoded, IsStock<M>());
  }
  static ros::SerializedMessage serialize(const void* message) {
    return ros::serialization::serializeMessage(*static_cast<const M*>(message));
  }
  static boost::shared_ptr<void> view(const std::uint8_t* control, std::size_t size,
                                      const std::vector<ConstBlock>& blocks,
                                      std::shared_ptr<const void> hold) {
    return make_pointer(control, size, blocks, std::move(hold), IsForeign<M>());
  }
  static boost::shared_ptr<void> copy(const std::uint8_t* control, std::size_t size,
                                      const std::vector<ConstBlock>& blocks) {
    return message::make_copy<M>(control, size, blocks);
  }
  /// roscpp's own isConst() is true for message_filters' callback, behind which there may be a writer.
  static bool only_reads(const ros::SubscriptionCallbackHelper& callback) {
    typedef boost::shared_ptr<M const> Pointer;
    return has_parameter<const Pointer&>(callback) || has_parameter<const M&>(callback) ||
           has_parameter<M>(callback) || has_parameter<Pointer>(callback) ||
           dynamic_cast<const ReadingCallback*>(&callback) != nullptr;
  }

 private:
  static bool encode_bytes(const std::uint8_t* bytes, std::size_t size,
                           const std::shared_ptr<MemorySource>& memory, message::Encoded& encoded,
                           std::true_type) {
    return message::encode_serialized<M>(bytes, size, memory, encoded);
  }
  static bool encode_bytes(const std::uint8_t*, std::size_t, const std::shared_ptr<MemorySource>&,
                           message::Encoded&, std::false_type) {
    return false;
  }
  template <class P>
  static bool has_parameter(const ros::SubscriptionCallbackHelper& callback) {
    return typeid(callback) == typeid(ros::SubscriptionCallbackHelperT<P>);
  }
  static boost::shared_ptr<void> make_pointer(const std::uint8_t* control, std::size_t size,
                                              const std::vector<ConstBlock>& blocks,
                                              std::shared_ptr<const void> hold, std::false_type) {
    return message::make_view<M>(control, size, blocks, std::move(hold));
  }
  /// A foreign type has its own memory layout: one copy, as in the library's own conversion.
  static boost::shared_ptr<void> make_pointer(const std::uint8_t* control, std::size_t size,
                                              const std::vector<ConstBlock>& blocks,
                                              const std::shared_ptr<const void>&, std::true_type) {
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
                      &CodecFunctions<M>::encode_serialized,
                      &CodecFunctions<M>::serialize,
                      &CodecFunctions<M>::view,
                      &CodecFunctions<M>::copy,
                      &CodecFunctions<M>::only_reads};
}

}  // namespace detail
}  // namespace tzc
