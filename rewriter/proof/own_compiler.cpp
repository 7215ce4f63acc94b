// SPDX-License-Identifier: BSD-3-Clause
#include "proof/own_compiler.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <mutex>
#include <utility>

#include "buildfiles/build_trees.h"
#include "edits/files.h"
#include "edits/in_parallel.h"
#include "edits/standard_flags.h"
#include "proof/compiler_output.h"
#include "proof/compiler_reads.h"
#include "proof/process.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

using Words = std::vector<std::string>;

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The command with -fsyntax-only in place of its outputs. With options that GCC and Clang have: an unknown one would be the only
/// error, before the port and after it.
Words diagnostics_only(const Words& arguments) {
  Words words = without_outputs(arguments);
  words.insert(words.end(), {"-fsyntax-only", "-fdiagnostics-color=never"});
  return words;
}

/// The words of a command up to its compiler: "ccache g++".
Words compiler_of(const CompileCommand& command) {
  const auto end = std::find_if(command.arguments.begin(), command.arguments.end(),
                                [](const std::string& word) { return word.rfind("-", 0) == 0; });
  Words words(command.arguments.begin(), end);
  if (words.size() > 1 && words.back() == command.file) words.pop_back();
  return words;
}

bool takes_prefix_map(const Words& compiler) {
  Words probe = compiler;
  probe.insert(probe.end(), {"-fmacro-prefix-map=/a=/b", "-fsyntax-only", "-x", "c++", "/dev/null"});
  return run_process(probe).status == 0;
}

bool is_include_flag(const std::string& word) {
  return is_one_of(word, {"-I", "-isystem", "-iquote", "-idirafter", "-include", "-imacros"});
}

std::vector<CompilerError> run_compiler(const Words& arguments, const std::string& directory,
                                        const std::string& unit) {
  const ProcessResult result = run_process(Command{arguments, directory, {{"LC_ALL", "C"}}});
  if (result.status == 0) return {};
  std::vector<CompilerError> errors = read_compiler_output(result.errors);
  if (errors.empty()) {
    const std::string line = result.errors.substr(0, result.errors.find('\n'));
    errors.push_back({unit, {unit, 0, 0}, line.empty() ? arguments[0] + " could not be run" : line, {}});
  }
  for (CompilerError& error : errors) error.unit = unit;
  return errors;
}

void remove_known(std::vector<CompilerError>& errors, const std::vector<CompilerError>& known) {
  const auto is_known = [&](const CompilerError& error) {
    return std::any_of(known.begin(), known.end(), [&](const CompilerError& other) {
      return other.text == error.text && other.where.file == error.where.file;
    });
  };
  errors.erase(std::remove_if(errors.begin(), errors.end(), is_known), errors.end());
}

/// Where it lies, with these words.
std::vector<CompilerError> errors_in_place(const CompileCommand& command, const Words& arguments) {
  std::vector<CompilerError> errors =
      run_compiler(diagnostics_only(arguments), command.directory, command.canonical);
  for (CompilerError& error : errors)
    error.where.file = canonical_path((fs::path(command.directory) / error.where.file).string());
  return errors;
}

}  // namespace

std::vector<CompilerError> errors_of_cxx14(const CompileCommand& command) {
  Words raised = command.arguments;
  std::transform(raised.begin(), raised.end(), raised.begin(), raised_standard);
  std::vector<CompilerError> errors = errors_in_place(command, raised);
  if (!errors.empty()) remove_known(errors, errors_in_place(command, command.arguments));
  return errors;
}

Expected<void> OwnCompiler::read_commands() {
  if (!commands_.empty()) return {};
  for (const std::string& build_dir : setup_.build_dirs) {
    Expected<std::vector<CompileCommand>> commands = read_compile_commands(build_dir);
    if (!commands) return commands.error();
    std::move(commands->begin(), commands->end(), std::back_inserter(commands_));
  }
  return {};
}

