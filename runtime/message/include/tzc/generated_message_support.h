// SPDX-License-Identifier: BSD-3-Clause
// What generated message headers (tzc/<package>/<Type>.h) need, and the only place where they meet the
// runtime.
#pragma once

#include <tzc/array.h>
#include <tzc/message_array.h>

#include <ros/builtin_message_traits.h>
#include <ros/message_operations.h>
#include <ros/serialization.h>
#include <ros/types.h>

#include <boost/array.hpp>
#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace tzc {
namespace message {

/// What a generated header states about its message. The primary template serves stock messages, which have no
/// tzc::Array. A specialisation has what follows; visit_data calls v(array) for each data array, at any depth, in
/// wire order, and visit_message_arrays for each MessageArray:
///
///     typedef ::pkg::Type Stock;
///     typedef std::true_type Generated;
///     template <class V> static void visit_data(tzc::pkg::Type&, V&& v);
///     template <class V> static void visit_data(const tzc::pkg::Type&, V&& v);
///     template <class V> static void visit_message_arrays(tzc::pkg::Type&, V&& v);
///     template <class V> static void visit_message_arrays(const tzc::pkg::Type&, V&& v);
template <class M>
struct Traits {
  typedef M Stock;
  template <class Message, class Visitor>
  static void visit_data(Message&, Visitor&&) {}
  template <class Message, class Visitor>
  static void visit_message_arrays(Message&, Visitor&&) {}
};

/// The stock type of a tzc:: message, or of a stock message itself.
template <class M>
struct StockOf {
  typedef typename Traits<typename std::remove_cv<M>::type>::Stock type;
};

/// True for tzc:: messages, and for types of other libraries that travel as another type's messages (pcl::PointCloud).
template <class M>
struct IsTwin : std::integral_constant<
                    bool, !std::is_same<typename StockOf<M>::type, typename std::remove_cv<M>::type>::value> {
};

/// True for tzc:: messages alone. Names inside a message are its definition's, so they tell nothing.
template <class M>
struct IsGenerated {
 private:
  template <class T>
  static typename Traits<T>::Generated test(int);
  template <class T>
  static std::false_type test(...);

 public:
  static constexpr bool value = decltype(test<typename std::remove_cv<M>::type>(0))::value;
};

/// A deep copy as the stock type; all of it lies on the heap.
template <class M>
typename StockOf<M>::type to_stock(const M& message) {
  return static_cast<typename StockOf<M>::type>(message);
}

namespace detail {

template <class M>
boost::shared_ptr<typename StockOf<M>::type> make_stock(const M& message, std::true_type) {
  const auto stock = boost::make_shared<typename StockOf<M>::type>();
  message._copy_to(*stock);
  return stock;
}
template <class M>
boost::shared_ptr<typename StockOf<M>::type> make_stock(const M& message, std::false_type) {
  return boost::make_shared<typename StockOf<M>::type>(message);
}

}  // namespace detail

/// The same where it stays: a message with large arrays of fixed length does not fit a stack.
template <class M>
boost::shared_ptr<typename StockOf<M>::type> make_stock(const M& message) {
  return detail::make_stock(message, std::integral_constant<bool, IsGenerated<M>::value>());
}

}  // namespace message
}  // namespace tzc

namespace ros {
namespace serialization {

/// The stock wire format of a data array, the same bytes as for std::vector.
template <class T>
struct Serializer<tzc::Array<T> > {
  typedef typename message_traits::IsSimple<T>::type Simple;

  template <class Stream>
  static void write(Stream& stream, const tzc::Array<T>& array) {
    stream.next(static_cast<std::uint32_t>(array.size()));
    write_elements(stream, array, Simple());
  }

  /// Throws StreamOverrunException before it reserves memory for elements that the stream does not have.
  template <class Stream>
  static void read(Stream& stream, tzc::Array<T>& array) {
    std::uint32_t count;
    stream.next(count);
    if (std::uint64_t(count) * least_length() > stream.getLength()) throwStreamOverrun();
    array.resize(count, tzc::uninitialized);
    read_elements(stream, array, Simple());
  }

  static std::uint32_t serializedLength(const tzc::Array<T>& array) {
    return 4 + static_cast<std::uint32_t>(array.size()) * element_length();
  }

 private:
  /// Elements have a fixed length, so a default one tells it.
  static std::uint32_t element_length() {
    static const std::uint32_t length = serializationLength(*tzc::detail::ElementCopy<T>());
    return length;
  }
  /// Elements without fields (std_msgs/Empty) take memory, too, and the stream has nothing of them: a byte each must do.
  static std::uint32_t least_length() { return element_length() != 0 ? element_length() : 1; }

  template <class Stream>
  static void write_elements(Stream& stream, const tzc::Array<T>& array, message_traits::TrueType) {
    const std::uint32_t bytes = static_cast<std::uint32_t>(array.size() * sizeof(T));
    if (bytes != 0) std::memcpy(stream.advance(bytes), array.data(), bytes);
  }
  template <class Stream>
  static void write_elements(Stream& stream, const tzc::Array<T>& array, message_traits::FalseType) {
    for (const T& element : array) stream.next(element);
  }

  template <class Stream>
  static void read_elements(Stream& stream, tzc::Array<T>& array, message_traits::TrueType) {
    const std::uint32_t bytes = static_cast<std::uint32_t>(array.size() * sizeof(T));
    if (bytes != 0) std::memcpy(static_cast<void*>(array.data()), stream.advance(bytes), bytes);
  }
  template <class Stream>
  static void read_elements(Stream& stream, tzc::Array<T>& array, message_traits::FalseType) {
    std::uninitialized_fill(array.begin(), array.end(), *tzc::detail::ElementCopy<T>());
    for (T& element : array) stream.next(element);
  }
};

/// It travels as the vector that it is.
template <class T>
struct Serializer<tzc::MessageArray<T> > {
  template <class Stream>
  static void write(Stream& stream, const std::vector<T>& messages) {
    stream.next(messages);
  }
  template <class Stream>
  static void read(Stream& stream, std::vector<T>& messages) {
    stream.next(messages);
  }
  static std::uint32_t serializedLength(const std::vector<T>& messages) {
    return serializationLength(messages);
  }
};

}  // namespace serialization
}  // namespace ros
