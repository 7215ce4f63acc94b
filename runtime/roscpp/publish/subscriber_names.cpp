// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/subscriber_names.h"

#include <algorithm>

namespace tzc {
namespace detail {

void SubscriberNames::add(channel::Connection& connection, const std::string& node) {
  const std::lock_guard<std::mutex> lock(mutex_);
  names_.emplace_back(&connection, &node);
}

void SubscriberNames::remove(const channel::Connection& connection) {
  if (::getpid() != process_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto is_it = [&](const auto& one) { return one.first == &connection; };
  names_.erase(std::remove_if(names_.begin(), names_.end(), is_it), names_.end());
}

std::string SubscriberNames::in_flight() const {
  std::string text;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& one : names_)
    if (const std::size_t records = one.first->in_flight())
      text += (text.empty() ? "" : ", ") + *one.second + " " + std::to_string(records);
  return text;
}

}  // namespace detail
}  // namespace tzc
