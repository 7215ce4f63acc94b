// SPDX-License-Identifier: BSD-3-Clause
#include "proof/paths.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace tzc::rewriter {
namespace {

bool is_name_char(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-' || c == '/';
}

/// Whether an absolute path can begin here: "/a" in "-I/a" and in "X=/a", not in "/b/a".
bool begins_path(const std::string& text, std::size_t at) {
  if (at == 0 || !is_name_char(text[at - 1])) return true;
  static const std::vector<std::string> flags = {"-I",       "-isystem", "-iquote", "-idirafter",
                                                 "-include", "-imacros", "-L",      "-B"};
  return std::find(flags.begin(), flags.end(), text.substr(0, at)) != flags.end();
}

bool is_folder_at(const std::string& text, std::size_t at, const std::string& folder) {
  if (text.compare(at, folder.size(), folder) != 0) return false;
  const std::size_t end = at + folder.size();
  return end == text.size() || text[end] == '/' || !is_name_char(text[end]);
}

std::string line_at(const std::string& text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return text.substr(at, end == std::string::npos ? end : end + 1 - at);
}

bool is_include(const std::string& line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string::npos || line[hash] != '#') return false;
  const std::size_t word = line.find_first_not_of(" \t", hash + 1);
  return word != std::string::npos && line.compare(word, 7, "include") == 0;
}

}  // namespace

void PathMap::add(std::string from, std::string to) {
  mappings_.push_back({std::move(from), std::move(to)});
}

void PathMap::except(std::string folder) {
  except_.push_back(std::move(folder));
}

bool PathMap::applies(const std::string& text, std::size_t at, const std::string& folder) const {
  if (!is_folder_at(text, at, folder) || !begins_path(text, at)) return false;
  return std::none_of(except_.begin(), except_.end(),
                      [&](const std::string& other) { return is_folder_at(text, at, other); });
}

std::string PathMap::in_word(const std::string& word) const {
  std::string result;
  for (std::size_t at = 0; at < word.size();) {
    const auto found = std::find_if(mappings_.begin(), mappings_.end(),
                                    [&](const auto& one) { return applies(word, at, one.from); });
    if (found == mappings_.end()) {
      result += word[at++];
    } else {
      result += found->to;
      at += found->from.size();
    }
  }
  return result;
}

std::string PathMap::in_includes(const std::string& source) const {
  const bool named = std::any_of(mappings_.begin(), mappings_.end(),
                                 [&](const auto& one) { return source.find(one.from) != std::string::npos; });
  if (!named) return source;
  std::string result;
  for (std::size_t at = 0; at < source.size();) {
    const std::string line = line_at(source, at);
    result += is_include(line) ? in_word(line) : line;
    at += line.size();
  }
  return result;
}

}  // namespace tzc::rewriter