Expected<void> OwnCompiler::make_copy() {
  if (copy_) return {};
  Expected<ScratchFolder> folder = ScratchFolder::make();
  if (!folder) return folder.error();
  folder_ = std::make_unique<ScratchFolder>(std::move(*folder));
  std::vector<std::string> omitted;
  for (const std::string& build_dir : setup_.build_dirs)
    for (std::string& path : build_paths(build_dir, setup_.packages)) omitted.push_back(std::move(path));
  copy_ = std::make_unique<ScratchWorkspace>(setup_.root, setup_.packages, *folder_ / "src", omitted);
  return copy_->make();
}

/// A word of a command with the package's paths replaced, relative ones included.
std::string OwnCompiler::scratch_word(const std::string& word, const std::string& directory) const {
  const bool relative = !word.empty() && word[0] != '/' && word[0] != '-';
  if (!relative) return copy_->to_scratch().in_word(word);
  const std::string absolute = (fs::path(directory) / word).lexically_normal();
  return is_there(absolute) ? copy_->to_scratch().in_word(absolute) : word;
}

bool OwnCompiler::is_built(const std::string& file) const {
  return std::any_of(setup_.build_dirs.begin(), setup_.build_dirs.end(), [&](const std::string& folder) {
    return is_below(canonical_path(file), canonical_path(folder));
  });
}

/// A file of a build folder that includes the packages' sources by absolute paths (unity builds, precompiled
/// headers) is copied, with these paths replaced; a compiled form of it is left behind.
std::string OwnCompiler::scratch_source(const std::string& file) const {
  const std::string mapped = copy_->to_scratch().in_word(file);
  if (mapped != file) return mapped;
  const Expected<std::string> content = read_file(file);
  if (!content || !is_built(file)) return file;
  const std::string copy = *folder_ / ("generated-" + std::to_string(std::hash<std::string>()(file)) + "-" +
                                       fs::path(file).filename().string());
  std::ofstream(copy, std::ios::binary) << copy_->to_scratch().in_includes(*content);
  return copy;
}

/// What -include names. The compiler looks for a relative name where it runs, and then, as for #include "...", in the
/// command's folders: that name stays, the folders lead to the port.
std::string OwnCompiler::scratch_included(const std::string& name, const std::string& directory) const {
  const std::string here = (fs::path(directory) / name).lexically_normal();
  return is_there(here) ? scratch_source(here) : name;
}

std::vector<std::string> OwnCompiler::ported_command(const CompileCommand& command) const {
  Words words;
  const Words plain = diagnostics_only(command.arguments);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::string& word = plain[i];
    const bool included = i > 0 && is_one_of(plain[i - 1], {"-include", "-imacros"});
    if (included)
      words.push_back(scratch_included(word, command.directory));
    else if (canonical_path((fs::path(command.directory) / word).string()) == command.canonical)
      words.push_back(scratch_source((fs::path(command.directory) / word).lexically_normal()));
    else if (i > 0 && is_include_flag(plain[i - 1]))
      words.push_back(scratch_word(word, command.directory));
    else
      words.push_back(copy_->to_scratch().in_word(raised_standard(word)));
  }
  for (const std::string& define : setup_.defines) words.push_back("-D" + define);
  // With -isystem the C library's folder would come before C++'s own headers, which then do not find it behind them.
  for (const std::string& folder : setup_.include_dirs)
    words.insert(words.end(), {folder == "/usr/include" ? "-idirafter" : "-isystem", folder});
  return words;
}

/// With them __FILE__ has the same value as in the build.
std::vector<std::string> OwnCompiler::prefix_maps() const {
  Words flags;
  for (const std::string& package : setup_.packages)
    flags.push_back("-fmacro-prefix-map=" + copy_->scratch(package) + "=" + copy_->named(package));
  return flags;
}

