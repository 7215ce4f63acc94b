// SPDX-License-Identifier: BSD-3-Clause
// The table of docs/tzc-rewrite.md, section "Light messages".
#include "facts/syntax/light_types.h"

#include <map>

namespace tzc::rewriter {
namespace {

constexpr std::uint64_t joints = 32;  ///< of a robot with two arms and two hands
constexpr std::uint64_t poses = 16;   ///< joints with several degrees of freedom, a pose, twist, wrench each
constexpr std::uint64_t pose_bytes = 56 + 48 + 48;

const std::map<std::string, std::uint64_t>& table() {
  static const std::map<std::string, std::uint64_t> bytes = {
      {"control_msgs/JointJog", 2 * 8 * joints},
      {"control_msgs/JointTrajectoryControllerState", 3 * 4 * 8 * joints},
      {"geometry_msgs/Polygon", 100 * 12},
      {"geometry_msgs/PolygonStamped", 100 * 12},
      {"pcl_msgs/ModelCoefficients", 16 * 4},
      {"sensor_msgs/BatteryState", 2 * 64 * 4},
      {"sensor_msgs/CameraInfo", 14 * 8},
      {"sensor_msgs/JointState", 3 * 8 * joints},
      {"sensor_msgs/Joy", 32 * 4 + 64 * 4},
      {"sensor_msgs/JoyFeedbackArray", 32 * 8},
      {"sensor_msgs/MultiDOFJointState", pose_bytes * poses},
      {"shape_msgs/SolidPrimitive", 3 * 8},
      {"trajectory_msgs/JointTrajectoryPoint", 4 * 8 * joints},
      {"trajectory_msgs/MultiDOFJointTrajectoryPoint", pose_bytes * poses},
  };
  return bytes;
}

}  // namespace

std::optional<std::uint64_t> light_type_bytes(const std::string& message) {
  const auto found = table().find(message);
  return found == table().end() ? std::nullopt : std::optional(found->second);
}

}  // namespace tzc::rewriter
