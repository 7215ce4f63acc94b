// SPDX-License-Identifier: BSD-3-Clause
#include "trace/event_json.h"

#include <cinttypes>
#include <cstdarg>
#include <cstdio>

namespace tzc {
namespace trace {
namespace {

const char* name_of(Step step) {
  switch (step) {
    case Step::roscpp_publish:
      return "publish by roscpp";
    case Step::publish:
      return "publish";
    case Step::wake:
      return "wake";
    case Step::take:
      return "take";
    case Step::callback:
      return "callback";
  }
  return "step";
}

__attribute__((format(printf, 1, 2))) std::string text(const char* format, ...) {
  char line[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  return line;
}

/// Names are others' texts: anything but printable ASCII becomes a question mark, so the file stays JSON.
std::string quoted(const std::string& name) {
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c >= ' ' && c <= '~' ? c : '?';
  }
  return quoted + "\"";
}

/// The format's unit is the microsecond.
std::string micros(std::uint64_t ns) {
  return text("%" PRIu64 ".%03u", ns / 1000, static_cast<unsigned>(ns % 1000));
}

std::string place_of(std::uint32_t process, std::uint32_t thread, std::uint64_t at_ns) {
  return text("\"pid\":%" PRIu32 ",\"tid\":%" PRIu32 ",\"ts\":", process, thread) + micros(at_ns);
}

/// Binds to the slice of its thread that encloses it.
std::string flow(const Event& event, std::uint32_t process) {
  const char* const phase = event.arrow == Arrow::begins   ? "\"s\""
                            : event.arrow == Arrow::passes ? "\"t\""
                                                           : "\"f\",\"bp\":\"e\"";
  return std::string("{\"ph\":") + phase + ",\"cat\":\"message\",\"name\":\"message\"," +
         text("\"id\":\"0x%016" PRIx64 "\",", event.message) +
         place_of(process, event.thread, event.begin_ns) + "},\n";
}

std::string metadata(std::uint32_t process, std::uint32_t thread, const char* kind, const std::string& name) {
  return text(R"({"ph":"M","name":"%s","pid":%)" PRIu32 R"(,"tid":%)" PRIu32 R"(,"args":{"name":)", kind,
              process, thread) +
         quoted(name) + "}},\n";
}

}  // namespace

std::string to_json(const Event& event, std::uint32_t process) {
  const std::string name = std::string(name_of(event.step)) + " " + event.topic;
  std::string lines = text(R"({"ph":"X","cat":"%s","name":)", name_of(event.step)) + quoted(name) + "," +
                      place_of(process, event.thread, event.begin_ns) + ",\"dur\":" +
                      micros(event.end_ns > event.begin_ns ? event.end_ns - event.begin_ns : 0) +
                      text(",\"args\":{\"message\":\"0x%016" PRIx64 "\"", event.message);
  if (event.bytes > 0) lines += text(",\"bytes\":%" PRIu64, event.bytes);
  lines += "}},\n";
  return event.arrow == Arrow::none || event.message == 0 ? lines : lines + flow(event, process);
}

std::string process_name(std::uint32_t process, const std::string& name) {
  return metadata(process, process, "process_name", name);
}

std::string thread_name(std::uint32_t process, std::uint32_t thread, const std::string& name) {
  return metadata(process, thread, "thread_name", name);
}

std::string dropped_count(std::uint32_t process, std::uint64_t at_ns, std::uint64_t dropped) {
  return R"({"ph":"C","name":"events left out of the trace",)" + place_of(process, process, at_ns) +
         text(",\"args\":{\"events\":%" PRIu64 "}},\n", dropped);
}

}  // namespace trace
}  // namespace tzc
