// SPDX-License-Identifier: BSD-3-Clause
#include "pairing/pairing.h"

#include <algorithm>
#include <map>
#include <set>

namespace tzc::compare {
namespace {

using Messages = std::vector<MessageFacts>;
using Indices = std::vector<std::size_t>;

std::map<std::int64_t, Indices> by_stamp(const Messages& messages) {
  std::map<std::int64_t, Indices> groups;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (!messages[i].header || messages[i].header->nanoseconds == 0) return {};
    groups[messages[i].header->nanoseconds].push_back(i);
  }
  return groups;
}

/// What has not been paired yet, on both sides, ascending.
struct Rest {
  Indices first, second;
};

/// Pairs those for which `key` gives the same, in order; a null key pairs with nothing.
template <class Key>
void pair_equal(const Messages& first, const Messages& second, Rest& rest, const Key& key,
                std::vector<IndexPair>& pairs) {
  std::map<std::uint64_t, Indices> seconds;
  for (auto index = rest.second.rbegin(); index != rest.second.rend(); ++index) {
    if (const auto value = key(second[*index])) seconds[*value].push_back(*index);
  }
  Indices left;
  std::set<std::size_t> used;
  for (const std::size_t index : rest.first) {
    const auto value = key(first[index]);
    const auto found = value ? seconds.find(*value) : seconds.end();
    if (found == seconds.end() || found->second.empty()) {
      left.push_back(index);
      continue;
    }
    pairs.emplace_back(index, found->second.back());
    used.insert(found->second.back());
    found->second.pop_back();
  }
  rest.first = left;
  const auto is_used = [&](std::size_t index) { return used.count(index) != 0; };
  rest.second.erase(std::remove_if(rest.second.begin(), rest.second.end(), is_used), rest.second.end());
}

void pair_in_order(Rest& rest, std::vector<IndexPair>& pairs) {
  const auto common = static_cast<std::ptrdiff_t>(std::min(rest.first.size(), rest.second.size()));
  for (std::ptrdiff_t i = 0; i < common; ++i)
    pairs.emplace_back(rest.first[static_cast<std::size_t>(i)], rest.second[static_cast<std::size_t>(i)]);
  rest.first.erase(rest.first.begin(), rest.first.begin() + common);
  rest.second.erase(rest.second.begin(), rest.second.begin() + common);
}

std::optional<std::uint64_t> digest_key(const MessageFacts& message) {
  return message.digest;
}
std::optional<std::uint64_t> sequence_key(const MessageFacts& message) {
  if (!message.header) return std::nullopt;
  return message.header->seq;
}

bool pair_by_stamp(const Messages& first, const Messages& second, std::vector<IndexPair>& pairs) {
  const auto firsts = by_stamp(first), seconds = by_stamp(second);
  for (const auto& [stamp, indices] : firsts) {
    const auto found = seconds.find(stamp);
    if (found == seconds.end()) continue;
    Rest rest{indices, found->second};
    pair_equal(first, second, rest, digest_key, pairs);
    pair_in_order(rest, pairs);
  }
  const bool has_enough = !pairs.empty() && pairs.size() * 2 >= std::min(first.size(), second.size());
  if (!has_enough) pairs.clear();
  return has_enough;
}

std::vector<std::uint64_t> digests(const Messages& messages) {
  std::vector<std::uint64_t> all(messages.size());
  std::transform(messages.begin(), messages.end(), all.begin(),
                 [](const auto& message) { return message.digest; });
  return all;
}

/// The unpaired messages between two neighbouring pairs, both excluded.
Rest gap(const IndexPair& begin, const IndexPair& end, const std::set<std::size_t>& first_paired,
         const std::set<std::size_t>& second_paired) {
  Rest rest;
  for (std::size_t i = begin.first; i < end.first; ++i) {
    if (first_paired.count(i) == 0) rest.first.push_back(i);
  }
  for (std::size_t i = begin.second; i < end.second; ++i) {
    if (second_paired.count(i) == 0) rest.second.push_back(i);
  }
  return rest;
}

/// Pairs the remaining messages within each gap between aligned ones; returns how.
PairedBy fill_gaps(const Messages& first, const Messages& second, const std::vector<IndexPair>& anchors,
                   std::vector<IndexPair>& pairs) {
  std::set<std::size_t> first_paired, second_paired;
  for (const IndexPair& pair : pairs) {
    first_paired.insert(pair.first);
    second_paired.insert(pair.second);
  }
  PairedBy by = anchors.empty() ? PairedBy::order : PairedBy::content;
  IndexPair begin{0, 0};
  for (std::size_t i = 0; i <= anchors.size(); ++i) {
    const IndexPair end = i < anchors.size() ? anchors[i] : IndexPair{first.size(), second.size()};
    Rest rest = gap(begin, end, first_paired, second_paired);
    const std::size_t before = pairs.size();
    pair_equal(first, second, rest, sequence_key, pairs);
    if (pairs.size() == before)
      pair_in_order(rest, pairs);
    else if (anchors.empty())
      by = PairedBy::sequence;
    begin = {end.first + 1, end.second + 1};
  }
  return by;
}

PairedBy pair_by_content(const Messages& first, const Messages& second, std::vector<IndexPair>& pairs) {
  const std::vector<IndexPair> anchors = align(digests(first), digests(second));
  pairs = anchors;
  Rest moved = gap({0, 0}, {first.size(), second.size()}, {}, {});
  const auto drop = [&](Indices& indices, auto member) {
    std::set<std::size_t> paired;
    for (const IndexPair& pair : anchors) paired.insert(pair.*member);
    indices.erase(
        std::remove_if(indices.begin(), indices.end(), [&](auto i) { return paired.count(i) != 0; }),
        indices.end());
  };
  drop(moved.first, &IndexPair::first);
  drop(moved.second, &IndexPair::second);
  pair_equal(first, second, moved, digest_key, pairs);
  return fill_gaps(first, second, anchors, pairs);
}

Unpaired unpaired(const Messages& messages, const Indices& sorted) {
  Unpaired result;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (std::binary_search(sorted.begin(), sorted.end(), i)) continue;
    const bool is_before = !sorted.empty() && i < sorted.front(),
               is_after = !sorted.empty() && i > sorted.back();
    (is_before ? result.before : is_after ? result.after : result.between).push_back(i);
  }
  return result;
}

