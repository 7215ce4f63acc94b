// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/shared_ptr.hpp>

#include <cstddef>
#include <utility>

#include "roscpp/publish/outgoing_message.h"

namespace tzc {
namespace detail {

/// The record of a message while the links of a topic send it. It owns the message, so that no other message
/// gets the same address.
class PublishCache {
 public:
  bool is(const void* message) const { return left_ != 0 && message_.get() == message; }
  void start(boost::shared_ptr<void const> message, OutgoingMessage outgoing, std::size_t links) {
    message_ = std::move(message);
    outgoing_ = std::move(outgoing);
    left_ = links;
  }
  OutgoingMessage take() {
    OutgoingMessage outgoing = outgoing_;
    if (--left_ == 0) start(nullptr, OutgoingMessage(), 0);
    return outgoing;
  }

 private:
  boost::shared_ptr<void const> message_;
  OutgoingMessage outgoing_;
  std::size_t left_ = 0;
};

}  // namespace detail
}  // namespace tzc
