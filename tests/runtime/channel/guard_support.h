// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the tests of guard mode publish, and how they watch a process that may write late.

#include "support.h"

namespace tzc {
namespace channel {
namespace test {

inline std::shared_ptr<SegmentMemory> named_memory(std::size_t size = 16 * mb) {
  MemoryOptions options;
  options.size = size;
  options.name = "/camera/image";
  return *SegmentMemory::create(options);
}

struct Exchange {
  explicit Exchange(std::size_t queue_size = 10) {
    PublisherOptions options;
    options.queue_size = queue_size;
    options.memory = named_memory();
    out = publish_with(std::move(options));
    in = idle_subscriber(out->address());
  }
  BufferPtr publish(std::size_t size, unsigned char value) const {
    BufferPtr buffer = filled(*out->memory(), size, value);
    out->publish(text_record("x", {buffer}));
    return buffer;
  }

  std::shared_ptr<Publisher> out;
  std::shared_ptr<Subscriber> in;
};

struct Outcome {
  int status;
  std::string errors;

  bool says(const std::string& text) const { return errors.find(text) != std::string::npos; }
  std::size_t reports() const {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = errors.find("TZC guard: a", at)) != std::string::npos; ++at) ++count;
    return count;
  }
};

/// Runs `body` in a process of its own, which ends as programs do.
inline Outcome run(const std::function<int()>& body) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    std::_Exit(body());
  }
  ::close(ends[1]);
  Outcome outcome{};
  char bytes[4096];
  for (ssize_t size = 0; (size = ::read(ends[0], bytes, sizeof bytes)) > 0;)
    outcome.errors.append(bytes, static_cast<std::size_t>(size));
  ::close(ends[0]);
  ::waitpid(child, &outcome.status, 0);
  return outcome;
}

inline bool ended_with(const Outcome& outcome, int status) {
  return WIFEXITED(outcome.status) && WEXITSTATUS(outcome.status) == status;
}

__attribute__((noinline)) inline void write_late(std::uint8_t* bytes, std::size_t at) {
  *const_cast<volatile std::uint8_t*>(bytes + at) = 99;
}

}  // namespace test
}  // namespace channel
}  // namespace tzc
