// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "channel/wire/ring.h"
#include "explorer.h"

// Where a model keeps the words of a ring: at the beginning of its shared words.

namespace tzc {
namespace model {

enum RingWord : std::size_t { bell, written, packets, sleeping, read_count, packets_read, ring_word_count };

inline channel::RingWords<ModelAtomic> words_of(Context& context) {
  const auto word = [&](std::size_t index) { return ModelAtomic(context, index); };
  return {word(bell), word(written), word(packets), word(sleeping), word(read_count), word(packets_read)};
}

}  // namespace model
}  // namespace tzc
