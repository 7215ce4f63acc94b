// SPDX-License-Identifier: BSD-3-Clause
// Code of another package, which takes what its user has included.
#pragma once
namespace other {
struct Overlay {
  void publishBox(const cv::Rect&, int) {}
};
}  // namespace other
