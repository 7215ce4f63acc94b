// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "roscpp/worker.h"

namespace tzc {
namespace detail {

/// Subscribers that requested an offer and have not got one. Any process can send requests, so equal requests
/// count once, and beyond a limit further ones are dropped (the publisher makes an offer anyway when a
/// subscriber connects). Thread-safe.
class OfferRequests {
 public:
  explicit OfferRequests(Worker& clerk) : clerk_(clerk) {}

  void note(const std::string& topic, const std::string& subscriber);

 private:
  using Request = std::pair<std::string, std::string>;
  void grant(const Request& request);

  Worker& clerk_;
  std::mutex mutex_;
  std::set<Request> waiting_;
};

}  // namespace detail
}  // namespace tzc
