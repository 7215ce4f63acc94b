// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/insertion.h"

#include <algorithm>

namespace tzc::rewriter {
namespace {

Edit insertion(const std::string& path, std::size_t offset, const std::string& text) {
  Edit edit;
  edit.file = path;
  edit.offset = offset;
  edit.text = text;
  edit.rule = "build-files";
  return edit;
}

std::size_t line_end(std::string_view content, std::size_t offset) {
  std::size_t end = std::min(content.find('\n', offset), content.size());
  if (end > offset && content[end - 1] == '\r') --end;
  return end;
}

bool has_line_break(std::string_view content, std::size_t begin, std::size_t end) {
  return content.substr(begin, end - begin).find('\n') != std::string_view::npos;
}

/// The end of the line when only a comment stands between the argument and it.
std::size_t after_comment(std::string_view content, std::size_t argument_end) {
  const std::size_t end = line_end(content, argument_end);
  const std::size_t next = content.find_first_not_of(" \t", argument_end);
  return next == std::string_view::npos || next >= end || content[next] == '#' ? end : argument_end;
}

}  // namespace

std::string line_ending(std::string_view content) {
  const std::size_t end = content.find('\n');
  return end != std::string_view::npos && end > 0 && content[end - 1] == '\r' ? "\r\n" : "\n";
}

std::string indentation(std::string_view content, std::size_t offset) {
  const std::size_t previous = offset == 0 ? std::string_view::npos : content.rfind('\n', offset - 1);
  const std::size_t start = previous == std::string_view::npos ? 0 : previous + 1;
  const std::size_t end = std::min(content.find_first_not_of(" \t", start), content.size());
  return std::string(content.substr(start, end - start));
}

namespace {

Edit line_behind(const std::string& path, std::string_view content, std::size_t offset,
                 const std::string& line) {
  return insertion(path, line_end(content, offset), line_ending(content) + line);
}

}  // namespace

Edit add_argument(const std::string& path, std::string_view content, const CmakeCommand& command,
                  std::size_t index, const std::string& text) {
  const CmakeArgument& argument = command.arguments[index];
  const std::size_t before = index == 0 ? command.open : command.arguments[index - 1].end;
  if (!has_line_break(content, before, argument.begin)) return insertion(path, argument.end, " " + text);
  return insertion(path, after_comment(content, argument.end),
                   line_ending(content) + indentation(content, argument.begin) + text);
}

Edit add_line(const std::string& path, std::string_view content, std::size_t offset,
              const std::string& text) {
  return line_behind(path, content, offset, indentation(content, offset) + text);
}

Edit add_command(const std::string& path, std::string_view content, const CmakeCommand& before,
                 const std::string& text) {
  return line_behind(path, content, before.close, indentation(content, before.begin) + text);
}

}  // namespace tzc::rewriter
