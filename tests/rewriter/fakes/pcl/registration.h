// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
namespace pcl {
class Registration {
 public:
  void registerVisualizationCallback(const std::function<void(int)>& f) { update_ = f; }
  void align() { update_(1); }
  double getFitnessScore() const { return 1; }

 private:
  std::function<void(int)> update_;
};
class Icp : public Registration {};
class VoxelGrid {
 public:
  void filter() {}
};
}  // namespace pcl
