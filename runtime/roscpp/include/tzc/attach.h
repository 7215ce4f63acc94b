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

/// Attaches shared memory to the topic of a publisher that other code advertised, for example a library's
/// base class that keeps a copy of it. M: as for advertise. When the topic has another type, the result
/// publishes as `publisher` does, without shared memory.
template <class M>
Publisher attach_publisher(const ros::Publisher& publisher, std::size_t memory_size = 0) {
  if (!publisher) return Publisher(publisher, nullptr);
  const ros::AdvertiseOptions options = detail::advertise_options<M>(publisher.getTopic(), 1);
  PublisherOptions publisher_options;
  publisher_options.memory_size = memory_size;
  return Publisher(publisher, detail::Attach<M>::join(options, publisher_options));
}

namespace detail {
/// The attachment of a topic that other code advertises, for as long as it does; null: the topic has another type, or TZC is off.
template <class M>
std::shared_ptr<Attachment> lasting_attachment(const std::string& resolved_topic, std::true_type) {
  typedef typename message::StockOf<M>::type Stock;
  const std::shared_ptr<Attachment> attachment =
      Attachment::lasting(resolved_topic, ros::message_traits::md5sum<Stock>(), &make_codec<Stock>);
  if (!attachment) return nullptr;
  // Types with the same fields have the same md5sum, whatever their names.
  if (!attachment->knows(typeid(Stock))) attachment->add_codec(make_codec<Stock>());
  return attachment->knows(typeid(M)) ? attachment : with_foreign_codec<M>(attachment);
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
}  // namespace detail

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
