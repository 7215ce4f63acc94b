// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/Image.h>

#include "measure.h"
#include "span.h"

namespace tzc {
namespace bench {

/// The time of publishing travels in header.stamp (monotonic clock), the message's number in width.
template <class Image>
void fill_and_stamp(Image& image, const Span& span) {
  span.fill(image.data.data(), image.data.size());
  const Stamp stamp = span.stamp();
  image.width = static_cast<std::uint32_t>(stamp.index);
  image.header.stamp.sec = static_cast<std::uint32_t>(stamp.nanoseconds / 1'000'000'000);
  image.header.stamp.nsec = static_cast<std::uint32_t>(stamp.nanoseconds % 1'000'000'000);
}

inline void record(const ::sensor_msgs::Image& image, Recorder& recorder) {
  const std::int64_t sent = std::int64_t{image.header.stamp.sec} * 1'000'000'000 + image.header.stamp.nsec;
  recorder.record(Stamp{sent, image.width});
}

}  // namespace bench
}  // namespace tzc
