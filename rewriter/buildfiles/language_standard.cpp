// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/language_standard.h"

#include <regex>

namespace tzc::rewriter {
namespace {

bool is_old_number(const std::string& text) {
  return text == "98" || text == "03" || text == "11";
}

Edit replacement(const std::string& path, std::size_t begin, std::size_t length, const std::string& text) {
  Edit edit;
  edit.file = path;
  edit.offset = begin;
  edit.length = length;
  edit.text = text;
  edit.rule = "language-standard";
  return edit;
}

/// "-std=c++0x", "-std=gnu++11", "cxx_std_11" anywhere in an argument.
void flags_of(const CmakeListFile& file, const CmakeArgument& argument, Edits& edits) {
  static const std::regex old("(-std=(?:c|gnu)\\+\\+|cxx_std_)(98|03|0x|11)(?![0-9a-z])");
  const std::string written = file.content.substr(argument.begin, argument.end - argument.begin);
  for (std::sregex_iterator at(written.begin(), written.end(), old), end; at != end; ++at)
    edits.push_back(replacement(file.path, argument.begin + at->position(2), at->length(2), "14"));
}

/// set(CMAKE_CXX_STANDARD 11), set_target_properties(x PROPERTIES CXX_STANDARD 11)
void numbers_of(const CmakeListFile& file, const CmakeCommand& command, Edits& edits) {
  for (std::size_t i = 0; i + 1 < command.arguments.size(); ++i) {
    const CmakeArgument& value = command.arguments[i + 1];
    const std::string& name = command.arguments[i].text;
    if ((name == "CMAKE_CXX_STANDARD" || name == "CXX_STANDARD") && is_old_number(value.text))
      edits.push_back(replacement(file.path, value.begin, value.end - value.begin, "14"));
  }
}

/// check_cxx_compiler_flag("-std=c++11" HAS_11) asks the compiler, it sets nothing.
bool only_asks(const CmakeCommand& command) {
  return command.name == "check_cxx_compiler_flag" || command.name == "message" || command.name == "if" ||
         command.name == "elseif";
}

}  // namespace

Edits raise_to_cxx14(const CmakeListFile& file) {
  Edits edits;
  for (const CmakeCommand& command : file.commands) {
    if (only_asks(command)) continue;
    if (command.name == "set" || command.name == "set_target_properties" || command.name == "set_property")
      numbers_of(file, command, edits);
    for (const CmakeArgument& argument : command.arguments) flags_of(file, argument, edits);
  }
  return edits;
}

}  // namespace tzc::rewriter
