// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <tzc/ros.h>
namespace tzc {
namespace laser_proc {
template <class Publisher>
Publisher attached(const Publisher& publisher) {
  return publisher;
}
}  // namespace laser_proc
}  // namespace tzc
