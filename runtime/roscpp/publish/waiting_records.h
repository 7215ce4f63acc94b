// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/channel.h>

#include <cstddef>
#include <list>
#include <vector>

#include "roscpp/publish/socket_buffers.h"
#include "roscpp/publish/to_stock_bytes.h"

namespace tzc {
namespace detail {

/// Records that wait in a SharedLink for TCPROS or for the channel, oldest first. Holds as many as a TCPROS connection
/// would: the queue's, and besides them those that fit its socket buffers. Not thread-safe.
class WaitingRecords {
 public:
  /// `queue_size` 0: no limit.
  explicit WaitingRecords(std::size_t queue_size) : queue_size_(queue_size) {}

  /// Also without the mutex that guards the rest.
  std::size_t queue_size() const { return queue_size_; }
  bool empty() const { return records_.empty(); }
  const channel::RecordPtr& front() const { return records_.front(); }

  /// Drops the oldest records beyond the limit.
  void push(const channel::RecordPtr& record) {
    records_.push_back(record);
    bytes_ += size_of(record);
    while (queue_size_ != 0 && records_.size() > queue_size_ && bytes_ > kSocketBuffers) pop();
  }

  /// Drops all but those of the queue.
  void keep_newest() {
    while (queue_size_ != 0 && records_.size() > queue_size_) pop();
  }

  /// Puts older records before the others, and drops none.
  void push_before(const std::vector<channel::RecordPtr>& older) {
    records_.insert(records_.begin(), older.begin(), older.end());
    for (const channel::RecordPtr& record : older) bytes_ += size_of(record);
  }

  void pop() {
    bytes_ -= size_of(records_.front());
    records_.pop_front();
  }

 private:
  const std::size_t queue_size_;
  std::list<channel::RecordPtr> records_;  // empty for as long as records do not wait: then it has no memory
  std::size_t bytes_ = 0;
};

}  // namespace detail
}  // namespace tzc
