// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/language_standard.h"

#include <regex>
#include <set>
#include <vector>

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

/// The variables that a command takes the standard from: -std=${STANDARD}, -std=c++${NUMBER}, set(CMAKE_CXX_STANDARD ${NUMBER})
void add_variables(const CmakeListFile& file, const CmakeCommand& command, std::set<std::string>& variables) {
  static const std::regex flag("-std=(?:(?:c|gnu)\\+\\+)?\\$\\{(\\w+)\\}"), whole("\\$\\{(\\w+)\\}");
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const CmakeArgument& argument = command.arguments[i];
    const std::string written = file.content.substr(argument.begin, argument.end - argument.begin);
    for (std::sregex_iterator at(written.begin(), written.end(), flag), end; at != end; ++at)
      variables.insert(at->str(1));
    std::smatch match;
    const std::string before = i == 0 ? "" : command.arguments[i - 1].text;
    if ((before == "CMAKE_CXX_STANDARD" || before == "CXX_STANDARD") &&
        std::regex_match(argument.text, match, whole))
      variables.insert(match.str(1));
  }
}

/// set(STANDARD c++11), if nothing else in the file gives the variable a value.
void variable_of(const CmakeListFile& file, const std::string& variable, Edits& edits) {
  static const std::regex old("((?:c|gnu)\\+\\+)?(98|03|0x|11)");
  std::vector<const CmakeCommand*> sets;
  for (const CmakeCommand& command : file.commands)
    if (!command.arguments.empty() && command.arguments[0].text == variable && command.name == "set")
      sets.push_back(&command);
  if (sets.size() != 1 || sets.front()->arguments.size() < 2) return;
  const CmakeArgument& value = sets.front()->arguments[1];
  const std::string written = file.content.substr(value.begin, value.end - value.begin);
  std::smatch match;
  const std::string bare = value.text;
  const std::size_t quote = written.find(bare);
  if (quote == std::string::npos || !std::regex_match(bare, match, old)) return;
  edits.push_back(replacement(file.path, value.begin + quote + static_cast<std::size_t>(match.position(2)),
                              static_cast<std::size_t>(match.length(2)), "14"));
}

/// check_cxx_compiler_flag("-std=c++11" HAS_11) asks the compiler, it sets nothing.
bool only_asks(const CmakeCommand& command) {
  return command.name == "check_cxx_compiler_flag" || command.name == "message" || command.name == "if" ||
         command.name == "elseif";
}

}  // namespace

Edits raise_to_cxx14(const CmakeListFile& file) {
  Edits edits;
  std::set<std::string> variables;
  for (const CmakeCommand& command : file.commands) {
    if (only_asks(command)) continue;
    add_variables(file, command, variables);
    if (command.name == "set" || command.name == "set_target_properties" || command.name == "set_property")
      numbers_of(file, command, edits);
    for (const CmakeArgument& argument : command.arguments) flags_of(file, argument, edits);
  }
  for (const std::string& variable : variables) variable_of(file, variable, edits);
  return edits;
}

}  // namespace tzc::rewriter
