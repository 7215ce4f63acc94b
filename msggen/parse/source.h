// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/diagnostic.h"

namespace tzc::msggen {

/// A definition file as Python's text mode would read it: UTF-8, lines end with '\n'.
struct Source {
  std::string file;
  std::string text;
};

/// One line of a source; the text lives as long as the source does.
struct Line {
  std::size_t number = 0;
  std::string_view text;
};

/// A part of a source that defines one message, for example the response half of a service.
struct Section {
  std::string text;  ///< what genmsg takes as the message's text
  std::vector<Line> lines;
};

/// Checks that the bytes are text (UTF-8, no NUL, no byte order mark, of reasonable size).
std::optional<Source> decode(std::string file, std::string_view bytes, Diagnostics& diagnostics);

/// Whether the path is that of a file, links followed.
bool is_file(const std::string& path);

/// Reads and decodes a file.
std::optional<Source> read_source(const std::string& file, Diagnostics& diagnostics);

/// The lines of a text, numbered from 1.
std::vector<Line> split_lines(std::string_view text);

/// The sections that `---` lines separate; every one ends with a newline, as in genmsg and actionlib.
std::vector<Section> split_sections(const Source& source);

}  // namespace tzc::msggen
