// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

// Reads a source's text where there is no syntax tree: code that is not compiled. Comments and literals are
// blanked first, so that they are not taken for code.

namespace tzc::rewriter {

/// The text with spaces in place of comments and of the contents of string and character literals; lines and
/// offsets stay.
std::string without_comments(const std::string& source);

/// The text without white space.
std::string squeezed(std::string text);

std::set<std::string> identifiers_in(const std::string& text);

/// Whether each mention of the name is a call of one of these members of it: `name.member(` or `name->member(`.
bool only_calls_members(const std::string& text, const std::string& name,
                        const std::set<std::string>& members);

/// Where a definition lies.
struct TextRange {
  std::size_t begin = 0, end = 0;
};

/// Definitions with external linkage of a text without comments: classes, functions and variables of namespaces, by their
/// words without white space. Functions called main are of a program, not of a package.
std::map<std::string, TextRange> definitions_in(const std::string& text);

/// The offset of a line and column (from 1); the text's end where there is no such line.
std::size_t offset_of(const std::string& text, unsigned line, unsigned column);

/// The offset after the block of a local that is declared at `offset`.
std::size_t end_of_block(const std::string& text, std::size_t offset);

/// The offset after the body of the function whose parameter is at `offset`; `offset` where it has no body.
std::size_t end_of_function(const std::string& text, std::size_t offset);

/// The name before the parenthesis that encloses `offset`; empty: there is none.
std::string function_around(const std::string& text, std::size_t offset);

}  // namespace tzc::rewriter