std::size_t count_duplicates(const Messages& messages, const Unpaired& extra) {
  std::map<std::pair<std::uint64_t, std::int64_t>, std::size_t> copies;
  const auto key = [](const MessageFacts& m) {
    return std::pair(m.digest, m.header ? m.header->nanoseconds : 0);
  };
  for (const MessageFacts& message : messages) ++copies[key(message)];
  std::size_t duplicates = 0;
  for (const Indices* indices : {&extra.before, &extra.between, &extra.after})
    for (const std::size_t index : *indices) {
      std::size_t& left = copies[key(messages[index])];
      if (left > 1) ++duplicates, --left;
    }
  return duplicates;
}

}  // namespace

Pairing pair_messages(const Messages& first, const Messages& second) {
  Pairing pairing;
  pairing.by = pair_by_stamp(first, second, pairing.pairs) ? PairedBy::stamp
                                                           : pair_by_content(first, second, pairing.pairs);
  std::sort(pairing.pairs.begin(), pairing.pairs.end());
  Indices firsts, seconds;
  for (const IndexPair& pair : pairing.pairs) {
    firsts.push_back(pair.first);
    seconds.push_back(pair.second);
  }
  std::sort(seconds.begin(), seconds.end());
  pairing.first_only = unpaired(first, firsts);
  pairing.second_only = unpaired(second, seconds);
  pairing.reordered = count_reordered(pairing.pairs);
  pairing.duplicates = count_duplicates(second, pairing.second_only);
  return pairing;
}

const char* name(PairedBy by) {
  switch (by) {
    case PairedBy::stamp:
      return "stamp";
    case PairedBy::content:
      return "content";
    case PairedBy::sequence:
      return "header.seq";
    case PairedBy::order:
      return "order";
  }
  return "";
}

}  // namespace tzc::compare
