// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tzc/channel.h"

// A tiny language for channel tests: a publisher, an inbox that subscribes to it, and waiting for things to
// come true.

namespace tzc {
namespace channel {
namespace test {

constexpr std::size_t mb = 1 << 20;

inline bool eventually(const std::function<bool()>& condition, int milliseconds = 60000) {
  for (int i = 0; i < milliseconds; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

/// How many descriptors this process has open.
inline int open_descriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<int>(std::distance(begin(all), end(all)));
}

inline std::shared_ptr<SegmentMemory> memory_of(std::size_t size, Policy policy = Policy()) {
  MemoryOptions options;
  options.size = size;
  options.policy = policy;
  return *SegmentMemory::create(options);
}

inline std::shared_ptr<Publisher> publish_with(PublisherOptions options) {
  auto publisher = Publisher::create(std::move(options));
  EXPECT_TRUE(publisher) << publisher.error().text();
  return *publisher;
}

inline std::shared_ptr<Publisher> publisher(std::size_t queue_size = 10, std::size_t memory_size = 16 * mb,
                                            Policy policy = Policy()) {
  PublisherOptions options;
  options.queue_size = queue_size;
  options.memory = memory_of(memory_size, policy);
  return publish_with(std::move(options));
}

inline BufferPtr filled(MemorySource& memory, std::size_t bytes, unsigned char value) {
  BufferPtr buffer = memory.allocate(bytes);
  if (buffer) std::memset(buffer->data(), value, buffer->size());
  return buffer;
}

inline RecordPtr text_record(const std::string& text, const std::vector<BufferPtr>& buffers = {}) {
  return make_record(7, text.data(), text.size(), buffers);
}

inline std::string control_of(const MessagePtr& message) {
  return std::string(reinterpret_cast<const char*>(message->control()), message->control_size());
}

inline bool all_bytes_are(const ConstBlock& block, unsigned char value) {
  for (std::size_t i = 0; i < block.size; ++i) {
    if (block.data[i] != value) return false;
  }
  return true;
}

/// Subscribers of most tests have the thread that they share; TZC_TEST_OWN_THREAD=1 gives each one of its own.
inline bool on_shared_thread() {
  return std::getenv("TZC_TEST_OWN_THREAD") == nullptr;
}

/// Subscribes, on a thread of the library, and keeps what it receives.
class Inbox {
 public:
  explicit Inbox(const std::string& address, const std::string& hello = "") {
    SubscriberOptions options;
    options.address = address;
    options.hello = hello;
    options.shared_thread = on_shared_thread();
    options.on_message = [this](const MessagePtr& message) { add(message); };
    options.on_disconnect = [this](const std::string& reason) { end(reason); };
    auto created = Subscriber::create(std::move(options));
    if (created) subscriber = *created;
    error = created ? "" : created.error().text();
  }
  ~Inbox() { subscriber.reset(); }

  bool wait_for(std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(60), [&] { return messages_.size() >= count; });
  }
  bool wait_for_end() {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(60), [&] { return !reason_.empty(); });
  }
  std::vector<MessagePtr> messages() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.clear();
  }
  std::string reason() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reason_;
  }

  std::shared_ptr<Subscriber> subscriber;
  std::string error;

 private:
  void add(const MessagePtr& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.push_back(message);
    changed_.notify_all();
  }
  void end(const std::string& reason) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reason_ = reason;
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<MessagePtr> messages_;
  std::string reason_;
};

/// A subscriber of the caller's own loop: nothing is read until read() is called.
inline std::shared_ptr<Subscriber> idle_subscriber(const std::string& address) {
  SubscriberOptions options;
  options.address = address;
  options.own_thread = false;
  auto created = Subscriber::create(std::move(options));
  EXPECT_TRUE(created) << created.error().text();
  return *created;
}

/// Runs `body` in a forked process; its result is the exit status.
inline std::unique_ptr<Inbox> inbox(const std::string& address) {
  return std::make_unique<Inbox>(address);
}

/// Larger than a slot of the ring, so it crosses a socket.
inline std::string large_text(int number) {
  return std::to_string(number) + std::string(1000, '.');
}

inline pid_t in_child(const std::function<int()>& body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body());
  return child;
}

inline int exit_status(pid_t child) {
  int status = -1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace test
}  // namespace channel
}  // namespace tzc
