// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <message_filters/subscriber.h>
#include <tzc/subscribe.h>

#include <string>

namespace tzc {
namespace message_filters {

/// A drop-in for message_filters::Subscriber, with shared memory. Filter callbacks that may write to the
/// message get a private copy: message_filters' own subscriber passes the message itself to a lone writer,
/// but here that message is read-only.
template <class M>
class Subscriber : public ::message_filters::SubscriberBase, public ::message_filters::SimpleFilter<M> {
 public:
  typedef boost::shared_ptr<M const> MConstPtr;
  typedef ros::MessageEvent<M const> EventType;

  Subscriber() {}
  Subscriber(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
             const ros::TransportHints& hints = ros::TransportHints(),
             ros::CallbackQueueInterface* callback_queue = nullptr) {
    subscribe(node, topic, queue_size, hints, callback_queue);
  }
  ~Subscriber() override { Subscriber::unsubscribe(); }

  void subscribe(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
                 const ros::TransportHints& hints = ros::TransportHints(),
                 ros::CallbackQueueInterface* callback_queue = nullptr) override {
    unsubscribe();
    if (topic.empty()) return;
    options_.template initByFullCallbackType<const EventType&>(
        topic, queue_size, [this](const EventType& event) { pass_on(event); });
    options_.helper = boost::make_shared<Reader>([this](const EventType& event) { pass_on(event); });
    options_.callback_queue = callback_queue;
    options_.transport_hints = hints;
    subscriber_ = ::tzc::subscribe<M>(node, options_);  // the caller's, so that its shutdown() ends it
    node_ = node;
  }
  /// Subscribes again with the options of the last call.
  void subscribe() override {
    unsubscribe();
    if (!options_.topic.empty()) subscriber_ = ::tzc::subscribe<M>(node_, options_);
  }
  void unsubscribe() override { subscriber_.shutdown(); }

  std::string getTopic() const { return options_.topic; }
  const ros::Subscriber& getSubscriber() const { return subscriber_; }

  /// \name A source: filters' common interface without an input
  /// @{
  template <class Filter>
  void connectInput(Filter&) {}
  void add(const EventType&) {}
  /// @}

 private:
  /// Needs no copy of its own: pass_on() copies the message for filters behind it that may write.
  using Reader = ::tzc::detail::ReadingCallbackT<const EventType&>;

  void pass_on(const EventType& event) {
    const bool writers_need_a_copy = true;
    this->signalMessage(EventType(event, writers_need_a_copy));
  }

  ros::NodeHandle node_;
  ros::SubscribeOptions options_;
  ros::Subscriber subscriber_;
};

/// `filter.subscribe(node, ...)` where the filter must stay message_filters' own, for example because a library's class has it; the topic
/// uses shared memory. Whoever is behind the filter may write to its messages, so it gets private copies, and with it each callback of the
/// topic in this process. filter.subscribe() and filter.unsubscribe() do what they did.
template <class M>
void subscribe(::message_filters::Subscriber<M>& filter, ros::NodeHandle& node, const std::string& topic,
               std::uint32_t queue_size, const ros::TransportHints& hints = ros::TransportHints(),
               ros::CallbackQueueInterface* callback_queue = nullptr) {
  if (!topic.empty()) ::tzc::attach<M>(node, topic);
  filter.subscribe(node, topic, queue_size, hints, callback_queue);
}

}  // namespace message_filters
}  // namespace tzc
