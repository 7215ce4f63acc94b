// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "model/expected.h"

namespace tzc::rewriter {

/// Topic -> size of its largest message in a recording (format 2.0), in bytes. Reads indices only: exact for
/// uncompressed chunks, rounded up by at most one connection record for compressed ones. An error when the
/// file is no such recording or was not closed.
Expected<std::map<std::string, std::uint64_t>> measure_bag(const std::string& file);

/// The same by every name that a source may give the topic: "/ns/camera/image" is also "ns/camera/image",
/// "camera/image", "image", and "~image". The largest wins; memory that is not used costs nothing.
std::map<std::string, std::uint64_t> by_source_name(const std::map<std::string, std::uint64_t>& sizes);

}  // namespace tzc::rewriter
