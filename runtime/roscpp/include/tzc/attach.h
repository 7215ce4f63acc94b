// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/publisher.h>
#include <tzc/advertise.h>
#include <tzc/publisher.h>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <typeinfo>

namespace tzc {

namespace detail {

/// Adds what M needs to an attachment of its topic, which may be null.
template <class M>
std::shared_ptr<Attachment> with_codecs_for(const std::shared_ptr<Attachment>& attachment) {
  typedef typename message::StockOf<M>::type Stock;
  if (!attachment) return nullptr;
  // Types with the same fields have the same md5sum, whatever their names.
  if (!attachment->knows(typeid(Stock))) attachment->add_codec(make_codec<Stock>());
  return attachment->knows(typeid(M)) ? attachment : with_foreign_codec<M>(attachment);
}

/// The attachment of a topic that other code advertises, for as long as it does; null: the topic has another type, or TZC is off.
template <class M>
std::shared_ptr<Attachment> lasting_attachment(const std::string& resolved_topic, std::true_type) {
  typedef typename message::StockOf<M>::type Stock;
  return with_codecs_for<M>(
      Attachment::lasting(resolved_topic, ros::message_traits::md5sum<Stock>(), &make_codec<Stock>));
}
/// It has no partial form.
template <class M>
std::shared_ptr<Attachment> lasting_attachment(const std::string&, std::false_type) {
  return nullptr;
}
template <class M>
std::shared_ptr<Attachment> lasting_attachment(const ros::Publisher& publisher) {
  if (!publisher) return nullptr;
  return lasting_attachment<M>(publisher.getTopic(), message::HasPartialForm<M>());
}

/// Likewise for a publisher that keeps it, with so many bytes of shared memory (0: sized by queue and message).
template <class M>
std::shared_ptr<Attachment> joined_attachment(const std::string& resolved_topic, std::size_t memory_size,
                                              std::true_type) {
  typedef typename message::StockOf<M>::type Stock;
  PublisherOptions options;
  options.memory_size = memory_size;
  return with_codecs_for<M>(
      Attachment::join(resolved_topic, ros::message_traits::md5sum<Stock>(), &make_codec<Stock>, options));
}
template <class M>
std::shared_ptr<Attachment> joined_attachment(const std::string&, std::size_t, std::false_type) {
  return nullptr;
}

}  // namespace detail

/// Attaches shared memory to the topic of a publisher that other code advertised, for example a library's
/// base class that keeps a copy of it, for as long as the program advertises the topic. M: as for advertise. When the topic has
/// another type, the result publishes as `publisher` does, without shared memory. Thread-safe.
template <class M>
Publisher attach_publisher(const ros::Publisher& publisher, std::size_t memory_size = 0) {
  if (!publisher) return Publisher(publisher, nullptr);
  return Publisher(publisher, detail::joined_attachment<M>(publisher.getTopic(), memory_size,
                                                           message::HasPartialForm<M>()));
}

/// The same where the publisher must stay a ros::Publisher, for example because a library's object gets a copy of it: attaches shared
/// memory to its topic, sized by queue and message, for as long as the program advertises it, and returns the publisher. A stock
/// message that anybody publishes with it is copied once into shared memory, by reference after roscpp's serialization. When the topic has
/// another type, or M has no partial form, the topic stays on TCPROS. Thread-safe.
template <class M>
ros::Publisher attached(const ros::Publisher& publisher) {
  detail::lasting_attachment<M>(publisher);
  return publisher;
}

}  // namespace tzc
