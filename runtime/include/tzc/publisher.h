// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publisher.h>
#include <tzc/detail/publisher_base.h>
#include <tzc/detail/shared_message.h>
#include <tzc/message.h>
#include <tzc/options.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <type_traits>

namespace tzc {

/// A drop-in for ros::Publisher that publishes through shared memory to whoever can take it, and through
/// TCPROS to everybody else. Made by tzc::advertise. Copies share one advertisement; the last copy ends it.
/// Thread-safe like ros::Publisher.
class Publisher : public detail::PublisherBase<ros::Publisher> {
 public:
  /// The second form takes over an advertisement and its attachment. Used by tzc::advertise.
  using detail::PublisherBase<ros::Publisher>::PublisherBase;
  Publisher() {}

  /// Publishes a message: a tzc:: message without a copy of what already lies in shared memory, a stock
  /// message with one copy into it. A tzc:: message's arrays are shared from here on: the next write to one
  /// gets fresh memory.
  template <class M>
  void publish(const M& message) const {
    publish_value(message, message::HasPartialForm<M>());
  }
  /// The same by pointer. As with ros::Publisher the message must not be changed afterwards: subscribers in
  /// this process get this very object (a stock message) or a view of it (a tzc:: message).
  template <class M>
  void publish(const boost::shared_ptr<M>& message) const {
    publish_pointer(message, IsGenerated<typename std::remove_const<M>::type>());
  }

  bool isLatched() const { return publisher_.isLatched(); }
  boost::function<void(const ros::SubscriberLinkPtr&)> getLastMessageCallback() {
    return publisher_.getLastMessageCallback();
  }

 private:
  template <class M>
  using Stock = typename message::StockOf<M>::type;
  template <class M>
  using IsForeign = typename detail::IsForeign<typename std::remove_const<M>::type>::type;
  template <class M>
  using IsGenerated = std::integral_constant<bool, message::IsTwin<M>::value && !IsForeign<M>::value>;

  template <class M>
  void publish_value(const M& message, std::true_type) const {
    if (!publish_by_reference<Stock<M>>([&] { publisher_.publish(message); })) publish_shared(message);
  }
  /// roscpp makes bytes of it, for those on shared memory, too.
  template <class M>
  void publish_value(const M& message, std::false_type) const {
    publisher_.publish(message);
  }

  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message, std::true_type) const {
    publish(*message);
  }
  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message, std::false_type) const {
    introduce<typename std::remove_const<M>::type>(IsForeign<M>());
    publisher_.publish(message);
  }

  /// A cloud's type is not that of its topic, unless the topic was advertised for it.
  template <class M>
  void introduce(std::true_type) const {
    if (attachment_ && !attachment_->knows(typeid(M))) attachment_->add_codec(detail::make_codec<M>());
  }
  template <class M>
  void introduce(std::false_type) const {}

  template <class M>
  void publish_shared(const M& message) const {
    detail::SharedMessage<M> shared;
    if (!publisher_) return publisher_.publish(message);  // which complains
    if (!shared.encode(message, *attachment_->memory())) return publish_exhausted(message);
    if (attachment_->publish_directly(typeid(Stock<M>), shared.encoded)) return;
    if (!shared.look(message)) return publish_exhausted(message);
    const detail::EncodedScope scope(shared.view.get(), shared.encoded);
    publisher_.publish(shared.view);
  }

  template <class M>
  void publish_exhausted(const M& message) const {
    if (attachment_
            ->delivers_exhausted())  // by pointer, as its neighbours, so that it keeps its place among them
      publisher_.publish(private_copy(message, detail::IsForeign<M>()));
    else
      attachment_->count_dropped();
  }
  template <class M>
  static boost::shared_ptr<Stock<M>> private_copy(const M& message, std::false_type) {
    return boost::make_shared<Stock<M>>(message::to_stock(message));
  }
  /// The foreign library's adapter serializes it; no conversion to the stock type is known here.
  template <class M>
  static boost::shared_ptr<M> private_copy(const M& message, std::true_type) {
    return boost::make_shared<M>(message);
  }
};

}  // namespace tzc
