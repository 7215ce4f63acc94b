// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/code_casts.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace tzc::rewriter {
namespace {

constexpr std::size_t longest_type = 100;  // words: a '<' behind which no '>' comes is no bracket

struct Word {
  std::string text;
  unsigned line = 0;
};

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool is_name(const std::string& word) {
  return !word.empty() && is_letter(word[0]) && !std::isdigit(static_cast<unsigned char>(word[0]));
}

std::vector<Word> words_of(const std::string& text) {
  std::vector<Word> words;
  unsigned line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    while (at < text.size() && is_letter(text[at])) ++at;
    if (at == begin) {
      if (text[at] == '\n') ++line;
      if (std::isspace(static_cast<unsigned char>(text[at++]))) continue;
    }
    words.push_back({text.substr(begin, at - begin), line});
  }
  return words;
}

class CastReader {
 public:
  explicit CastReader(const std::string& text) : words_(words_of(text)) {}

  CastsOfCode run() {
    for (std::size_t at = 0; at < words_.size(); ++at) {
      const std::string& word = words_[at].text;
      if (word == "const_cast" || word == "const_pointer_cast")
        add_cast(at);
      else if (word == "MessageEvent")
        add_event(at);
      else if (word == "(")
        add_c_cast(at);
      else if (word == "using" || word == "typedef" || word == "define")
        add_alias(at);
      else if (word == "typename" || word == "class")
        add_parameter(at);
    }
    return std::move(found_);
  }

 private:
  const std::string& word(std::size_t at) const {
    static const std::string none;
    return at < words_.size() ? words_[at].text : none;
  }

  /// Of the bracket that closes the one at `open`; 0: none does.
  std::size_t closing(std::size_t open, std::size_t longest) const {
    const std::string& opens = word(open);
    const std::string closes = opens == "<" ? ">" : ")";
    unsigned depth = 0;
    for (std::size_t at = open; at < std::min(words_.size(), open + longest); ++at) {
      if (word(at) == opens) ++depth;
      if (word(at) == closes && word(at - 1) != "-" && --depth == 0) return at;
    }
    return 0;
  }

  CodeWords between(std::size_t begin, std::size_t end) const {
    CodeWords words;
    for (std::size_t at = begin; at < std::min(end, words_.size()); ++at) words.push_back(words_[at].text);
    return words;
  }

  /// Of which only `header` is named: that is copied to each subscriber.
  bool serves_header(std::size_t parenthesis) const {
    std::size_t next = closing(parenthesis, words_.size()) + 1;
    if (word(next) == "-" && word(next + 1) == ">") ++next;
    return (word(next) == "." || word(next) == ">") && word(next + 1) == "header";
  }

  void add_cast(std::size_t at) {
    if (word(at + 1) != "<") return;
    const std::size_t end = closing(at + 1, longest_type);
    if (end == 0 || word(end + 1) != "(" || serves_header(end + 1)) return;
    const bool of_this = word(end + 2) == "this" || (word(end + 2) == "*" && word(end + 3) == "this");
    found_.casts.push_back({between(at + 2, end), words_[at].line, false, of_this});
  }

  void add_event(std::size_t at) {
    if (word(at + 1) != "<") return;
    const std::size_t end = closing(at + 1, longest_type);
    if (end == 0) return;
    for (std::size_t next = end; next < std::min(words_.size(), end + longest_type); ++next) {
      if (word(next) == ";" || word(next) == "{") return;
      if (word(next) != "false") continue;
      CodeWords type = between(at + 2, end);
      type.erase(std::remove(type.begin(), type.end(), "const"),
                 type.end());  // the other event may be written to
      return found_.casts.push_back({std::move(type), words_[at].line, false, false});
    }
  }

  /// Behind a name stands a list of parameters, or of arguments.
  bool begins_expression(std::size_t parenthesis) const {
    static const std::set<std::string> before = {"return", "else", "case", "co_return", "co_yield", "do"};
    if (parenthesis == 0) return false;
    const std::string& previous = word(parenthesis - 1);
    return before.count(previous) != 0 ||
           (!is_name(previous) && previous != ")" && previous != "]" && previous != ">");
  }

  void add_c_cast(std::size_t at) {
    static const std::set<std::string> after = {"const", "override", "final", "noexcept", "volatile"};
    if (!begins_expression(at)) return;
    const std::size_t end = closing(at, longest_type);
    if (end < at + 3 || (word(end - 1) != "*" && word(end - 1) != "&")) return;
    const std::string& next = word(end + 1);
    const bool is_operand =
        (is_name(next) && after.count(next) == 0) || next == "*" || next == "&" || next == "(";
    const CodeWords type = between(at + 1, end);
    const bool is_type = std::all_of(type.begin(), type.end(), [](const std::string& part) {
      static const std::set<std::string> signs = {":", "*", "&", "<", ">", ","};
      return part != "const" && (is_name(part) || signs.count(part) != 0);
    });
    if (is_operand && is_type && is_name(type.front()))
      found_.casts.push_back({type, words_[at].line, true, false});
  }

  void add_alias(std::size_t at) {
    const std::string& kind = word(at);
    if (kind == "define") return add_macro(at);
    std::size_t end = at;
    while (end < std::min(words_.size(), at + longest_type) && word(end) != ";" && word(end) != "{") ++end;
    if (word(end) != ";" || end < at + 3) return;
    if (kind == "typedef" && is_name(word(end - 1)))
      found_.aliases[word(end - 1)].push_back(between(at + 1, end - 1));
    if (kind == "using" && word(at + 2) == "=") found_.aliases[word(at + 1)].push_back(between(at + 3, end));
  }

  void add_macro(std::size_t at) {
    if (at == 0 || word(at - 1) != "#" || !is_name(word(at + 1))) return;
    std::size_t end = at + 2;
    while (end < words_.size() && (words_[end].line == words_[end - 1].line || word(end - 1) == "\\")) ++end;
    found_.aliases[word(at + 1)].push_back(between(at + 2, end));
  }

  /// template <typename M, class... Ms>
  void add_parameter(std::size_t at) {
    std::size_t name = at + 1;
    while (word(name) == ".") ++name;
    const std::string& next = word(name + 1);
    if (is_name(word(name)) && (next == "," || next == ">" || next == "="))
      found_.parameters.insert(word(name));
  }

  const std::vector<Word> words_;
  CastsOfCode found_;
};

}  // namespace

CastsOfCode casts_of_code(const std::string& text) {
  return CastReader(text).run();
}

}  // namespace tzc::rewriter
