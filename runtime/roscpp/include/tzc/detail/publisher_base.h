// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/attachment.h>
#include <tzc/detail/find_publisher.h>
#include <tzc/detail/shared_message.h>
#include <tzc/message.h>
#include <tzc/options.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace tzc {
namespace detail {

/// Base of all publishers: a stock publisher that does the work (ros::Publisher, or one of
/// image_transport's), and the shared memory attached to it. Copies share both; the last copy ends them.
/// Thread-safe like the stock publisher.
template <class Stock>
class PublisherBase {
 public:
  PublisherBase() {}
  /// `attachment` null: a plain publisher.
  PublisherBase(const Stock& publisher, std::shared_ptr<Attachment> attachment)
      : publisher_(publisher), attachment_(std::move(attachment)) {}
  PublisherBase(const PublisherBase&) = default;
  PublisherBase& operator=(const PublisherBase&) = default;
  /// What was moved from is as the stock publisher is then: a ros::Publisher is what it was, image_transport's are empty.
  PublisherBase(PublisherBase&& other) noexcept(std::is_nothrow_move_constructible<Stock>::value)
      : publisher_(std::move(other.publisher_)), attachment_(handed_over(other)) {}
  PublisherBase& operator=(PublisherBase&& other) noexcept(std::is_nothrow_move_assignable<Stock>::value) {
    publisher_ = std::move(other.publisher_);
    attachment_ = handed_over(other);
    return *this;
  }

  /// Binds the message's arrays to this publisher's shared memory, now or as they grow. May be called before
  /// or after the sizes are set. Any publisher of this process can publish it without a copy, so one that is not advertised
  /// gives shared memory, too, once another one is. False: no memory left (or TZC is off); the message stays usable and
  /// publish() delivers it.
  template <class M>
  bool allocate(M& message) const {
    return attachment_ ? message::allocate(message, attachment_->memory())
                       : message::allocate(message, memory());
  }
  template <class M>
  bool allocate(const boost::shared_ptr<M>& message) const {
    return allocate(*message);
  }

  /// The shared memory behind this publisher, or, while it is not advertised, that of the process's messages of no topic. Null when
  /// TZC is off for the node or the topic, and while no publisher of the process has shared memory.
  std::shared_ptr<MemorySource> memory() const {
    if (attachment_) return attachment_->memory();
    return publisher_ ? std::shared_ptr<MemorySource>() : memory_of_no_topic();
  }
  /// A read-only stock message over the bytes of a tzc:: message, for code that takes stock messages. Arrays
  /// outside of this publisher's shared memory are copied there, the others are not copied unless they take less than a page or
  /// another view of them lives. What is written to it in spite of the const stays in it. Costs as much as
  /// publishing the message and has the same effect on it: the next write to an array gets fresh memory. Any
  /// publisher of this process can publish the result without a copy. Never null: without shared memory it is
  /// a copy. To convert back, `M(stock)` makes a deep copy.
  template <class M>
  boost::shared_ptr<const typename message::StockOf<M>::type> stock_view(const M& message) const {
    SharedMessage<M> shared;
    if (attachment_ && shared.encode(message, attachment_->memory()))
      if (const auto view = message::callback_view(message, shared.encoded)) return view;
    return message::make_stock(message);
  }

  PublisherStatistics statistics() const {
    return attachment_ ? attachment_->statistics() : PublisherStatistics();
  }

  /// \name As in the stock publisher
  /// @{
  void shutdown() {
    if (attachment_) attachment_->shutdown();
    publisher_.shutdown();
    attachment_.reset();
  }
  std::string getTopic() const { return publisher_.getTopic(); }
  std::uint32_t getNumSubscribers() const { return publisher_.getNumSubscribers(); }
  operator void*() const { return publisher_; }
  bool operator<(const PublisherBase& rhs) const { return publisher_ < rhs.publisher_; }
  bool operator==(const PublisherBase& rhs) const { return publisher_ == rhs.publisher_; }
  bool operator!=(const PublisherBase& rhs) const { return publisher_ != rhs.publisher_; }
  // With a stock publisher, which has no more conversions than this one, the language would compare whether both are valid.
  friend bool operator<(const PublisherBase& one, const Stock& other) { return one.publisher_ < other; }
  friend bool operator<(const Stock& one, const PublisherBase& other) { return one < other.publisher_; }
  friend bool operator==(const PublisherBase& one, const Stock& other) { return one.publisher_ == other; }
  friend bool operator==(const Stock& one, const PublisherBase& other) { return one == other.publisher_; }
  friend bool operator!=(const PublisherBase& one, const Stock& other) { return one.publisher_ != other; }
  friend bool operator!=(const Stock& one, const PublisherBase& other) { return one != other.publisher_; }
  /// @}

  /// The stock publisher, for interfaces that need one. What is published through it goes to every
  /// subscriber, too.
  const Stock& stock() const { return publisher_; }

 protected:
  typedef detail::ByReference ByReference;

  /// Calls `publish`, which publishes a message of roscpp type M by reference, and returns true. When a
  /// subscriber takes such messages by pointer it does nothing and returns false.
  template <class M, class Publish>
  bool publish_by_reference(Publish publish) const {
    if (attachment_)
      return !attachment_->wants_pointer(typeid(M)) && attachment_->publish_by_reference(typeid(M), publish);
    publish();
    return true;
  }

  Stock publisher_;
  std::shared_ptr<Attachment> attachment_;

 private:
  /// The attachment of one whose stock publisher was moved from.
  static std::shared_ptr<Attachment> handed_over(PublisherBase& from) {
    return from.publisher_ ? from.attachment_ : std::move(from.attachment_);
  }
};

}  // namespace detail
}  // namespace tzc
