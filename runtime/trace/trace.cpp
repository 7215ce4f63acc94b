// SPDX-License-Identifier: BSD-3-Clause
#include "trace/trace.h"

#include <chrono>
#include <cstdlib>

#include "posix/process.h"
#include "trace/recorder.h"

namespace tzc {
namespace trace {
namespace {

bool is_asked_for() {
  const char* const file = std::getenv("TZC_TRACE");
  return file != nullptr && *file != '\0';
}

/// Null: no trace was asked for, or it cannot be written.
Recorder* begun() {
  return active ? Recorder::begin() : nullptr;
}

}  // namespace

bool active = is_asked_for();

std::uint64_t now() noexcept {
  const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::nanoseconds(since_boot).count());
}

const char* keep(const std::string& topic) {
  Recorder* const recorder = begun();
  return recorder != nullptr ? recorder->keep(topic) : "";
}

void name_channel(const std::string& address, const ChannelName& name) {
  if (Recorder* const recorder = begun()) recorder->name_channel(address, name);
}

ChannelName name_of_channel(const std::string& address) {
  Recorder* const recorder = begun();
  return recorder != nullptr ? recorder->name_of_channel(address) : ChannelName{address, false};
}

void name_process(const std::string& name) {
  if (Recorder* const recorder = begun()) recorder->name_process(name);
}

void record(const Event& event) noexcept {
  Recorder* const recorder = Recorder::running();
  if (recorder == nullptr) return;
  Event whole = event;
  if (whole.thread == 0) whole.thread = posix::thread_number();
  recorder->add(whole);
}

void record(Step step, Arrow arrow, std::uint64_t message, const char* topic, std::uint64_t begin_ns,
            std::uint64_t bytes) noexcept {
  record(Event{begin_ns, now(), message, bytes, topic, 0, step, arrow});
}

RecentMessages& recent() {
  static auto* const messages = new RecentMessages;
  return *messages;
}

}  // namespace trace
}  // namespace tzc
