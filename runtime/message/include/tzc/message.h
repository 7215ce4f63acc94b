// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Partial serialization: big arrays stay where they are, everything else becomes a small control part.
//
//   publisher                                            subscriber
//
//                       +--> control part --- socket ---+--> make_view: a stock message that borrows the
//   message --encode--> |                               |               arrays' bytes, read-only
//      ^                +--> buffers ------- segment ---+--> make_copy: a stock message of its own
//   allocate puts its arrays into one block
//
// The control part is the message in wire order; each data array (a variable-length array of a fixed-length
// type, at any depth) is replaced by
//   u32 count                                              nothing more when count is 0
//   u32 element size, u32 block index, u64 offset          in bytes; elements have their C++ layout
// A message that begins with a std_msgs/Header begins with that header's seq. Native byte order: one machine.
//
// All functions are thread-safe as far as their arguments are not shared. C++14.

#include <tzc/generated_message_support.h>
#include <tzc/memory.h>

#include <boost/shared_ptr.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace tzc {
namespace message {

/// A message ready for the channel: the control part, and the buffers that its array entries count through.
struct Encoded {
  std::vector<std::uint8_t> control;
  std::vector<BufferPtr> buffers;
  std::size_t copied_bytes = 0;  ///< array bytes that were not in shared memory yet
};

/// How a type reads and writes its partial form: by its ROS serializer, which generated types have. A
/// hand-written serializer copies its arrays through the stream as plain bytes; such a type specialises
/// Codec, and writes arrays by stream.next_array(). It also specialises StockOf when subscribers use another
/// type.
template <class M>
struct Codec {
  template <class Stream>
  static void write(Stream& stream, const M& message) {
    ros::serialization::serialize(stream, message);
  }
  template <class Stream>
  static void read(Stream& stream, M& message) {
    ros::serialization::deserialize(stream, message);
  }
};

/// True when the partial form of M is that of M's ROS type: for messages that gencpp or tzc-msggen generated
/// and for types with a Codec of their own. Other types (topic_tools::ShapeShifter, adapted user types)
/// travel in ROS's wire format.
template <class M>
struct HasPartialForm : IsTwin<M> {};
template <template <class> class Message>
struct HasPartialForm<Message<std::allocator<void> > > : std::true_type {};

/// Prepares `message` (stock or tzc::) for publishing. Arrays that lie in a segment of this process are
/// referenced, the others are copied, together, into one new buffer from `memory`. Arrays of a tzc:: message
/// count as shared from now on: a later write through the message gets fresh memory, from `memory` when they were on
/// the heap and not bound. What is encoded again before it was written is not copied again.
/// `encoded` may be reused; what it held is replaced. It keeps the buffers alive; make_record seals them.
/// A forked child's arrays in memory of its parent are copied each time (Buffer::inherited).
/// Returns false, and nothing is copied, when `memory` is exhausted, an array has 2^32 elements or more, or elements are
/// referred to too often (docs/messages.md). Nobody has the arrays then, but those in a segment count as shared all the same.
template <class M>
bool encode(const M& message, const std::shared_ptr<MemorySource>& memory, Encoded& encoded);

/// The same for a message of a generated type S (stock) that roscpp has serialized, without the length in front: its arrays are copied from
/// the bytes into shared memory, once. Returns false also when the bytes are not one S.
template <class S>
bool encode_serialized(const std::uint8_t* bytes, std::size_t size,
                       const std::shared_ptr<MemorySource>& memory, Encoded& encoded);

/// The message that a control part and its blocks describe, as type S (stock), without copying data arrays:
/// their vectors point into the blocks, which must be readable as long as `hold` lives; the view keeps it.
/// Const by contract: writing through the pointer is undefined. Copying the message is a deep copy, as ever.
/// Returns null when the control part is not one of an S: nothing in it can make this read or point outside
/// of the blocks, nor allocate more than a constant times its size. In a forked child the view's end does not
/// release `hold`. Where vectors cannot borrow (another standard library, debug containers) it copies the
/// arrays.
template <class S>
boost::shared_ptr<S> make_view(const std::uint8_t* control, std::size_t size,
                               const std::vector<ConstBlock>& blocks, std::shared_ptr<const void> hold);

/// The same with all of it on the heap: the caller may write to it. Works for tzc:: types, too.
template <class S>
boost::shared_ptr<S> make_copy(const std::uint8_t* control, std::size_t size,
                               const std::vector<ConstBlock>& blocks);

/// A stock message after encode(message, ..., encoded) that borrows the encoded buffers and keeps them. Seals them. Null only when `encoded` is not the result of
/// encoding an M.
template <class M>
boost::shared_ptr<const typename StockOf<M>::type> stock_view(const M& message, Encoded& encoded);

/// The same for callbacks of this process, which may write to it in spite of the const (tzc::view_for_callbacks): neither
/// `message` nor another view of it, nor another process sees that. Null also when there is no memory.
template <class M>
boost::shared_ptr<const typename StockOf<M>::type> callback_view(const M& message, Encoded& encoded);

/// The same as a private message that its owner may write to: one copy of all arrays.
template <class M>
boost::shared_ptr<typename StockOf<M>::type> stock_copy(const M& message, Encoded& encoded);

/// Binds all arrays of a tzc:: message to `memory` and moves those whose sizes are known there, into one
/// buffer; contents are kept. Published arrays stay shared until they are written; the memory for that copy
/// is taken now. Does nothing for stock messages. Returns false when `memory` is exhausted: the arrays stay
/// where they are, and a later publish tries again, with a copy.
template <class M>
bool allocate(M& message, const std::shared_ptr<MemorySource>& memory);

}  // namespace message
}  // namespace tzc

#include <tzc/detail/message_impl.h>
