// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "roscpp/held_since.h"
#include "roscpp/publish/endpoint_statistics.h"
#include "roscpp/subscribe/subscription_statistics.h"
#include "roscpp/worker.h"
#include "statistics/page_writer.h"

namespace tzc {
namespace detail {

/// Copies the counters of this process's publications and subscriptions into its statistics page, once a second, on the clerk's thread
/// (decision 505). Publishing does nothing for it, and it does not wait for a thread that publishes.
class StatisticsUpdater {
 public:
  /// False: not all could be looked at.
  using LookAtSubscriptions = std::function<bool(std::vector<SubscriptionStatistics>&)>;

  StatisticsUpdater(Worker& clerk, LookAtSubscriptions subscriptions)
      : clerk_(clerk), look_at_subscriptions_(std::move(subscriptions)) {}

  /// Begins with the page, unless there is one, it is switched off, or no descriptor is left for it. The clerk's thread.
  void begin();
  /// Shows this topic, too, from the page's beginning on: it stays on TCPROS for this reason. Any thread; does not begin
  /// with the page.
  void add_plain(const ros::PublicationPtr& publication, const std::string& reason);

 private:
  using Held = std::map<std::string, std::vector<channel::HeldBlock>>;  ///< by topic, where there are any
  struct PlainTopic {
    ros::PublicationWPtr publication;
    std::string reason;
  };

  void go_on();
  void update();
  bool write();
  std::vector<EndpointStatistics> look_at_plain();
  bool add(const EndpointStatistics& seen, Held& held);
  std::vector<channel::HeldBlock> add_links(const std::vector<LinkStatistics>& links);
  std::vector<channel::HeldBlock> repeat_links(const std::string& topic);

  Worker& clerk_;
  const LookAtSubscriptions look_at_subscriptions_;
  std::shared_ptr<statistics::PageWriter> page_;
  bool is_running_ = false;
  Held last_held_;
  HeldSince held_since_;
  std::mutex plain_mutex_;
  std::vector<PlainTopic> plain_;  ///< under plain_mutex_
};

}  // namespace detail
}  // namespace tzc
