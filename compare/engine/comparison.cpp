// SPDX-License-Identifier: BSD-3-Clause
#include "engine/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace tzc::compare {
namespace {

using Key = std::pair<std::string, std::string>;

/// Compares the pairs of one stream.
class PairComparer {
 public:
  PairComparer(const Stream& first, const Stream& second, const LeftOut& left_out)
      : first_(first),
        second_(second),
        // Without a definition a message is one run of bytes.
        definition_(parse_definition(first.datatype, first.definition).value_or(Field())),
        masks_(definition_, filter_for(definition_, left_out)) {}

  void compare(const IndexPair& pair, StreamComparison& result) const {
    Bytes first = first_.read(pair.first), second = second_.read(pair.second);
    masks_.apply(first);
    masks_.apply(second);
    if (first == second) {
      ++result.equal;
      return;
    }
    for (FieldDifference& difference : field_differences(definition_, first, second)) {
      FieldCount& count = result.fields[difference.field];
      if (count.messages++ != 0) continue;
      count.example_pair = pair;
      count.example = std::move(difference);
    }
  }

 private:
  const Stream& first_;
  const Stream& second_;
  const Field definition_;
  const Masks masks_;
};

StreamComparison describe(const Stream* first, const Stream* second) {
  const Stream& any = first ? *first : *second;
  StreamComparison result;
  result.topic = any.topic;
  result.publisher = any.publisher;
  result.datatype = any.datatype;
  result.first.is_advertised = first != nullptr;
  result.second.is_advertised = second != nullptr;
  if (first) result.first.messages = first->messages.size();
  if (first) result.first.silence_s = first->silence_seconds();
  if (second) result.second.messages = second->messages.size();
  if (second) result.second.silence_s = second->silence_seconds();
  return result;
}

StreamComparison compare_streams(const Stream* first, const Stream* second, const LeftOut& left_out) {
  StreamComparison result = describe(first, second);
  if (!first || !second) return result;
  const bool are_known = !first->messages.empty() && !second->messages.empty();
  if (first->datatype != second->datatype || (are_known && first->md5sum != second->md5sum)) {
    result.type_difference = fmt::format("{} ({}) against {} ({})", first->datatype, first->md5sum,
                                         second->datatype, second->md5sum);
    return result;
  }
  result.pairing = pair_messages(first->messages, second->messages);
  const PairComparer comparer(*first, *second, left_out);
  for (const IndexPair& pair : result.pairing.pairs) comparer.compare(pair, result);
  return result;
}

}  // namespace

FieldFilter filter_for(const Field& definition, const LeftOut& left_out) {
  return [&definition, left_out](const std::string& path) {
    const auto& fields = left_out.fields;
    return std::find(fields.begin(), fields.end(), path) != fields.end() ||
           (left_out.header_stamps && is_header_stamp(definition, path));
  };
}

std::vector<std::string> unknown_fields(const Recording& recording, const LeftOut& left_out) {
  std::vector<std::string> unknown = left_out.fields;
  const std::function<void(const Field&)> look = [&](const Field& field) {
    unknown.erase(std::remove(unknown.begin(), unknown.end(), field.path), unknown.end());
    for (const Field& child : field.children) look(child);
  };
  for (const Stream& stream : recording)
    if (const std::optional<Field> definition = parse_definition(stream.datatype, stream.definition))
      look(*definition);
  return unknown;
}

Comparison compare_recordings(const Recording& first, const Recording& second, const LeftOut& left_out) {
  std::map<Key, std::pair<const Stream*, const Stream*>> streams;
  for (const Stream& stream : first) streams[stream.key()].first = &stream;
  for (const Stream& stream : second) streams[stream.key()].second = &stream;
  Comparison comparison;
  for (const auto& [key, pair] : streams)
    comparison.push_back(compare_streams(pair.first, pair.second, left_out));
  return comparison;
}

}  // namespace tzc::compare
