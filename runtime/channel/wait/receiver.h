// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "channel/wait/doorbell.h"
#include "channel/wait/sleepers.h"
#include "channel/wait/turn.h"
#include "posix/hot.h"
#include "tzc/error.h"

namespace tzc {
namespace channel {

class Receiver;

/// One subscriber that the receiver reads for. Called by one thread at a time.
class ReceivingEnd {
 public:
  enum class Progress {
    done,    ///< nothing is left to read now
    more,    ///< there is more, but others come first
    later,   ///< there is something, and it may not be read yet
    closed,  ///< nothing comes any more
  };
  virtual ~ReceivingEnd() = default;
  virtual Progress read_some() = 0;
};

/// A connection's number at the doorbell of this process; free again with this object.
class DoorbellNumber {
 public:
  DoorbellNumber(Receiver& receiver, std::uint32_t number);
  ~DoorbellNumber();
  DoorbellNumber(const DoorbellNumber&) = delete;
  DoorbellNumber& operator=(const DoorbellNumber&) = delete;

  const std::shared_ptr<Doorbell>& doorbell() const;
  std::uint32_t value() const { return number_; }
  /// From now on the end is called when something has come for it. Once.
  void begin(std::shared_ptr<ReceivingEnd> end);
  /// No call runs afterwards, unless it is the one that calls this.
  void end();

 private:
  Receiver& receiver_;
  const std::uint32_t number_;
};

/// The one thread that reads for many subscribers of this process, and the doorbell at which it sleeps. Started with
/// the first of them, anew in a forked child. Thread-safe.
///
/// A thread of the program that has nothing else to do may sleep at the doorbell as a guest and read in the place of
/// that thread, which sleeps on. When the guest wakes up, it tells publishers to wake the reader again, then reads what
/// has come until then; so whoever is told of later records, and none is left.
class Receiver {
 public:
  using Clock = std::chrono::steady_clock;

  /// The running receiver of this process. Never destroyed. Error: no thread, memory or descriptor left, or threads of
  /// different processes cannot wait for each other here.
  static Expected<Receiver*> instance();
  /// As instance(), without starting one. Null: there is none.
  static Receiver* running();
  /// The calling thread reads as a guest, and sleeps while there is nothing: until `wanted` says that it has other
  /// work, or the time is over. False, at once: another guest is there, or this is a callback of a subscriber.
  bool host(std::chrono::nanoseconds most, const std::function<bool()>& wanted);
  /// Makes a guest that sleeps ask `wanted` again.
  void call_guest();
  /// Null: all numbers are taken.
  std::shared_ptr<DoorbellNumber> take_number();

 private:
  friend class DoorbellNumber;

  explicit Receiver(std::shared_ptr<Doorbell> doorbell);
  static Expected<Receiver*> start();
  void begin(std::uint32_t number, std::shared_ptr<ReceivingEnd> end);
  void end(std::uint32_t number);
  void give_back(std::uint32_t number);

  using Ask = std::function<bool()>;

  void run();
  TZC_HOT std::chrono::nanoseconds read_round(std::uint32_t& heard, const Ask& is_enough) noexcept;
  TZC_HOT void collect();
  void collect_all();
  TZC_HOT void read_all(const Ask& is_enough);
  TZC_HOT ReceivingEnd::Progress read(std::uint32_t number);
  void hand_over();
  std::shared_ptr<ReceivingEnd> begin_call(std::uint32_t number);
  void end_call(ReceivingEnd::Progress progress);

  const std::shared_ptr<Doorbell> doorbell_;
  Sleepers sleepers_;
  const std::uint32_t epoch_;
  std::thread thread_;

  /// Used by the thread whose turn it is.
  struct Round {
    segment::HintReader hints{doorbell_numbers};
    std::vector<std::uint32_t> ready;                                // numbers to read for next
    std::vector<std::uint32_t> now;                                  // those that are being read for
    std::vector<std::uint32_t> later;                                // and those to read for in a moment
    std::vector<bool> listed = std::vector<bool>(doorbell_numbers);  // whether a number is in one of these
    Clock::time_point next_look_at_all{};

    /// Once, however often it is rung for: each time would be a turn of its own, and a connection that never empties would get more and
    /// more of them.
    void list(std::uint32_t number, std::vector<std::uint32_t>& in) {
      if (!listed[number]) in.push_back(number);
      listed[number] = true;
    }
  };
  Round round_;
  Turn turn_;
  std::mutex guest_;  // held by the one that is there

  struct Place {
    bool taken = false;
    std::shared_ptr<ReceivingEnd> end{};
  };
  std::mutex mutex_;
  std::condition_variable call_ended_;
  std::vector<Place> places_;                 // by number
  std::uint32_t called_ = ~std::uint32_t{0};  // the number whose end is called now
  std::thread::id caller_;                    // and the thread that does so
};

}  // namespace channel
}  // namespace tzc
