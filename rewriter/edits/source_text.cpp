// SPDX-License-Identifier: BSD-3-Clause
#include "edits/source_text.h"

#include <algorithm>
#include <cctype>

namespace tzc::rewriter {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
    if (text[i] != '\n') text[i] = ' ';
}

std::size_t end_of_literal(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  for (; end < text.size() && text[end] != text[at] && text[end] != '\n'; ++end)
    if (text[end] == '\\') ++end;
  return end;
}

/// The end of the line that `at` is on; a line that ends in a backslash goes on.
std::size_t end_of_logical_line(const std::string& text, std::size_t at) {
  for (at = text.find('\n', at); at != std::string::npos; at = text.find('\n', at + 1)) {
    const std::size_t last = text.find_last_not_of('\r', at - 1);
    if (last == std::string::npos || text[last] != '\\') return at;
  }
  return text.size();
}

/// Whether the quotation mark at `at` begins a raw string: behind R, LR, uR, UR or u8R.
bool begins_raw_string(const std::string& text, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  static const std::set<std::string> prefixes = {"R", "LR", "uR", "UR", "u8R"};
  return text[at] == '"' && prefixes.count(text.substr(begin, at - begin)) != 0;
}

/// The last character of the literal whose quotation mark is at `at`.
std::size_t end_of_raw_string(const std::string& text, std::size_t at) {
  const std::size_t parenthesis = std::min(text.find('(', at), text.size());
  const std::string end = ")" + text.substr(at + 1, parenthesis - at - 1) + "\"";
  const std::size_t found = text.find(end, parenthesis);
  return found == std::string::npos ? text.size() : found + end.size() - 1;
}

/// Behind the brace that closes the block around `at`, or the block that begins there.
std::size_t closing_brace(const std::string& text, std::size_t at, int depth) {
  for (; at < text.size(); ++at) {
    if (text[at] == '{') ++depth;
    if (text[at] == '}' && --depth == 0) return at + 1;
  }
  return text.size();
}

std::size_t end_of_directive(const std::string& text, std::size_t at) {
  for (; at < text.size() && text[at] != '\n'; ++at)
    if (text[at] == '\\') ++at;
  return at;
}

std::string first_word(const std::string& text) {
  const auto begin = std::find_if(text.begin(), text.end(), is_word);
  return {begin, std::find_if_not(begin, text.end(), is_word)};
}

/// Goes through the declarations of namespaces.
class Definitions {
 public:
  explicit Definitions(const std::string& text) : text_(text) {}

  std::map<std::string, TextRange> run() {
    for (std::size_t at = 0; at < text_.size(); at = after(at)) {
    }
    return std::move(found_);
  }

 private:
  std::size_t after(std::size_t at) {
    const char c = text_[at];
    if (c == '#') return begin_ = end_of_directive(text_, at);
    if (c == '}') return begin_ = at + 1;  // of a namespace
    if (c == ';') return statement(at);
    return c == '{' ? block(at) : at + 1;
  }

  std::size_t statement(std::size_t at) {
    static const std::set<std::string> others = {"class", "static", "struct", "template", "typedef", "using"};
    const std::string words = text_.substr(begin_, at - begin_);
    const bool declares_variable = words.find('(') == std::string::npos && !others.count(first_word(words));
    if (declares_variable) add(at);
    return begin_ = at + 1;
  }

  std::size_t block(std::size_t at) {
    const std::string head = text_.substr(begin_, at - begin_);
    const std::set<std::string> words = identifiers_in(head);
    const bool is_namespace = words.count("namespace") != 0;
    const bool is_linkage = words == std::set<std::string>{"extern"};  // the literal is blank
    if (is_linkage || (is_namespace && words.size() > 1)) return begin_ = at + 1;
    const std::size_t end = closing_brace(text_, at, 0);
    if (!is_namespace && !words.count("main") && first_word(head) != "static") add(end);
    return begin_ = end;
  }

  void add(std::size_t end) {
    const std::string words = squeezed(text_.substr(begin_, end - begin_));
    if (!words.empty()) found_[words] = {begin_, end};
  }

  const std::string& text_;
  std::size_t begin_ = 0;
  std::map<std::string, TextRange> found_;
};

std::size_t behind_blanks(const std::string& text, std::size_t at) {
  return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

/// The member that is called of what ends at `at`; empty: none is. No regular expression: a comment of any length may lie between.
std::string called_member(const std::string& text, std::size_t at) {
  at = behind_blanks(text, at);
  const std::size_t access = text.compare(at, 1, ".") == 0 ? 1 : text.compare(at, 2, "->") == 0 ? 2 : 0;
  if (access == 0) return "";
  const std::size_t begin = behind_blanks(text, at + access);
  std::size_t end = begin;
  while (end < text.size() && is_word(text[end])) ++end;
  return text.compare(behind_blanks(text, end), 1, "(") == 0 ? text.substr(begin, end - begin) : "";
}

}  // namespace

std::map<std::string, TextRange> definitions_in(const std::string& text) {
  return Definitions(text).run();
}

std::string without_comments(const std::string& source) {
  std::string text = source;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::string two = text.substr(at, 2);
    if (two == "//") {
      const std::size_t end = end_of_logical_line(text, at);
      blank(text, at, end);
      at = end;
    } else if (two == "/*") {
      const std::size_t end = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
      blank(text, at, end);
      at = end - 1;
    } else if (text[at] == '"' || (text[at] == '\'' && (at == 0 || !is_word(text[at - 1])))) {
      const std::size_t end =
          begins_raw_string(text, at) ? end_of_raw_string(text, at) : end_of_literal(text, at);
      blank(text, at + 1, end);
      at = end;
    }
  }
  return text;
}

std::string squeezed(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; }),
             text.end());
  return text;
}

std::set<std::string> identifiers_in(const std::string& text) {
  std::set<std::string> found;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_word(text[at])) continue;
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    found.insert(text.substr(at, end - at));
    at = end;
  }
  return found;
}

bool only_calls_members(const std::string& text, const std::string& name,
                        const std::set<std::string>& members) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end]))) continue;
    if (members.count(called_member(text, end)) == 0) return false;
  }
  return true;
}

std::size_t offset_of(const std::string& text, unsigned line, unsigned column) {
  std::size_t at = 0;
  for (unsigned i = 1; i < line; ++i) {
    at = text.find('\n', at);
    if (at == std::string::npos) return text.size();
    ++at;
  }
  return std::min(text.size(), at + (column > 0 ? column - 1 : 0));
}

std::size_t end_of_block(const std::string& text, std::size_t offset) {
  return closing_brace(text, offset, 1);
}

std::size_t end_of_function(const std::string& text, std::size_t offset) {
  const std::size_t brace = text.find('{', offset), semicolon = text.find(';', offset);
  return brace == std::string::npos || semicolon < brace ? offset : closing_brace(text, brace, 0);
}

std::string function_around(const std::string& text, std::size_t offset) {
  int depth = 0;
  std::size_t at = std::min(offset, text.size());
  while (at > 0) {
    const char c = text[--at];
    if (c == ';' || c == '{' || c == '}') return "";
    if (c == ')') ++depth;
    if (c == '(' && --depth < 0) break;
  }
  if (depth >= 0) return "";
  while (at > 0 && std::isspace(static_cast<unsigned char>(text[at - 1]))) --at;
  std::size_t begin = at;
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  return text.substr(begin, at - begin);
}

}  // namespace tzc::rewriter