std::vector<OwnCompiler::Task> OwnCompiler::tasks_for(const std::set<std::string>& units) const {
  std::vector<Task> tasks;
  std::set<Words> known;
  std::map<Words, bool> has_prefix_map;
  for (const CompileCommand& command : commands_) {
    if (!units.count(command.canonical) || command.arguments.empty()) continue;
    Task task{command.canonical, &command, ported_command(command), {}, ""};
    const auto probed = has_prefix_map.try_emplace(compiler_of(command), false);
    if (probed.second) probed.first->second = takes_prefix_map(probed.first->first);
    if (probed.first->second) {
      const Words maps = prefix_maps();
      task.arguments.insert(task.arguments.end(), maps.begin(), maps.end());
    }
    if (known.insert(task.arguments).second) tasks.push_back(std::move(task));
  }
  return tasks;
}

/// Each task lists what it reads in a make rule.
void OwnCompiler::record_reads(std::vector<Task>& tasks) const {
  if (!setup_.accesses) return;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    tasks[i].reads = *folder_ / ("reads-" + std::to_string(i) + ".d");
    std::error_code ignored;
    fs::remove(tasks[i].reads, ignored);
    tasks[i].arguments.insert(tasks[i].arguments.end(), {"-MD", "-MF", tasks[i].reads});
  }
}

void OwnCompiler::note_reads(const Task& task) const {
  if (!setup_.accesses) return;
  const Expected<std::string> rule = read_file(task.reads);
  if (!rule) return setup_.accesses->give_up();
  const CompilerReads reads{task.arguments, copy_->to_scratch().in_word(task.command->directory),
                            folder_->path()};
  note_compiler_reads(*rule, reads, *setup_.accesses);
}

std::vector<CompilerError> OwnCompiler::ported_errors(const Task& task) const {
  const std::string directory = copy_->to_scratch().in_word(task.command->directory);
  std::vector<CompilerError> errors = run_compiler(task.arguments, directory, task.unit);
  const auto to_user = [&](Location& where) {
    const std::string absolute = (fs::path(directory) / where.file).lexically_normal();
    where.file = canonical_path(copy_->to_user().in_word(absolute));
  };
  for (CompilerError& error : errors) {
    to_user(error.where);
    for (Location& note : error.notes) to_user(note);
  }
  if (errors.empty()) return errors;
  remove_known(errors, original_errors(*task.command));
  return errors;
}

std::vector<CompilerError> OwnCompiler::original_errors(const CompileCommand& command) const {
  if (setup_.accesses) setup_.accesses->give_up();  // errors are rare and worth a second look
  return errors_in_place(command, command.arguments);
}

Expected<std::vector<CompilerError>> OwnCompiler::check(const FileContents& contents,
                                                        const std::set<std::string>& units) {
  for (const auto step : {&OwnCompiler::read_commands, &OwnCompiler::make_copy})
    if (Expected<void> done = (this->*step)(); !done) return done.error();
  if (Expected<void> done = copy_->write(contents); !done) return done.error();
  std::vector<Task> tasks = tasks_for(units);
  record_reads(tasks);
  std::mutex mutex;
  unsigned read = 0;
  in_parallel(setup_.jobs, tasks.size(), [&](std::size_t i) {
    tasks[i].errors = ported_errors(tasks[i]);
    note_reads(tasks[i]);
    const std::lock_guard<std::mutex> lock(mutex);
    if (setup_.progress) setup_.progress(++read, static_cast<unsigned>(tasks.size()), tasks[i].unit);
  });
  std::vector<CompilerError> errors;
  for (Task& task : tasks)
    errors.insert(errors.end(), std::make_move_iterator(task.errors.begin()),
                  std::make_move_iterator(task.errors.end()));
  return errors;
}

Expected<std::vector<CompilerError>> OwnCompiler::errors_of_original(const std::string& unit) {
  if (Expected<void> done = read_commands(); !done) return done.error();
  std::vector<CompilerError> errors;
  for (const CompileCommand& command : commands_)
    if (command.canonical == unit)
      for (CompilerError& error : original_errors(command)) errors.push_back(std::move(error));
  return errors;
}

}  // namespace tzc::rewriter
