// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace tzc {
namespace trace {

/// Under which address this process knows its latest messages, so that a callback, which gets only an address, finds the
/// flow that leads to it. Thread-safe; only processes that write a trace use it.
class RecentMessages {
 public:
  static constexpr std::size_t most = 1024;

  /// `message` 0: what lies there now comes from nowhere that the trace knows.
  void remember(const void* address, std::uint64_t message);
  struct Found {
    std::uint64_t message = 0;   ///< 0: it is not known
    bool is_first_call = false;  ///< no callback has asked for it before
  };
  Found find(const void* address);
  /// The message, which is forgotten; 0: it is not known.
  std::uint64_t take(const void* address);

 private:
  struct Entry {
    const void* address = nullptr;
    std::uint64_t message = 0;
    bool is_called = false;
  };

  /// The newest, because addresses are reused. Null: none. Under mutex_.
  Entry* newest(const void* address);

  std::mutex mutex_;
  std::array<Entry, most> ring_;
  std::size_t next_ = 0;
};

}  // namespace trace
}  // namespace tzc
