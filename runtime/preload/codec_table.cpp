// SPDX-License-Identifier: BSD-3-Clause
#include "preload/codec_table.h"

#include <utility>

namespace tzc {
namespace {

template <int... Index>
CodecTable fill(std::integer_sequence<int, Index...>) {
  CodecTable table;
  (add_shard<Index>(table), ...);
  return table;
}

}  // namespace

const CodecTable& codec_table() {
  static const CodecTable table = fill(std::make_integer_sequence<int, TZC_CODEC_SHARDS>());
  return table;
}

}  // namespace tzc
