// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include "roscpp/statistics_updater.h"
#include "roscpp/upgrade/offer_requests.h"
#include "roscpp/upgrade/peer_pool.h"
#include "roscpp/upgrade/upgrade_responder.h"
#include "roscpp/worker.h"

namespace tzc {
namespace detail {

/// The transport's state of a process, made at its first use and never destroyed: roscpp's threads may call
/// TZC until the process ends, and nodelets are loaded and unloaded.
struct Runtime {
  Worker worker;   ///< moves links; may wait for this process's own locks, not for other processes
  Worker clerk;    ///< connect callbacks and the like: never waits
  PeerPool peers;  ///< calls the master and other nodes, and may wait for each of them for some seconds
  WorkerQueue queue{clerk};
  UpgradeResponder responder{clerk, peers, [this] { statistics.begin(); }};
  OfferRequests requests{clerk};
  StatisticsUpdater statistics{clerk, [this](auto& all) { return responder.look(all); }};
};

Runtime& runtime();

/// Where roscpp does not know TZC's methods any more, since the node has been shut down and started again, the clerk makes them known.
/// True: publishers may have asked for them in vain meanwhile, and have to be asked for an offer. Any thread.
bool bind_again();

}  // namespace detail
}  // namespace tzc
