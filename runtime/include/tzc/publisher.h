// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publisher.h>
#include <tzc/detail/attachment.h>
#include <tzc/detail/shared_message.h>
#include <tzc/message.h>
#include <tzc/options.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <memory>
#include <string>
#include <type_traits>

namespace tzc {

/// A drop-in for ros::Publisher that publishes through shared memory to whoever can take it, and through TCPROS to
/// everybody else. Made by tzc::advertise. Copies share one advertisement; the last copy ends it. Thread-safe like
/// ros::Publisher.
class Publisher {
 public:
  Publisher() {}
  /// Takes over an advertisement and its attachment (null: a plain ros::Publisher). Used by tzc::advertise.
  Publisher(const ros::Publisher& publisher, std::shared_ptr<detail::Attachment> attachment)
      : publisher_(publisher), attachment_(std::move(attachment)) {}

  /// Publishes a message: a tzc:: message without a copy of what already lies in shared memory, a stock message with
  /// one copy into it. A tzc:: message's arrays are shared from here on: the next write to one gets fresh memory.
  template <class M>
  void publish(const M& message) const {
    publish_value(message);
  }
  /// The same by pointer. As with ros::Publisher the message must not be changed afterwards: subscribers in this
  /// process get this very object (a stock message) or a view of it (a tzc:: message).
  template <class M>
  void publish(const boost::shared_ptr<M>& message) const {
    publish_pointer(message, IsGenerated<typename std::remove_const<M>::type>());
  }

  /// Binds the message's arrays to this publisher's shared memory, now or as they grow. May be called before or after
  /// the sizes are set. False: no memory left (or TZC is off); the message stays usable and publish() delivers it.
  template <class M>
  bool allocate(M& message) const {
    return attachment_ && message::allocate(message, attachment_->memory());
  }
  template <class M>
  bool allocate(const boost::shared_ptr<M>& message) const {
    return allocate(*message);
  }

  /// The shared memory behind this publisher; null when TZC is off or the publisher is not advertised.
  std::shared_ptr<MemorySource> memory() const {
    return attachment_ ? attachment_->memory() : std::shared_ptr<MemorySource>();
  }
  PublisherStatistics statistics() const {
    return attachment_ ? attachment_->statistics() : PublisherStatistics();
  }

  /// \name As in ros::Publisher
  /// @{
  void shutdown() {
    if (attachment_) attachment_->shutdown();
    publisher_.shutdown();
    attachment_.reset();
  }
  std::string getTopic() const { return publisher_.getTopic(); }
  std::uint32_t getNumSubscribers() const { return publisher_.getNumSubscribers(); }
  bool isLatched() const { return publisher_.isLatched(); }
  operator void*() const { return publisher_; }
  bool operator<(const Publisher& rhs) const { return publisher_ < rhs.publisher_; }
  bool operator==(const Publisher& rhs) const { return publisher_ == rhs.publisher_; }
  bool operator!=(const Publisher& rhs) const { return publisher_ != rhs.publisher_; }
  boost::function<void(const ros::SubscriberLinkPtr&)> getLastMessageCallback() {
    return publisher_.getLastMessageCallback();
  }
  /// @}

  /// The stock publisher, for interfaces that ask for one. What is published through it goes to every subscriber too.
  const ros::Publisher& stock() const { return publisher_; }

 private:
  template <class M>
  using Stock = typename message::StockOf<M>::type;
  template <class M>
  using IsGenerated = std::integral_constant<bool, message::IsTwin<M>::value && !detail::IsForeign<M>::value>;

  template <class M>
  void publish_value(const M& message) const {
    const auto publish = [&] { publisher_.publish(message); };
    if (!attachment_)
      publish();
    else if (attachment_->wants_pointer(typeid(Stock<M>)) ||
             !attachment_->publish_by_reference(typeid(Stock<M>), publish))
      publish_shared(message);
  }

  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message, std::true_type) const {
    publish_value(*message);
  }
  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message, std::false_type) const {
    publisher_.publish(message);
  }

  template <class M>
  void publish_shared(const M& message) const {
    detail::SharedMessage<M> shared;
    if (!shared.encode(message, *attachment_->memory())) return publish_exhausted(message);
    if (attachment_->publish_directly(typeid(Stock<M>), shared.encoded)) return;
    if (!shared.look(message)) return publish_exhausted(message);
    const detail::EncodedScope scope(shared.view.get(), shared.encoded);
    publisher_.publish(shared.view);
  }

  template <class M>
  void publish_exhausted(const M& message) const {
    if (attachment_->delivers_exhausted())  // by pointer, as its neighbours, so that it keeps its place among them
      publisher_.publish(boost::make_shared<Stock<M>>(message::to_stock(message)));
    else
      attachment_->count_dropped();
  }

  ros::Publisher publisher_;
  std::shared_ptr<detail::Attachment> attachment_;
};

}  // namespace tzc
