// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace tzc::compare {

/// Why there is no result: what happened, and what the user can do. Ends the program with status 2, after
/// everything that it started has been stopped.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& what, std::string hint = "")
      : std::runtime_error(what), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// The user has asked the program to stop (SIGINT, SIGTERM, SIGHUP).
class Stopped : public std::exception {};

}  // namespace tzc::compare
