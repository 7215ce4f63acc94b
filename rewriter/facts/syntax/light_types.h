// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tzc::rewriter {

/// How many bytes the arrays of a message of ROS's common packages hold at most, by what the type is for: a
/// camera's calibration, a number for each joint. None: the type says nothing. "sensor_msgs/CameraInfo".
std::optional<std::uint64_t> light_type_bytes(const std::string& message);

}  // namespace tzc::rewriter
