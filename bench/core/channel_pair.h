// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "measure.h"
#include "tzc/channel.h"

namespace tzc {
namespace bench {

/// Connects to the measurement's publisher, which may still be starting; ends the process when none comes.
std::shared_ptr<channel::Subscriber> connect(const Setup& setup, channel::SubscriberOptions options);

/// The measurement's publisher, with memory for blocks of block_bytes.
std::shared_ptr<channel::Publisher> open_publisher(const Setup& setup, std::size_t block_bytes);

}  // namespace bench
}  // namespace tzc
