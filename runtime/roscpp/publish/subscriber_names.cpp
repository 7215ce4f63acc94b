// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/subscriber_names.h"

namespace tzc {
namespace detail {

void SubscriberNames::add(const channel::ConnectionPtr& connection, const std::string& node) {
  const std::lock_guard<std::mutex> lock(mutex_);
  names_[connection] = node;
}

void SubscriberNames::remove(const channel::ConnectionPtr& connection) {
  const std::lock_guard<std::mutex> lock(mutex_);
  names_.erase(connection);
}

std::string SubscriberNames::in_flight() const {
  std::string text;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& one : names_)
    if (const std::size_t records = one.first->in_flight())
      text += (text.empty() ? "" : ", ") + one.second + " " + std::to_string(records);
  return text;
}

}  // namespace detail
}  // namespace tzc
