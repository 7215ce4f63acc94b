// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/cmake_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace tzc::rewriter {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c));
}

class Parser {
 public:
  Parser(std::string_view content, const std::string& path) : text_(content), path_(path) {}

  Expected<std::vector<CmakeCommand>> run() {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) at_ = byte_order_mark.size();
    std::vector<CmakeCommand> commands;
    while (skip_blanks(), at_ < text_.size() && !failed_) {
      if (!is_word(text_[at_])) return error("a command was expected");
      CmakeCommand command = read_name();
      skip_spaces();
      if (peek() != '(') return error("'(' was expected after " + command.name);
      command.open = ++at_;
      read_arguments(command);
      commands.push_back(std::move(command));
    }
    if (failed_) return error("something is opened here and never closed");
    return commands;
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  Error error(const std::string& what) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + std::min(at_, text_.size()), '\n');
    return {what, path_ + ":" + std::to_string(line), "make sure that cmake itself can read the file"};
  }

  void skip_spaces() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  void skip_blanks() {
    for (skip_spaces(); peek() == '#'; skip_spaces()) skip_comment();
  }

  void skip_comment() {
    ++at_;
    if (const std::size_t length = bracket_length()) return void(read_bracket(length));
    at_ = std::min(text_.find('\n', at_), text_.size());
  }

  CmakeCommand read_name() {
    CmakeCommand command;
    command.begin = at_;
    for (; is_word(peek()); ++at_) command.name += std::tolower(static_cast<unsigned char>(text_[at_]));
    return command;
  }

  /// Parentheses nest inside arguments: if((A) AND (B)).
  void read_arguments(CmakeCommand& command) {
    for (int depth = 0; skip_blanks(), !failed_;) {
      if (at_ >= text_.size()) return fail_at(command.begin);
      if (text_[at_] == ')' && depth-- == 0) break;
      if (text_[at_] == '(' || text_[at_] == ')')
        depth += text_[at_++] == '(';
      else
        command.arguments.push_back(read_argument());
    }
    command.close = at_++;
  }

  CmakeArgument read_argument() {
    CmakeArgument argument;
    argument.begin = at_;
    if (const std::size_t length = bracket_length()) {
      argument.text = read_bracket(length);
      argument.bracket = true;
    } else if (peek() == '"') {
      argument.text = read_quoted();
    } else {
      argument.text = read_unquoted();
    }
    argument.end = at_;
    return argument;
  }

  /// Of "[[", "[=[", ... at the current place; 0: none.
  std::size_t bracket_length() const {
    if (peek() != '[') return 0;
    std::size_t length = 1;
    while (peek(length) == '=') ++length;
    return peek(length) == '[' ? length + 1 : 0;
  }

  std::string read_bracket(std::size_t length) {
    const std::string closing = "]" + std::string(length - 2, '=') + "]";
    const std::size_t begin = at_ + length, end = text_.find(closing, begin);
    if (end == std::string_view::npos) return fail_at(at_), "";
    at_ = end + closing.size();
    return std::string(text_.substr(begin, end - begin));
  }

  std::string read_quoted() {
    const std::size_t begin = at_++;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\';
    if (at_ >= text_.size()) return fail_at(begin), "";
    return std::string(text_.substr(begin + 1, at_++ - begin - 1));
  }

  std::string read_unquoted() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_]) &&
           std::string_view("()#").find(text_[at_]) == std::string_view::npos) {
      if (text_[at_] == '"')
        read_quoted();  // legacy: -Da="b c"
      else
        at_ += text_[at_] == '\\' ? 2 : 1;
      if (failed_) break;
    }
    at_ = std::min(at_, text_.size());
    return std::string(text_.substr(begin, at_ - begin));
  }

  void fail_at(std::size_t offset) {
    failed_ = true;
    at_ = offset;
  }

  std::string_view text_;
  std::string path_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace

bool has_cmake_name(const std::string& file) {
  const std::filesystem::path path(file);
  return path.filename().string().rfind("CMakeLists", 0) == 0 || path.extension() == ".cmake";
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Expected<std::vector<CmakeCommand>> parse_cmake(std::string_view content, const std::string& path) {
  return Parser(content, path).run();
}

std::size_t find_argument(const CmakeCommand& command, std::string_view text, std::size_t from) {
  for (std::size_t i = from; i < command.arguments.size(); ++i)
    if (command.arguments[i].text == text) return i;
  return std::string::npos;
}

}  // namespace tzc::rewriter
