// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>
#include <string>
#include <utility>

namespace tzc {

/// A failed operation, with what a person needs to act on it. A plain value.
struct Error {
  std::string what;   ///< what was tried and failed, e.g. "reserve 4194304 bytes of shared memory"
  std::string where;  ///< on which object: an address, a topic, a segment; may be empty
  std::string hint;   ///< what the user can do; may be empty
  int code = 0;       ///< errno at the time, 0 when no system call failed

  /// One line: "what (where): reason; hint".
  std::string text() const {
    std::string line = what;
    if (!where.empty()) line += " (" + where + ")";
    if (code != 0) line += std::string(": ") + std::strerror(code);
    if (!hint.empty()) line += "; " + hint;
    return line;
  }
};

/// A value or the reason why there is none. T must be default-constructible and movable.
/// Reading value() of a failed Expected yields the default value: test with `if (expected)` first.
template <class T>
class Expected {
 public:
  Expected(T value)
      : ok_(true), value_(std::move(value)) {}  // NOLINT: implicit on purpose, for `return value;`
  Expected(Error error) : ok_(false), error_(std::move(error)) {}  // NOLINT: likewise for `return error;`

  explicit operator bool() const noexcept { return ok_; }
  T& value() & noexcept { return value_; }
  const T& value() const& noexcept { return value_; }
  T&& value() && noexcept { return std::move(value_); }
  T& operator*() & noexcept { return value_; }
  const T& operator*() const& noexcept { return value_; }
  T&& operator*() && noexcept { return std::move(value_); }
  T* operator->() noexcept { return &value_; }
  const T* operator->() const noexcept { return &value_; }
  const Error& error() const noexcept { return error_; }

 private:
  bool ok_;
  T value_{};
  Error error_{};
};

/// What an operation without a result returns on success.
struct Success {};
using Status = Expected<Success>;

}  // namespace tzc
