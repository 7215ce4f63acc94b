// SPDX-License-Identifier: BSD-3-Clause
#include "sync_point/sync_point.h"

namespace tzc {

std::atomic<SyncPointHook> sync_point_hook{nullptr};

}  // namespace tzc
