// SPDX-License-Identifier: BSD-3-Clause
#pragma once
namespace angles {
static inline double normalize_angle(double angle) {
  return angle;
}
static inline double from_degrees(double degrees) {
  return degrees;
}
}  // namespace angles
