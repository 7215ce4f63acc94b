// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace tzc::rewriter {

/// Words and signs of a text, one each: "sensor_msgs", ":", ":", "Image", "&".
using CodeWords = std::vector<std::string>;

/// What may take the const from a message: const_cast<TYPE>, const_pointer_cast<TYPE>, (TYPE&)x, MessageEvent<TYPE>(event, false).
struct CodeCast {
  CodeWords type;
  unsigned line = 0;     ///< from 1
  bool is_c = false;     ///< (TYPE&)x, which mostly takes no const
  bool of_this = false;  ///< of the object that the function belongs to, which is no message
};

/// What a text of C++ says about such casts, by its words: there is no syntax tree of it.
struct CastsOfCode {
  std::vector<CodeCast> casts;
  std::map<std::string, std::vector<CodeWords>> aliases;  ///< using NAME = TYPE, typedef, macros
  std::set<std::string> parameters;                       ///< of templates
};

/// `text`: comments and literals blanked.
CastsOfCode casts_of_code(const std::string& text);

}  // namespace tzc::rewriter
