// SPDX-License-Identifier: BSD-3-Clause
#include "recorder/bag_writer.h"

namespace tzc::compare {

BagWriter::BagWriter(const std::string& path) {
  bag_.open(path, rosbag::bagmode::Write);
  thread_ = std::thread([this] { run(); });
}

BagWriter::~BagWriter() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_one();
  thread_.join();
  bag_.close();
}

void BagWriter::add(Entry entry) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    queue_.push_back(std::move(entry));
  }
  changed_.notify_one();
}

std::string BagWriter::error() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return error_;
}

void BagWriter::run() {
  for (;;) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return is_ending_ || !queue_.empty(); });
    if (queue_.empty()) return;
    const Entry entry = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    write(entry);
  }
}

void BagWriter::write(const Entry& entry) {
  try {
    bag_.write(entry.topic, entry.received, entry.message, entry.connection_header);
  } catch (const rosbag::BagException& failure) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (error_.empty()) error_ = failure.what();
  }
}

}  // namespace tzc::compare
