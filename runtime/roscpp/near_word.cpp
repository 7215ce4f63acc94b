// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/near_word.h"

#include <algorithm>
#include <numeric>

namespace tzc {
namespace detail {
namespace {

std::string plain(const std::string& word) {
  std::string letters;
  for (const char c : word)
    if (c != '_' && c != '-') letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return letters;
}

/// Levenshtein's distance.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& valid,
                         const std::string& prefix) {
  const std::string* best = nullptr;
  std::size_t least = std::max<std::size_t>(2, word.size() / 4) + 1;
  for (const std::string& one : valid) {
    const std::size_t apart = distance(plain(word), plain(one));
    if (apart >= least) continue;
    least = apart;
    best = &one;
  }
  return best ? " (did you mean " + prefix + *best + "?)" : std::string();
}

}  // namespace detail
}  // namespace tzc
