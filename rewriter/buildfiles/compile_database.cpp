// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/compile_database.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// "NAME" of ".../CMakeFiles/NAME.dir/...".
std::string target_in(const std::string& text) {
  static const std::string before = "CMakeFiles/", after = ".dir/";
  const std::size_t end = text.rfind(after);
  if (end == std::string::npos) return "";
  const std::size_t begin = text.rfind(before, end);
  if (begin == std::string::npos) return "";
  return text.substr(begin + before.size(), end - begin - before.size());
}

std::string output_of(const json& entry, const std::vector<std::string>& arguments) {
  if (entry.contains("output")) return entry["output"];
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i)
    if (arguments[i] == "-o") return arguments[i + 1];
  return "";
}

/// "DIRECTORY/demo" for an output "demo/CMakeFiles/NAME.dir/...".
std::string target_dir_of(const std::string& directory, const std::string& output) {
  const std::size_t end = output.rfind("CMakeFiles/");
  if (end == std::string::npos) return "";
  return canonical_path((fs::path(directory) / output.substr(0, end)).string());
}

/// Reads one word; `at` ends behind it.
std::string shell_word(const std::string& text, std::size_t& at) {
  std::string word;
  for (char quote = 0; at < text.size() && (quote || !std::isspace(static_cast<unsigned char>(text[at])));
       ++at) {
    const char c = text[at];
    const bool escapes = c == '\\' && quote != '\'' && at + 1 < text.size() &&
                         (!quote || std::string("\\\"$`").find(text[at + 1]) != std::string::npos);
    if (escapes)
      word += text[++at];
    else if (quote ? c == quote : c == '"' || c == '\'')
      quote = quote ? '\0' : c;
    else
      word += c;
  }
  return word;
}

constexpr unsigned deepest_response_file = 10;  // one may name others, and itself

/// In place of @FILE come the words of the file, as with GCC; where there is none, the word stays.
void add_arguments(CompileCommand& command, const std::vector<std::string>& words, unsigned depth) {
  for (const std::string& word : words) {
    const std::string file = word[0] == '@' ? (fs::path(command.directory) / word.substr(1)).string() : "";
    const Expected<std::string> text = file.empty() || depth == 0 ? Error() : read_file(file);
    if (!text) {
      command.arguments.push_back(word);
      continue;
    }
    command.response_files.push_back(file);
    add_arguments(command, shell_words(*text), depth - 1);
  }
}

CompileCommand command_of(const json& entry) {
  CompileCommand command;
  command.directory = entry.value("directory", "");
  const fs::path file = entry.at("file").get<std::string>();
  command.file = file.is_absolute() ? file : command.directory / file;
  command.canonical = canonical_path(command.file);
  add_arguments(command,
                entry.contains("arguments") ? entry["arguments"].get<std::vector<std::string>>()
                                            : shell_words(entry.value("command", "")),
                deepest_response_file);
  const std::string output = output_of(entry, command.arguments);
  command.target = target_in(output);
  command.target_dir = target_dir_of(command.directory, output);
  return command;
}

}  // namespace

std::vector<std::string> shell_words(const std::string& command) {
  std::vector<std::string> words;
  for (std::size_t at = 0;;) {
    at = command.find_first_not_of(" \t\r\n", at);
    if (at == std::string::npos) return words;
    words.push_back(shell_word(command, at));
  }
}

Expected<std::vector<CompileCommand>> read_compile_commands(const std::string& build_dir) {
  const std::string path = build_dir + "/compile_commands.json";
  const Expected<std::string> text = read_file(path);
  if (!text) return text.error();
  std::vector<CompileCommand> commands;
  try {
    for (const json& entry : json::parse(*text)) commands.push_back(command_of(entry));
  } catch (const json::exception& broken) {
    return Error{std::string("is not a compilation database: ") + broken.what(), path,
                 "configure the workspace again"};
  }
  return commands;
}

std::vector<std::string> without_outputs(const std::vector<std::string>& arguments) {
  static const std::set<std::string> with_value = {"-o", "-MF", "-MT", "-MQ"};
  static const std::set<std::string> alone = {"-c", "-MD", "-MMD", "-MP", "-M", "-MM", "-MG"};
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (with_value.count(arguments[i]))
      ++i;
    else if (!alone.count(arguments[i]))
      kept.push_back(arguments[i]);
  }
  return kept;
}

Expected<std::map<std::string, std::set<std::string>>> targets_of_files(const std::string& build_dir) {
  const auto commands = read_compile_commands(build_dir);
  if (!commands) return commands.error();
  std::map<std::string, std::set<std::string>> targets;
  for (const CompileCommand& command : *commands) {
    if (command.target.empty()) continue;
    targets[command.canonical].insert(command.target);
    for (const std::string& source : unity_sources(command.file)) targets[source].insert(command.target);
  }
  return targets;
}

Expected<std::set<std::string>> compiled_files(const std::string& build_dir) {
  const auto commands = read_compile_commands(build_dir);
  if (!commands) return commands.error();
  std::set<std::string> files;
  for (const CompileCommand& command : *commands) {
    files.insert(command.canonical);
    for (const std::string& source : unity_sources(command.file)) files.insert(source);
  }
  return files;
}

std::vector<std::string> unity_sources(const std::string& file) {
  static const std::regex name("unity_[0-9]+_cxx\\.cxx"), include("#include \"([^\"\n]+)\"");
  if (!std::regex_match(fs::path(file).filename().string(), name)) return {};
  const Expected<std::string> text = read_file(file);
  std::vector<std::string> sources;
  if (!text) return sources;
  for (std::sregex_iterator at(text->begin(), text->end(), include), end; at != end; ++at)
    sources.push_back(canonical_path(fs::path(file).parent_path() / (*at)[1].str()));
  return sources;
}

}  // namespace tzc::rewriter
