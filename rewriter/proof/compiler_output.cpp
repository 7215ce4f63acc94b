// SPDX-License-Identifier: BSD-3-Clause
#include "proof/compiler_output.h"

#include <cstdlib>
#include <optional>
#include <sstream>

namespace tzc::rewriter {
namespace {

struct Line {
  Location where;
  std::string rest;  ///< behind "file:line:column: "
};

unsigned number_at(const std::string& text, std::size_t& at) {
  char* end = nullptr;
  const unsigned long number = std::strtoul(text.c_str() + at, &end, 10);
  at = static_cast<std::size_t>(end - text.c_str());
  return static_cast<unsigned>(number);
}

bool is_digit_at(const std::string& text, std::size_t at) {
  return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

/// "file:line: rest" or "file:line:column: rest".
std::optional<Line> located(const std::string& text) {
  std::size_t colon = text.find(':');
  while (colon != std::string::npos && !is_digit_at(text, colon + 1)) colon = text.find(':', colon + 1);
  if (colon == std::string::npos || colon == 0) return {};
  Line line;
  line.where.file = text.substr(0, colon);
  std::size_t at = colon + 1;
  line.where.line = number_at(text, at);
  if (at < text.size() && text[at] == ':' && is_digit_at(text, at + 1))
    line.where.column = number_at(text, ++at);
  if (at >= text.size() || text[at] != ':') return {};
  const std::size_t rest = text.find_first_not_of(' ', at + 1);
  line.rest = rest == std::string::npos ? "" : text.substr(rest);
  return line;
}

/// The text behind one of the words, none: the line says something else.
std::optional<std::string> behind(const std::string& text, std::initializer_list<const char*> words) {
  for (const std::string word : words)
    if (text.compare(0, word.size(), word) == 0) return text.substr(word.size());
  return {};
}

bool leads_to_error(const std::string& rest) {
  return behind(rest, {"required from", "required by", "recursively required", "in "}).has_value();
}

class Reader {
 public:
  void read(const std::string& text) {
    if (text.rfind(' ', 0) == 0) return;  // a line of the source
    const std::optional<Line> line = located(text);
    if (!line) return;
    if (const auto error = behind(line->rest, {"fatal error: ", "error: "})) {
      errors.push_back({"", line->where, *error, std::move(leading_)});
      leading_.clear();
      in_error_ = true;
    } else if (behind(line->rest, {"note: "})) {
      if (in_error_) errors.back().notes.push_back(line->where);
    } else if (behind(line->rest, {"warning: "})) {
      in_error_ = false;
      leading_.clear();
    } else if (leads_to_error(line->rest)) {
      leading_.push_back(line->where);
    }
  }

  std::vector<CompilerError> errors;

 private:
  std::vector<Location> leading_;
  bool in_error_ = false;
};

}  // namespace

std::vector<CompilerError> read_compiler_output(const std::string& output) {
  Reader reader;
  std::istringstream stream(output);
  for (std::string line; std::getline(stream, line);) reader.read(line);
  return std::move(reader.errors);
}

}  // namespace tzc::rewriter
