// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/cmake_values.h"

namespace tzc::rewriter {
namespace {

constexpr std::size_t most_values = 4096;  // lists have hundreds of elements
constexpr std::size_t longest_value = 64 * 1024, most_bytes = 4 * 1024 * 1024;
constexpr int deepest = 8;

/// The innermost ${...} that has a value in `values`; npos pairs when there is none.
struct Reference {
  std::size_t begin = std::string::npos, end = std::string::npos;
  std::string name;
};

Reference innermost_reference(const std::string& text, std::size_t from) {
  const std::size_t close = text.find('}', from);
  if (close == std::string::npos) return {};
  const std::size_t open = text.rfind("${", close);
  if (open == std::string::npos) return {};
  return {open, close + 1, text.substr(open + 2, close - open - 2)};
}

void split_list(const std::string& text, std::set<std::string>& out) {
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(';', begin)) != std::string::npos; begin = end + 1)
    out.insert(text.substr(begin, end - begin));
  out.insert(text.substr(begin));
}

std::string without(std::string text, const std::string& part) {
  for (std::size_t at; (at = text.find(part)) != std::string::npos;) text.erase(at, part.size());
  return text;
}

}  // namespace

/// What the variable held before is nothing that the file says, where a value still names it: set(FLAGS "${FLAGS} -Wall").
void CmakeValues::add(const std::string& variable, const std::string& text) {
  const std::set<std::string> more = expand(text);
  std::set<std::string>& values = values_[variable];
  for (const std::string& value : more)
    if (values.size() < most_values) values.insert(without(value, "${" + variable + "}"));
}

void CmakeValues::add(const std::string& variable, const CmakeCommand& command, std::size_t first) {
  for (std::size_t i = first; i < command.arguments.size(); ++i) {
    const std::string& text = command.arguments[i].text;
    if (text == "CACHE" || text == "PARENT_SCOPE") break;
    add(variable, text);
  }
}

/// foreach(name a b), foreach(name IN LISTS names ITEMS c d)
void CmakeValues::add_loop(const CmakeCommand& loop) {
  const std::string& variable = loop.arguments[0].text;
  if (loop.arguments.size() < 2 || loop.arguments[1].text != "IN") return add(variable, loop, 1);
  bool are_lists = false;
  for (std::size_t i = 2; i < loop.arguments.size(); ++i) {
    const std::string& text = loop.arguments[i].text;
    if (text == "LISTS" || text == "ITEMS")
      are_lists = text == "LISTS";
    else
      add(variable, are_lists ? "${" + text + "}" : text);
  }
}

void CmakeValues::learn(const CmakeCommand& command) {
  const auto& arguments = command.arguments;
  if (arguments.empty()) return;
  if (command.name == "project") {
    values_["PROJECT_NAME"] = {arguments[0].text};
    values_["CMAKE_PROJECT_NAME"] = {arguments[0].text};
  } else if (command.name == "set") {
    add(arguments[0].text, command, 1);
  } else if (command.name == "list" && arguments.size() > 2 && arguments[0].text == "APPEND") {
    add(arguments[1].text, command, 2);
  } else if (command.name == "foreach") {
    add_loop(command);
  }
}

std::set<std::string> CmakeValues::expand(const std::string& text) const {
  std::set<std::string> results, open = {text};
  std::size_t bytes = 0;
  for (int depth = 0; !open.empty() && depth < deepest; ++depth) {
    std::set<std::string> next;
    for (const std::string& value : open) {
      Reference reference = innermost_reference(value, 0);
      while (reference.begin != std::string::npos && !values_.count(reference.name))
        reference = innermost_reference(value, reference.end);
      if (reference.begin == std::string::npos || results.size() + next.size() > most_values)
        split_list(value, results);
      else
        for (const std::string& inner : values_.at(reference.name)) {
          const std::size_t size = value.size() + inner.size();
          if (next.size() >= most_values || size > longest_value || bytes > most_bytes) break;
          bytes += size;
          next.insert(value.substr(0, reference.begin) + inner + value.substr(reference.end));
        }
    }
    open = std::move(next);
  }
  for (const std::string& value : open) split_list(value, results);
  return results;
}

std::set<std::string> CmakeValues::expand(const CmakeCommand& command, std::size_t first) const {
  std::set<std::string> all;
  for (std::size_t i = first; i < command.arguments.size(); ++i)
    for (const std::string& value : expand(command.arguments[i].text)) all.insert(value);
  return all;
}

}  // namespace tzc::rewriter
