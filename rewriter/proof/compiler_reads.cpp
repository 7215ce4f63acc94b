// SPDX-License-Identifier: BSD-3-Clause
#include "proof/compiler_reads.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "edits/files.h"
#include "proof/process.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

std::set<std::string> include_folders(const CompilerReads& reads) {
  std::set<std::string> folders = {"/usr/local/include"};
  const auto add = [&](const std::string& folder) {
    folders.insert((fs::path(reads.directory) / folder).lexically_normal());
  };
  const std::vector<std::string>& words = reads.arguments;
  for (std::size_t i = 0; i < words.size(); ++i)
    for (const std::string flag : {"-I", "-isystem", "-iquote", "-idirafter"}) {
      if (words[i] == flag && i + 1 < words.size())
        add(words[i + 1]);
      else if (words[i].rfind(flag, 0) == 0 && words[i] != flag)
        add(words[i].substr(flag.size()));
    }
  return folders;
}

/// "c", "b/c", "a/b/c" of /a/b/c: what an #include may have said.
std::vector<std::string> names_of(const std::string& file) {
  std::vector<std::string> names;
  for (std::size_t slash = file.rfind('/'); slash != std::string::npos && slash > 0;
       slash = file.rfind('/', slash - 1))
    names.push_back(file.substr(slash + 1));
  return names;
}

/// The driver and the compiler proper that it runs.
std::set<std::string> programs_of(const std::vector<std::string>& arguments) {
  std::set<std::string> programs;
  for (const std::string& word : arguments) {  // "ccache g++ -c ..."
    if (word.rfind("-", 0) == 0 || ::access(program_path(word).c_str(), X_OK) != 0) break;
    programs.insert(program_path(word));
    ProcessResult proper = run_process({word, "-print-prog-name=cc1plus"});
    while (!proper.output.empty() && proper.output.back() == '\n') proper.output.pop_back();
    if (proper.status == 0 && proper.output.rfind("/", 0) == 0) programs.insert(proper.output);
  }
  return programs;
}

}  // namespace

std::string program_path(const std::string& program) {
  if (program.find('/') != std::string::npos) return program;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const std::string file = folder + "/" + program; ::access(file.c_str(), X_OK) == 0) return file;
  return program;
}

std::vector<std::string> prerequisites_of(const std::string& rule) {
  std::vector<std::string> files;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty() && word.back() != ':') files.push_back(word);
    word.clear();
  };
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const char c = rule[i], next = i + 1 < rule.size() ? rule[i + 1] : '\0';
    if (c == '\\' && next == '\n') {
      end_word();
      ++i;
    } else if ((c == '\\' && (next == ' ' || next == '#' || next == '\\')) || (c == '$' && next == '$')) {
      word += next;
      ++i;
    } else if (c == ' ' || c == '\n' || c == '\t') {
      end_word();
    } else {
      word += c;
    }
  }
  end_word();
  return files;
}

void note_compiler_reads(const std::string& rule, const CompilerReads& reads, FileAccesses& accesses) {
  const std::set<std::string> folders = include_folders(reads);
  for (const std::string& word : prerequisites_of(rule)) {
    const std::string file = (fs::path(reads.directory) / word).lexically_normal();
    if (is_below(file, reads.scratch)) continue;
    accesses.note(file);
    for (const std::string& folder : folders)
      for (const std::string& name : names_of(file)) accesses.note(folder + "/" + name);
  }
  for (const std::string& program : programs_of(reads.arguments)) accesses.note(program);
}

}  // namespace tzc::rewriter
