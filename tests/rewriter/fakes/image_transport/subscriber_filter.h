// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <image_transport/image_transport.h>
namespace image_transport {
class SubscriberFilter {
 public:
  SubscriberFilter() = default;
  SubscriberFilter(ImageTransport&, const std::string&, uint32_t, const TransportHints& = TransportHints()) {}
  void subscribe(ImageTransport&, const std::string&, uint32_t, const TransportHints& = TransportHints()) {}
  template <class F>
  void registerCallback(F&&) {}
  void unsubscribe() {}
};
}  // namespace image_transport
