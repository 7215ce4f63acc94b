// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "trace/event_queue.h"
#include "trace/names.h"
#include "trace/trace_file.h"

namespace tzc {
namespace trace {

/// Writes the trace of this process: a thread takes events from a queue and appends them to the file some times a second,
/// whole lines only, so that the file of a process that was killed can be read. Events that find no room there are counted,
/// like those that find none in the queue. Never destroyed; at the process's end it writes what is left. A forked child has
/// no trace: the file is its parent's.
class Recorder {
 public:
  /// Begins with the first call, as TZC_TRACE says. Null: the file cannot be written, which was said then, or this is a forked child.
  static Recorder* begin();
  /// Null: it has not begun, or this is a forked child.
  static Recorder* running() noexcept;

  const char* keep(const std::string& text);
  void name_channel(const std::string& address, const ChannelName& name);
  ChannelName name_of_channel(const std::string& address);
  void name_process(const std::string& name);
  /// Never waits; counts what has no place.
  void add(const Event& event) noexcept;

 private:
  explicit Recorder(TraceFile file);
  static Recorder* open();
  static void end_at_exit();
  void run();
  void write_events();
  std::string lines_of(const Event& event);
  bool write(const std::string& lines, std::uint64_t events);
  void end();

  const std::uint32_t process_;
  TraceFile file_;
  EventQueue queue_;
  std::atomic<std::uint64_t> dropped_{0};
  std::uint64_t reported_drops_ = 0;
  std::set<std::uint32_t> named_;  ///< whose names are in the file: threads, and 0 for the process
  std::string process_name_;
  std::thread thread_;  ///< alone uses the two above, until it ends

  std::mutex mutex_;  ///< guards what follows
  std::condition_variable ends_;
  bool is_ending_ = false;
  struct Names {
    std::set<std::string> kept;
    std::map<std::string, ChannelName> channels;  ///< by address
    std::string of_process;                       ///< to be written
  };
  Names names_;
};

}  // namespace trace
}  // namespace tzc
