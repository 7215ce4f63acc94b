// SPDX-License-Identifier: BSD-3-Clause
#include "trace/recorder.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "posix/fork_epoch.h"
#include "posix/process.h"
#include "posix/thread.h"
#include "trace/event_json.h"

namespace tzc {
namespace trace {
namespace {

constexpr std::size_t queued_events = 16384;  // a burst of a second at 4000 messages; 1 MB
constexpr std::chrono::milliseconds pause{50};
constexpr std::size_t batch_bytes = 65536;  // what a full disk costs at once, at most
constexpr std::uint32_t the_process = 0;    // the thread that events of the whole process are shown under

std::atomic<Recorder*> the_recorder{nullptr};
std::atomic<std::uint32_t> epoch{0};

std::uint64_t now_ns() {
  const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::nanoseconds(since_boot).count());
}

}  // namespace

Recorder::Recorder(TraceFile file)
    : process_(posix::process_number()),
      file_(std::move(file)),
      queue_(queued_events),
      process_name_(posix::program_name()) {}

Recorder* Recorder::open() {
  const std::string name = file_name(std::getenv("TZC_TRACE"), posix::process_number());
  TraceFile file;
  if (!file.open(name)) {
    std::fprintf(
        stderr,
        "TZC: TZC_TRACE: cannot write %s: %s; this process writes no trace (share/doc/tzc/traces.md)\n",
        name.c_str(), std::strerror(errno));
    return nullptr;
  }
  auto* const recorder = new Recorder(std::move(file));
  auto thread = posix::start_thread("tzc-trace", [recorder] { recorder->run(); });
  if (!thread) {
    std::fprintf(stderr, "TZC: TZC_TRACE: %s; this process writes no trace\n", thread.error().text().c_str());
    return nullptr;
  }
  recorder->thread_ = std::move(*thread);
  epoch = posix::fork_epoch();
  the_recorder.store(recorder, std::memory_order_release);
  std::atexit(end_at_exit);
  return recorder;
}

Recorder* Recorder::begin() {
  static Recorder* const begun = open();
  return begun != nullptr ? running() : nullptr;
}

Recorder* Recorder::running() noexcept {
  Recorder* const recorder = the_recorder.load(std::memory_order_acquire);
  return recorder != nullptr && !posix::forked_since(epoch.load(std::memory_order_relaxed)) ? recorder
                                                                                            : nullptr;
}

const char* Recorder::keep(const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return names_.kept.insert(text).first->c_str();
}

void Recorder::name_channel(const std::string& address, const ChannelName& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  names_.channels[address] = name;
}

ChannelName Recorder::name_of_channel(const std::string& address) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = names_.channels.find(address);
  return known != names_.channels.end() ? known->second : ChannelName{address, false};
}

void Recorder::name_process(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  names_.of_process = name;
}

void Recorder::add(const Event& event) noexcept {
  if (!queue_.push(event)) dropped_.fetch_add(1, std::memory_order_relaxed);
}

void Recorder::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!is_ending_) {
    std::string name = std::exchange(names_.of_process, std::string());
    lock.unlock();
    if (!name.empty() && name != process_name_) {
      process_name_ = std::move(name);
      named_.erase(the_process);
    }
    write_events();
    lock.lock();
    ends_.wait_for(lock, pause, [this] { return is_ending_; });
  }
}

void Recorder::write_events() {
  std::string lines;
  if (named_.insert(the_process).second) lines = process_name(process_, process_name_);
  std::uint64_t events = 0;
  for (Event event{}; queue_.pop(event); ++events) {
    if (lines.size() >= batch_bytes) {
      write(lines, std::exchange(events, 0));
      lines.clear();
    }
    lines += lines_of(event);
  }
  const std::uint64_t dropped = dropped_.load(std::memory_order_relaxed);
  if (dropped != reported_drops_) lines += dropped_count(process_, now_ns(), dropped);
  if (write(lines, events)) reported_drops_ = dropped;
}

std::string Recorder::lines_of(const Event& event) {
  std::string name;
  if (named_.insert(event.thread).second)
    name = thread_name(process_, event.thread, posix::thread_name(event.thread));
  return name + to_json(event, process_);
}

/// False: they are left out, and so many events with them.
bool Recorder::write(const std::string& lines, std::uint64_t events) {
  if (lines.empty() || file_.append(lines)) return true;
  dropped_.fetch_add(events, std::memory_order_relaxed);
  named_.clear();  // there may have been names among them
  return false;
}

// The last line has no comma, so that the file of a process that ended by itself is strict JSON.
void Recorder::end() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  ends_.notify_all();
  thread_.join();
  write_events();
  std::string last = dropped_count(process_, now_ns(), dropped_);
  last.resize(last.rfind(','));
  file_.append(last + "\n]\n");
}

void Recorder::end_at_exit() {
  if (Recorder* const recorder = running()) recorder->end();
}

}  // namespace trace
}  // namespace tzc
