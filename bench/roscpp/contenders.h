// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "measure.h"

namespace tzc {
namespace bench {

/// ros::Publisher to ros::Subscriber, with tcpNoDelay, called back by ros::spin.
std::unique_ptr<Contender> tcpros_contender();
/// The same publisher, which publishes by reference, with its topic attached (tzc::attached); ported subscribers.
std::unique_ptr<Contender> tzc_attached_contender();
/// The same code ported: callbacks through ros::spin's queue.
std::unique_ptr<Contender> tzc_queue_contender();
/// The same with tzc::spin.
std::unique_ptr<Contender> tzc_spin_contender();
/// Ported, with direct dispatch.
std::unique_ptr<Contender> tzc_direct_contender();
/// The stock message serialized into a block of shared memory and de-serialized by each subscriber, as ETHZ-ASL's
/// ROS-IPC does; blocks, sockets and threads are those of tzc-direct, so that only the copies differ.
std::unique_ptr<Contender> asl_contender();
/// Publisher and subscribers in one process, messages passed by pointer, as nodelets do.
std::unique_ptr<Contender> intraprocess_contender();

std::string roscpp_version();

}  // namespace bench
}  // namespace tzc
