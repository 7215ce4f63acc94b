// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/publication_stream.h"

#include <ros/poll_manager.h>

#include <algorithm>
#include <boost/thread/lock_types.hpp>
#include <boost/thread/mutex.hpp>
#include <vector>

#include "roscpp/roscpp_access.h"

namespace tzc {
namespace detail {

PublicationStream::PublicationStream(const ros::PublicationPtr& publication,
                                     const std::shared_ptr<SegmentMemory>& memory, OnExhausted on_exhausted)
    : publication_(publication), memory_(memory), records_(publication->getName(), memory, on_exhausted) {}

std::uint64_t PublicationStream::most_held_bytes() const {
  const MemoryOptions& options = memory_->options();
  return (options.size != 0 ? options.size : options.ceiling) / 2;
}

OutgoingMessage PublicationStream::of_pointer(const ros::SerializedMessage& message) {
  return records_.of_pointer(message, links_, [&] { return take_number(message); });
}

OutgoingMessage PublicationStream::of_encoded(const std::type_info& type, message::Encoded& encoded) {
  const ros::PublicationPtr publication = publication_.lock();
  return records_.of_encoded(type, encoded, publication ? publication->incrementSequence() : 0);
}

std::uint32_t PublicationStream::take_number(const ros::SerializedMessage& message) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return 0;
  const SequenceNumbers::Taken taken = numbers_.take(message.buf.get(), publication->getSequence());
  if (taken.counts_now) publication->incrementSequence();
  // roscpp empties its queue at once only for subscribers that need bytes. A latched topic's bytes would stay
  // there for a while, and a new subscriber would get them after the last message.
  if (message.buf) ros::PollManager::instance()->getPollSet().signal();
  return taken.number;
}

std::uint32_t PublicationStream::foresee_number(std::size_t queued) const {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return 0;
  const std::uint32_t count = publication->getSequence();
  return links_ > 0 ? numbers_.next(count) : static_cast<std::uint32_t>(count + queued);
}

bool PublicationStream::would_overtake() const {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return false;
  // Against the order of locks, so it is tried. Who publishes holds the other mutex, too, and a topic that ends has it for a moment.
  const boost::unique_lock<boost::mutex> lock(roscpp_access::publish_queue_mutex_(*publication),
                                              boost::try_to_lock);
  return !lock.owns_lock() || waits(roscpp_access::publish_queue_(*publication).size());
}

// A link inside this process lets roscpp pass the pointer to all of them.
bool PublicationStream::leaves_to_bytes(const ros::SerializedMessage& message) {
  if (!message.buf) return false;
  if (!would_overtake()) {
    left_to_bytes_.clear();
    return false;
  }
  const bool is_next_link = !left_to_bytes_.empty() && left_to_bytes_.back() == message.buf;
  if (!is_next_link) left_to_bytes_.push_back(message.buf);
  return true;
}

bool PublicationStream::went_by_pointer(const ros::SerializedMessage& message) const {
  return message.type_info && records_.codecs().has(*message.type_info) &&
         std::find(left_to_bytes_.begin(), left_to_bytes_.end(), message.buf) == left_to_bytes_.end();
}

void PublicationStream::saw_serialized(const ros::SerializedMessage& message) {
  skip(numbers_.numbered(message.buf.get()));
  const auto found = std::find(left_to_bytes_.begin(), left_to_bytes_.end(), message.buf);
  if (found != left_to_bytes_.end()) left_to_bytes_.erase(left_to_bytes_.begin(), found);
}

void PublicationStream::set_links(std::size_t links) {
  const ros::PublicationPtr publication = publication_.lock();
  if (links_ == 0 && links > 0 && publication) {
    std::vector<const void*> queue;
    for (const ros::SerializedMessage& message : roscpp_access::publish_queue_(*publication))
      queue.push_back(message.buf.get());
    numbers_.follow(queue);
  }
  links_ = links;
}

void PublicationStream::skip(std::size_t numbers) {
  const ros::PublicationPtr publication = publication_.lock();
  for (; publication && numbers > 0; --numbers) publication->incrementSequence();
}

}  // namespace detail
}  // namespace tzc
