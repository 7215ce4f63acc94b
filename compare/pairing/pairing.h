// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pairing/alignment.h"
#include "pairing/recording.h"

namespace tzc::compare {

/// Messages of one run that have no partner in the other one, by where they stand.
struct Unpaired {
  std::vector<std::size_t> before;  ///< all of the pairs: the other recording had not begun
  std::vector<std::size_t> between;
  std::vector<std::size_t> after;  ///< all of the pairs: the other recording had ended

  std::size_t size() const { return before.size() + between.size() + after.size(); }
};

enum class PairedBy { stamp, content, sequence, order };

/// The pairs of messages of two recordings of one stream that are the same message.
struct Pairing {
  PairedBy by = PairedBy::order;
  std::vector<IndexPair> pairs;  ///< ascending in the first index
  Unpaired first_only, second_only;
  std::size_t reordered = 0;   ///< pairs whose order differs
  std::size_t duplicates = 0;  ///< of second_only: repetitions of another message of the second recording
};

/// Pairs by header stamp where both recordings have the same stamps (at least half of the shorter one's).
/// Otherwise equal content is aligned; what is left between two aligned messages is paired by header.seq, or
/// by order. Several messages with one stamp are paired by content first.
Pairing pair_messages(const std::vector<MessageFacts>& first, const std::vector<MessageFacts>& second);

const char* name(PairedBy by);

}  // namespace tzc::compare
