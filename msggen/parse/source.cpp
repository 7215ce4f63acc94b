// SPDX-License-Identifier: BSD-3-Clause
#include "parse/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "parse/text.h"

namespace tzc::msggen {
namespace {

constexpr std::size_t largest_file = 4u << 20;

Diagnostic fault_of_file(const std::string& file, std::string message, std::string hint) {
  Diagnostic d;
  d.file = file;
  d.message = std::move(message);
  d.hint = std::move(hint);
  return d;
}

Diagnostic fault_at(const std::string& file, std::string_view bytes, std::size_t offset, std::string message,
                    std::string hint) {
  Diagnostic d = fault_of_file(file, std::move(message), std::move(hint));
  const std::string before = with_unix_newlines(bytes.substr(0, offset));
  const std::size_t line_start = before.rfind('\n') + 1;
  const std::string_view rest = bytes.substr(offset);
  const std::string_view line_end = rest.substr(0, rest.find_first_of("\r\n"));
  d.source_line = with_replacements(before.substr(line_start)) + with_replacements(line_end);
  d.at.line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  d.at.column = 1 + character_count(with_replacements(before.substr(line_start)));
  return d;
}

}  // namespace

std::optional<Source> decode(std::string file, std::string_view bytes, Diagnostics& diagnostics) {
  if (bytes.size() > largest_file) {
    diagnostics.report(fault_of_file(file, fmt::format("the file has {} bytes", bytes.size()),
                                     "a message definition is text, at most 4 MB of it"));
    return std::nullopt;
  }
  const std::size_t zero = bytes.find('\0');
  const std::size_t invalid = std::min(zero, find_invalid_utf8(bytes));
  if (invalid != std::string_view::npos) {
    auto what =
        fmt::format("the file is not text: byte 0x{:02x}", static_cast<unsigned char>(bytes[invalid]));
    diagnostics.report(fault_at(file, bytes, invalid, what, "message definitions are UTF-8 text"));
    return std::nullopt;
  }
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") {
    diagnostics.report(fault_at(file, bytes, 0, "the file begins with a byte order mark",
                                "genmsg takes it for a part of the first line: save as UTF-8 without it"));
    bytes.remove_prefix(3);
  }
  return Source{std::move(file), with_unix_newlines(bytes)};
}

bool is_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

std::optional<Source> read_source(const std::string& file, Diagnostics& diagnostics) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();  // fails for an empty file, too; an iterator would throw for a folder
  if (!in.is_open() || (bytes.fail() && errno != 0)) {
    diagnostics.report(
        fault_of_file(file, fmt::format("cannot read the file: {}", std::strerror(errno)), ""));
    return std::nullopt;
  }
  return decode(file, bytes.str(), diagnostics);
}

std::vector<Line> split_lines(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1;; ++number) {
    const std::size_t end = text.find('\n');
    lines.push_back({number, text.substr(0, end)});
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
  }
}

std::vector<Section> split_sections(const Source& source) {
  std::vector<Section> sections(1);
  for (const Line& line : split_lines(source.text)) {
    if (line.text.substr(0, 3) == "---") {
      sections.emplace_back();
      continue;
    }
    sections.back().text.append(line.text).append("\n");
    sections.back().lines.push_back(line);
  }
  return sections;
}

}  // namespace tzc::msggen
