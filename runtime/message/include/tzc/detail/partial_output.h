// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/generated_message_support.h>
#include <tzc/guard.h>
#include <tzc/memory.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tzc {
namespace message {

struct Encoded;

namespace detail {

/// The data arrays of a message may overlap in their blocks, but together they are at most this many times as
/// big: a hostile control part cannot make a copying subscriber fill its memory.
constexpr std::uint64_t most_overlap = 16;

/// Somebody who wants to know where an array was copied to; type-erased.
struct CopiedArray {
  const void* owner = nullptr;
  void (*note_sent)(const void* owner, const std::shared_ptr<MemorySource>& memory, const BufferPtr& buffer,
                    std::uint8_t* at) = nullptr;
};

/// Builds an Encoded: control bytes, array entries, and the copies that arrays outside of segments need.
class ControlWriter {
 public:
  explicit ControlWriter(Encoded& encoded);

  /// Memory for `size` control bytes, valid until the next call.
  std::uint8_t* advance(std::uint32_t size);
  /// An entry for an array that begins at that offset of `buffer`.
  void reference(const BufferPtr& buffer, std::size_t offset, std::size_t count, std::size_t element_size);
  /// An entry for an array that may lie anywhere.
  /// @param owner is told where its elements were copied to, if they are
  void array(const void* data, std::size_t count, std::size_t element_size,
             CopiedArray owner = CopiedArray());
  /// Copies the arrays that lie outside of segments. False when there is no memory for them, or an array is
  /// too long.
  bool finish(const std::shared_ptr<MemorySource>& memory);

 private:
  struct Copy {
    const void* data;
    std::size_t bytes;
    std::size_t entry;  // where in the control part
    CopiedArray owner;
  };

  bool begin_entry(std::size_t count, std::size_t element_size);
  bool is_overused() const;
  void end_entry(std::uint32_t block, std::uint64_t offset);
  std::uint32_t index_of(const BufferPtr& buffer);
  bool make_copies(const std::shared_ptr<MemorySource>& memory);

  Encoded& encoded_;
  std::vector<Copy> copies_;
  std::size_t copied_size_ = 0;
  std::uint64_t referenced_bytes_ = 0;
  bool too_long_ = false;
};

/// The stream that ROS serializers write to: takes data arrays out of the byte stream.
class PartialOutput : public ControlWriter {
 public:
  static const ros::serialization::StreamType stream_type = ros::serialization::stream_types::Output;

  using ControlWriter::ControlWriter;

  template <class T>
  void next(const T& value) {
    ros::serialization::serialize(*this, value);
  }
  template <class T>
  void next(const Array<T>& array) {
    // The room of an empty array stays writable, but guard mode is told: it may lie beside a published array.
    if (array.empty() && __builtin_expect(!guard::active, 1)) return this->array(nullptr, 0, sizeof(T));
    const auto elements = array.storage().share();
    if (elements.buffer && !array.empty())
      reference(elements.buffer, offset_in(*elements.buffer, elements.begin), array.size(), sizeof(T));
    else
      this->array(elements.begin, array.size(), sizeof(T),
                  CopiedArray{&array.storage(), &note_sent<tzc::detail::ArrayStorage<T> >});
  }
  template <class T, class Allocator>
  void next(const std::vector<T, Allocator>& vector) {
    next_vector(vector, typename ros::message_traits::IsFixedSize<T>::type());
  }
  /// A data array of elements that are `element_size` bytes each, for hand-written codecs.
  void next_array(const void* data, std::size_t count, std::size_t element_size) {
    array(data, count, element_size);
  }

 private:
  static std::size_t offset_in(const Buffer& buffer, const void* data) {
    return static_cast<std::size_t>(static_cast<const std::uint8_t*>(data) - buffer.data());
  }
  template <class Storage>
  static void note_sent(const void* storage, const std::shared_ptr<MemorySource>& memory,
                        const BufferPtr& buffer, std::uint8_t* at) {
    static_cast<const Storage*>(storage)->note_sent(memory, buffer, at);
  }
  template <class Vector>
  void next_vector(const Vector& vector, ros::message_traits::TrueType) {
    array(vector.data(), vector.size(), sizeof(typename Vector::value_type));
  }
  template <class Vector>
  void next_vector(const Vector& vector, ros::message_traits::FalseType) {
    next(static_cast<std::uint32_t>(vector.size()));
    for (const auto& element : vector) next(element);
  }
};

}  // namespace detail
}  // namespace message
}  // namespace tzc
