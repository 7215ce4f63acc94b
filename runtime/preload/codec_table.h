// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/detail/codec.h>

#include <string>
#include <unordered_map>

namespace tzc {

using CodecTable = std::unordered_map<std::string, detail::MessageCodec>;

/// The codecs of all data-carrying message types that were installed when TZC was built, by data type
/// ("sensor_msgs/Image").
const CodecTable& codec_table();

/// One generated source file of the table (make_codec_table.py).
template <int Index>
void add_shard(CodecTable& table);

}  // namespace tzc
