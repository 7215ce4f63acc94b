// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "wire/cursor.h"
#include "wire/masks.h"

namespace tzc::compare {

/// The facts of a recorded message that need no second read of its bytes.
struct MessageFacts {
  std::int64_t received_ns = 0;       ///< wall clock, since 1970
  std::optional<HeaderStamp> header;  ///< when the type begins with a header
  std::uint64_t digest = 0;           ///< of all bytes but header.seq and header stamps, at any depth
  std::size_t size = 0;               ///< bytes
};

/// The messages that one node published on one topic in one run, in order of arrival.
struct Stream {
  std::string topic, publisher;  ///< the node's name, without the part that makes anonymous names unique
  std::string datatype, md5sum, definition;
  std::vector<MessageFacts> messages;
  std::function<Bytes(std::size_t)> read;  ///< the bytes of message i
  std::int64_t recorded_until_ns = 0;      ///< wall clock, since 1970; 0: unknown

  /// The time without a message before the recording ended; 0 when that is unknown.
  double silence_seconds() const {
    if (messages.empty() || recorded_until_ns == 0) return 0;
    return static_cast<double>(recorded_until_ns - messages.back().received_ns) / 1e9;
  }

  std::pair<std::string, std::string> key() const { return {topic, publisher}; }
};

using Recording = std::vector<Stream>;

/// Digest of a message for MessageFacts: `message` with its masked ranges set to zero.
std::uint64_t digest_of(const Bytes& message);

/// "/viewer_1700000000000000000" and "/node_123_1700000000000" name the same node in another run:
/// "/viewer_*".
std::string without_anonymous_part(const std::string& node);

}  // namespace tzc::compare
