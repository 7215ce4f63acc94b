// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>
#include <ros/subscriber_link.h>
#include <tzc/options.h>

#include <atomic>
#include <boost/shared_array.hpp>
#include <cstdint>
#include <list>
#include <memory>

#include "roscpp/publish/record_encoder.h"
#include "roscpp/publish/sequence_numbers.h"

namespace tzc {
namespace detail {

/// The messages of one topic as records with sequence numbers: encoded once, sent by each SharedLink. Calls
/// happen under Publication::subscriber_links_mutex_, except where another rule is given.
class PublicationStream {
 public:
  PublicationStream(const ros::PublicationPtr& publication, const std::shared_ptr<SegmentMemory>& memory,
                    OnExhausted on_exhausted);

  /// Any thread.
  RecordEncoder& records() { return records_; }
  const RecordEncoder& records() const { return records_; }
  /// Number of links that take what is published. Any thread.
  std::size_t links() const { return links_; }
  /// Bytes of the memory that the views of one subscriber may hold. Any thread.
  std::uint64_t most_held_bytes() const;

  /// \name The record of a message; each link calls this once
  /// @{
  OutgoingMessage of_pointer(const ros::SerializedMessage& message);
  OutgoingMessage of_bytes(const ros::SerializedMessage& message) {
    return records_.of_bytes(message, links_);
  }
  /// For one subscriber alone. Any thread.
  OutgoingMessage of_bytes_alone(const ros::SerializedMessage& message) {
    return records_.of_bytes_alone(message);
  }
  OutgoingMessage of_encoded(const std::type_info& type, message::Encoded& encoded);
  /// @}

  /// Returns the number that the message will get that is published next; the caller holds advertised_topics_mutex_ until
  /// then, and a PublicationLock now.
  /// @param queued number of messages in roscpp's queue
  std::uint32_t foresee_number(std::size_t queued) const;
  /// Whether a message in roscpp's queue, of so many, has not gone to the links by pointer; a PublicationLock is held.
  bool waits(std::size_t queued) const { return queued > (links_ > 0 ? numbers_.queued() : 0); }
  /// Whether a message that is published by pointer now would overtake one that waits as bytes in roscpp's queue. The caller holds
  /// advertised_topics_mutex_; otherwise it is a guess.
  bool would_overtake() const;
  /// The same of this message, whose bytes roscpp is going to queue in any case: true, and the links do not take it but with them.
  bool leaves_to_bytes(const ros::SerializedMessage& message);
  /// Whether the links have taken a message, which they get as bytes now, by pointer.
  bool went_by_pointer(const ros::SerializedMessage& message) const;
  /// roscpp has numbered a message and passes it to the links as bytes.
  void saw_serialized(const ros::SerializedMessage& message);
  /// Sets the number of links that take what is published. With the first one the stream begins to follow
  /// roscpp's queue.
  void set_links(std::size_t links);
  /// The last link is gone, including those that returned to TCPROS.
  void forget_queue() {
    left_to_bytes_.clear();
    skip(numbers_.forget());
  }

 private:
  std::uint32_t take_number(const ros::SerializedMessage& message);
  void skip(std::size_t numbers);

  const ros::PublicationWPtr publication_;
  const std::shared_ptr<SegmentMemory> memory_;
  RecordEncoder records_;
  SequenceNumbers numbers_;
  std::list<boost::shared_array<std::uint8_t>> left_to_bytes_;  ///< in the order of roscpp's queue
  std::atomic<std::size_t> links_{0};
};

}  // namespace detail
}  // namespace tzc
