// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tzc::msggen {

/// An ASCII digit, in every locale.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Without white space at both ends; what counts is what Python's str.strip() takes, beyond ASCII too: genmsg
/// uses it.
std::string_view strip(std::string_view text);

/// The line up to its comment, stripped.
std::string_view without_comment(std::string_view line);

/// The line's words. Only blanks separate them (a tab does not: that is genmsg's rule); each is stripped.
std::vector<std::string_view> words(std::string_view text);

/// The items of a list, empty ones left out.
std::vector<std::string> split(std::string_view list, char separator);

/// The column, counted in characters from 1, of a piece of the line.
std::size_t column_of(std::string_view line, std::string_view piece);

/// How many characters UTF-8 text has.
std::size_t character_count(std::string_view text);

/// Offset of the first byte that is not UTF-8; npos: there is none.
std::size_t find_invalid_utf8(std::string_view text);

/// The text with every byte that is not UTF-8, and every NUL, replaced by '?'.
std::string with_replacements(std::string_view text);

/// Text mode as in Python: "\r\n" and "\r" become "\n".
std::string with_unix_newlines(std::string_view text);

/// The candidate nearest to a mistyped name, empty when none is near. Letter case counts little.
std::string nearest(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace tzc::msggen
