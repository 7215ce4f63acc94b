// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publisher.h>
#include <tzc/detail/publisher_base.h>
#include <tzc/detail/roscpp_publish.h>
#include <tzc/detail/shared_message.h>
#include <tzc/message.h>
#include <tzc/options.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <type_traits>

namespace tzc {

/// A drop-in for ros::Publisher that publishes over shared memory to subscribers that can use it, and over
/// TCPROS to all others. Made by tzc::advertise. Copies share one advertisement; the last copy ends it.
/// Thread-safe like ros::Publisher.
class Publisher : public detail::PublisherBase<ros::Publisher> {
 public:
  /// The second form takes over an advertisement and its attachment. Used by tzc::advertise.
  using detail::PublisherBase<ros::Publisher>::PublisherBase;
  Publisher() {}

  /// Publishes a message: a tzc:: message without a copy of what already lies in shared memory, a stock
  /// message with one copy into it. Afterwards the arrays of a tzc:: message are shared: the next write to
  /// one gets fresh memory.
  template <class M>
  void publish(const M& message) const {
    publish_value(message, ByReference::yes, message::HasPartialForm<M>());
  }
  /// The same by pointer. As with ros::Publisher the message must not be changed afterwards: subscribers in
  /// this process get the object itself (a stock message) or a view of it (a tzc:: message).
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
  using IsGenerated = std::integral_constant<bool, message::IsGenerated<M>::value>;

  template <class M>
  void publish_value(const M& message, ByReference how, std::true_type) const {
    if (!publish_by_reference<Stock<M>>([&] { publish_plainly(message); })) publish_shared(message, how);
  }
  /// roscpp serializes it, also for subscribers on shared memory.
  template <class M>
  void publish_value(const M& message, ByReference, std::false_type) const {
    publish_plainly(message);
  }

  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message, std::true_type) const {
    publish_value(*message, ByReference::no, message::HasPartialForm<M>());
  }
  template <class M>
  void publish_pointer(const boost::shared_ptr<M>& message, std::false_type) const {
    introduce<typename std::remove_const<M>::type>(IsForeign<M>());
    publish_plainly(message);
  }

  /// roscpp's publish.
  template <class M>
  void publish_plainly(const M& message) const {
    detail::publish_by_roscpp(publisher_, message, [&] { publisher_.publish(message); });
  }
  template <class M>
  void publish_plainly(const boost::shared_ptr<M>& message) const {
    if (attachment_) attachment_->send_queued();
    detail::publish_by_roscpp(publisher_, *message, [&] { publisher_.publish(message); });
  }

  /// Adds the codec of a foreign type (pcl::PointCloud) that differs from the type that the topic was
  /// advertised with.
  template <class M>
  void introduce(std::true_type) const {
    if (attachment_ && !attachment_->knows(typeid(M))) attachment_->add_codec(detail::make_codec<M>());
  }
  template <class M>
  void introduce(std::false_type) const {}

  template <class M>
  void publish_shared(const M& message, ByReference how) const {
    detail::SharedMessage<M> shared;
    if (!publisher_) return publisher_.publish(message);  // logs the error
    if (!shared.encode(message, attachment_->memory())) return publish_exhausted(message);
    if (attachment_->publish_directly(typeid(Stock<M>), shared.encoded)) return;
    const auto publish = [&](const boost::shared_ptr<const Stock<M>>& view) {
      detail::publish_by_roscpp(publisher_, *view, [&] { publisher_.publish(view); });
    };
    if (!shared.publish_view(*attachment_, message, how, detail::Others::wait, publish))
      publish_exhausted(message);
  }

  template <class M>
  void publish_exhausted(const M& message) const {
    // By pointer, as the messages before and after it, so that their order stays.
    if (attachment_->delivers_exhausted())
      publish_plainly(private_copy(message, detail::IsForeign<M>()));
    else
      attachment_->count_dropped(ros::serialization::serializationLength(message));
  }
  template <class M>
  static boost::shared_ptr<Stock<M>> private_copy(const M& message, std::false_type) {
    return message::make_stock(message);
  }
  /// The foreign library's adapter serializes it; TZC knows no conversion to the stock type.
  template <class M>
  static boost::shared_ptr<M> private_copy(const M& message, std::true_type) {
    return boost::make_shared<M>(message);
  }
};

}  // namespace tzc
