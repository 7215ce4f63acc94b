// SPDX-License-Identifier: BSD-3-Clause
#include <deque>
#include <mutex>
#include <random>

#include "board.h"
#include "message_pattern.h"
#include "tzc/channel.h"

namespace tzc {
namespace crash {
namespace {

/// Holds a few messages for a while and checks every byte when they arrive and again before they are released.
class Hoard {
 public:
  explicit Hoard(unsigned seed) : random_(seed) {}

  void add(const channel::MessagePtr& message) {
    ++board->received[own_role];
    if (!is_intact(*message)) report_error("a message arrived damaged");
    const std::lock_guard<std::mutex> lock(mutex_);
    if (board->phase == Phase::run && random_() % 3 == 0) held_.push_back(message);
    while (held_.size() > random_() % 5) drop_oldest();
  }

  /// Releases a message now and then, also when no new ones arrive: with worst_effort none arrive while the
  /// oldest is held.
  void tire() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!held_.empty() && random_() % 8 == 0) drop_oldest();
  }

  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    while (!held_.empty()) drop_oldest();
  }

 private:
  void drop_oldest() {
    if (!is_intact(*held_.front())) report_error("a message changed while it was held");
    held_.pop_front();
  }

  std::mutex mutex_;
  std::mt19937 random_;
  std::deque<channel::MessagePtr> held_;
};

}  // namespace

void run_subscriber(unsigned seed) {
  Hoard hoard(seed);
  for (;;) {
    std::atomic<bool> ended{false};
    channel::SubscriberOptions options;
    options.address = board->address;
    options.shared_thread = seed % 2 == 0;
    options.on_message = [&](const channel::MessagePtr& message) { hoard.add(message); };
    options.on_disconnect = [&](const std::string& reason) {
      if (reason.find("broke the protocol") != std::string::npos) report_error(reason.c_str());
      ended = true;
    };
    const auto subscriber = channel::Subscriber::create(options);
    while (subscriber && !ended) {
      board->phase == Phase::quiesce ? hoard.clear() : hoard.tire();
      ::usleep(500);
    }
    hoard.clear();  // also what came from a publisher that is dead by now
    ::usleep(500);
  }
}

}  // namespace crash
}  // namespace tzc
