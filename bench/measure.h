// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cost.h"
#include "report.h"

namespace tzc {
namespace bench {

/// What travels with each message: when it was published, and which it is.
struct Stamp {
  std::int64_t nanoseconds;
  std::uint64_t index;
};

std::int64_t now_ns();

constexpr std::size_t most_messages = 1 << 16;
constexpr std::size_t most_subscribers = 16;

/// What one process of a measurement tells of itself.
struct Member {
  std::atomic<pid_t> process;
  Counts counts;
  Cost spent;  // on the measured messages; the publisher writes it, of every member
};

/// Memory that the processes of one measurement share.
struct Board {
  std::atomic<std::uint32_t> ready;
  std::atomic<bool> stop;
  std::atomic<bool> sends;      // every subscriber is connected
  std::atomic<bool> published;  // all messages
  std::int64_t publishing_ns;   // how long that took
  Member publisher;
  Member subscriber[most_subscribers];
  std::atomic<std::uint64_t> received[most_subscribers];
  std::uint64_t latency_ns[most_subscribers][most_messages];
  std::atomic<std::int64_t>
      published_ns[most_messages];          // when each message's latency began, by the clock of now_ns
  std::int64_t returned_ns[most_messages];  // when the publisher had done with it
};

/// The record of what one subscriber receives.
class Recorder {
 public:
  Recorder(Board& board, std::size_t who) : board_(board), who_(who) {}
  void ready() { ++board_.ready; }
  bool stop() const { return board_.stop; }
  void record(const Stamp& stamp);

 private:
  Board& board_;
  std::size_t who_;
};

struct Setup {
  std::size_t size_bytes;
  std::size_t subscribers;
  double rate;
  std::size_t count;
  std::string name;  // unique for each measurement: for addresses and services
  std::size_t queue_size = 10;
  bool fills = false;  // allocating and filling each message belong to the span of its latency
  bool real_time =
      false;  // processes are scheduled by SCHED_FIFO, with memory that is locked: see real_time.h
  std::chrono::milliseconds patience = std::chrono::seconds(60);  // until every subscriber is connected
  const std::atomic<bool>* over = nullptr;                        // set by measure, for wait_until
};

/// For Contender::publish, which waits for its subscribers: looks every millisecond. False: the measurement is over.
bool wait_until(const Setup& setup, const std::function<bool()>& condition);

/// For Setup::name: another one at each call.
std::string unique_name();

/// A process that must run beside a contender's own.
enum class Daemon { none, rosmaster, roudi };

/// One way of carrying messages. publish and the functions that subscribe run in a process of their own.
class Contender {
 public:
  virtual ~Contender() = default;
  virtual const char* name() const = 0;
  virtual bool supports(const Setup&) const { return true; }
  virtual Daemon needs() const { return Daemon::none; }
  /// Why it cannot run on this machine and what the user can do about it; empty: it can.
  virtual std::string obstacle() const { return ""; }
  /// The most memory that its processes need together. A message that is copied may stand in every queue.
  virtual std::size_t memory_bytes(const Setup& setup) const {
    return setup.size_bytes * (setup.queue_size + 2) * (1 + setup.subscribers);
  }
  /// Its subscribers must leave by themselves when recorder.stop() says so, or files stay behind.
  virtual bool cleans_up_at_exit() const { return false; }
  /// In the parent, before any process is forked. May throw std::system_error: the measurement fails.
  virtual void prepare(const Setup&) {}
  /// Subscribes, calls recorder.ready(), records until recorder.stop().
  virtual void subscribe(const Setup& setup, std::size_t who, Recorder& recorder) = 0;
  /// Publisher and subscribers live in one process: subscribe_here replaces subscribe.
  virtual bool in_one_process() const { return false; }
  /// Subscribes once for each recorder, in the publisher's process, and returns.
  virtual void subscribe_here(const Setup&, std::vector<Recorder>&) {}
  /// Opens the publisher; the result is called once for each message and fills in the time itself, right
  /// before it publishes. Null: the measurement was over before all subscribers were connected.
  virtual std::function<void(std::uint64_t index)> publish(const Setup& setup) = 0;
};

enum class Outcome {
  complete,     // the publisher sent all messages; how many arrived is another question
  failed,       // a process could not be started or ended early, or not every subscriber came in time
  interrupted,  // see hold_interrupts
};

/// What one measurement found.
struct Measurement {
  Outcome outcome = Outcome::failed;
  double seconds = 0;  // from when the first message was due until the last one was published, and a period
  std::vector<std::vector<std::uint64_t>> latency_ns;  // [subscriber][message]; 0: not delivered
  std::vector<std::int64_t> published_ns;              // [message]; 0: it reached nobody. Only in real time
  std::vector<std::uint64_t> publishing_ns;  // of each message that reached somebody: see Row::publish_us
  Cost publisher;                            // with its subscribers, where they live in its process
  Cost subscribers;                          // all of them together
};

/// Forks the publisher and the subscribers, sends at the given rate, and returns what arrived. All processes
/// have ended when it returns. Why it failed, it has said on standard error.
Measurement measure(Contender& contender, const Setup& wanted);

/// What a contender needs that publishes shared memory: a queue of messages, and a copy for each subscriber where it makes one.
inline std::size_t shared_memory_bytes(const Setup& setup, bool copied_out) {
  return setup.size_bytes * (setup.queue_size + 2 + (copied_out ? setup.subscribers : 0));
}

/// The deliveries of one or several measurements.
struct Samples {
  std::size_t sent = 0;                      // times the number of subscribers
  std::vector<std::uint64_t> latency_ns;     // of each delivered message
  std::vector<std::uint64_t> publishing_ns;  // of each message that reached somebody
};

void add(const Measurement& measurement, Samples& samples);
Row summarize(const Contender& contender, const Setup& setup, Samples samples);

}  // namespace bench
}  // namespace tzc
