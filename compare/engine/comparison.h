// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pairing/pairing.h"
#include "pairing/recording.h"
#include "wire/field_difference.h"

namespace tzc::compare {

/// In how many pairs of messages a field differs, and the first of them.
struct FieldCount {
  std::size_t messages = 0;
  FieldDifference example;
  IndexPair example_pair;
};

/// One run's side of a stream.
struct Side {
  bool is_advertised = false;
  std::size_t messages = 0;
  double silence_s = 0;  ///< without a message, before the run ended
};

/// What two runs published on one topic from one node.
struct StreamComparison {
  std::string topic, publisher, datatype;
  Side first, second;
  std::string type_difference;  ///< empty: both runs use the same type
  std::size_t equal = 0;        ///< pairs that are equal in every byte that is compared
  Pairing pairing;
  std::map<std::string, FieldCount> fields;  ///< by path without indices; "" for bytes that no field explains

  std::pair<std::string, std::string> key() const { return {topic, publisher}; }
};

using Comparison = std::vector<StreamComparison>;

/// What is not compared, besides header.seq.
struct LeftOut {
  bool header_stamps = false;       ///< the stamps of all headers, at any depth
  std::vector<std::string> fields;  ///< paths without indices, with all that lies below them: "poses[].pose"
};

/// The fields of a message type that are left out.
FieldFilter filter_for(const Field& definition, const LeftOut& left_out);

/// Those of the fields to leave out that no message type of the recording has.
std::vector<std::string> unknown_fields(const Recording& recording, const LeftOut& left_out);

/// Compares two runs stream by stream, sorted by topic and node. Reads both messages of each pair, one pair
/// at a time.
Comparison compare_recordings(const Recording& first, const Recording& second, const LeftOut& left_out);

}  // namespace tzc::compare
