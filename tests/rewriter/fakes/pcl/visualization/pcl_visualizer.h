// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
namespace pcl {
namespace visualization {
class PCLVisualizer {
 public:
  void registerPointPickingCallback(std::function<void()>) {}
  void spinOnce(int = 1) {}
};
}  // namespace visualization
}  // namespace pcl
