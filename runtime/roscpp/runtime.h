// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

#include "roscpp/receiver.h"
#include "roscpp/worker.h"

namespace tzc {

/// What the transport has once in a process, made at its first use and never destroyed: roscpp's threads may
/// call in until the very end, and nodelets come and go.
struct Runtime {
  Worker worker;  ///< moves links; waits for this process's own locks, and for nobody else
  Worker caller;  ///< calls the master and other nodes, and may wait for each of them for some seconds
  WorkerQueue queue{caller};
  Receiver receiver{caller};
};

Runtime& runtime();

}  // namespace tzc
