// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/latency.h"
#include "pairing/recording.h"

namespace tzc::compare {

/// A recorder's bag and summary as a recording: a stream for each topic and node, also for those that were
/// silent. The file stays open while a stream lives. @throws Failure, Stopped; the latter also where a stream is read
Recording load_recording(const std::string& bag, const nlohmann::json& summary);

/// When the input's messages came, from the recorder's summary.
InputTimes load_inputs(const nlohmann::json& summary);

}  // namespace tzc::compare
