// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

namespace tzc::compare {

/// Writes messages to a bag on a thread of its own, so that a slow disk does not delay what is measured.
class BagWriter {
 public:
  explicit BagWriter(const std::string& path);
  /// Writes what is queued and closes the bag.
  ~BagWriter();

  struct Entry {
    std::string topic;
    ros::Time received;
    topic_tools::ShapeShifter::ConstPtr message;
    boost::shared_ptr<ros::M_string> connection_header;
  };
  void add(Entry entry);
  /// Why the bag could not be written; empty: no error.
  std::string error() const;

 private:
  void run();
  void write(const Entry& entry);

  rosbag::Bag bag_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> queue_;
  bool is_ending_ = false;
  std::string error_;
  std::thread thread_;
};

}  // namespace tzc::compare
