// SPDX-License-Identifier: BSD-3-Clause
#include "port/cache_inputs.h"

#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "buildfiles/build_trees.h"
#include "buildfiles/cmake_file.h"
#include "buildfiles/compile_database.h"
#include "buildfiles/find_packages.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "proof/compiler_reads.h"
#include "proof/configuration.h"
#include "workspace/build_folder.h"
#include "workspace/own_messages.h"
#include "workspace/places.h"

extern char** environ;

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// What lets a CMake file read what CMake does not list, in lower case.
const char* const reaching[] = {"execute_process", "exec_program",    "file(download",
                                "fetchcontent",    "externalproject", "try_run"};

/// Whether it names ENV{NAME} of a session, or of a name that only CMake can tell.
bool names_session_variable(const std::string& text) {
  static const std::string opening = "ENV{";
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    at += opening.size();
    const std::size_t end = text.find_first_of("{}", at);
    if (end == std::string::npos || text[end] == '{' || is_session_variable(text.substr(at, end - at)))
      return true;
  }
  return false;
}

bool reaches_beyond(std::string text) {
  if (names_session_variable(text)) return true;
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::any_of(std::begin(reaching), std::end(reaching),
                     [&](const char* command) { return text.find(command) != std::string::npos; });
}

int note_library(dl_phdr_info* info, std::size_t, void* places) {
  if (info->dlpi_name && info->dlpi_name[0] == '/')
    static_cast<std::set<FileAccesses::Entry>*>(places)->emplace(info->dlpi_name, Access::content);
  return 0;
}

class Collector {
 public:
  explicit Collector(const PortInputs& inputs) : inputs_(inputs), options_(inputs.options) {}

  CacheInputs run(const std::vector<std::string>& packages) {
    add_options();
    add_environment();
    add_program();
    for (const std::string& package : packages) add_package(package);
    found_.settings = settings_.str();
    return std::move(found_);
  }

 private:
  /// Each text with its length, so that no two lists of texts look the same.
  void say(const std::string& name, const std::string& value) {
    settings_ << name << " " << value.size() << " " << value << "\n";
  }
  void say(const std::string& name, const std::vector<std::string>& values) {
    say(name, std::to_string(values.size()));
    for (const std::string& value : values) say("", value);
  }
  void depend_on(const fs::path& path, Access access = Access::content) {
    found_.places.emplace(path.string(), access);
  }

  void add_options() {
    say("version", TZC_VERSION);
    std::error_code failed;
    say("folder", fs::current_path(failed));
    say("packages", options_.packages);
    say("only", options_.only);
    say("except", options_.except);
    say("dead", options_.dead_files);
    say("build", options_.build_dir);
    say("includes", options_.tzc_includes);
    for (const auto number : {static_cast<int>(options_.level), static_cast<int>(options_.on_exhausted),
                              static_cast<int>(options_.verify), static_cast<int>(options_.strict),
                              static_cast<int>(options_.dual)})
      say("choice", std::to_string(number));
    say("small", std::to_string(options_.small));
    say("memory", options_.mem_size ? std::to_string(*options_.mem_size) : "");
    for (const auto& [topic, size] : inputs_.measured_sizes) say(topic, std::to_string(size));
  }

  /// As a digest: passwords of a CI are among the variables, and caches are kept and handed on.
  void add_environment() {
    std::vector<std::string> variables;
    for (char** entry = environ; *entry; ++entry) {
      const std::string text = *entry;
      if (!is_session_variable(text.substr(0, text.find('=')))) variables.push_back(text);
    }
    std::sort(variables.begin(), variables.end());
    std::string all;
    for (const std::string& variable : variables) all += variable + '\0';
    say("environment", inputs_.engine.digest(all));
  }

  /// This program, the libraries that it is made of, and TZC's headers.
  void add_program() {
    depend_on("/proc/self/exe");
    dl_iterate_phdr(note_library, &found_.places);
    const Expected<std::vector<std::string>> includes = find_tzc_includes(options_.tzc_includes);
    if (includes) say("headers", *includes);
    say("prefixes", find_tzc_prefixes(options_.tzc_includes));
  }

  void add_package(const std::string& package) {
    found_.trees.insert(package);
    add_source_space(source_space(package));
    for (fs::path folder = package;; folder = folder.parent_path()) {
      for (const char* settings : {".clang-format", "_clang-format", ".tzc-rewrite.yaml"})
        depend_on(folder / settings);
      if (!folder.has_relative_path()) break;
    }
    const Expected<PackageXml> xml = read_package_xml(package);
    const std::string build_dir = build_dir_of({package, xml ? xml->name : ""});
    say("build of " + package, build_dir);
    if (build_dir.empty()) return;
    omit(build_dir, package);
    add_compile_commands(build_dir);
    for (fs::path folder = build_dir; folder.has_relative_path(); folder = folder.parent_path())
      depend_on(folder / "CMakeCache.txt");
    add_messages(package, build_dir);
    if (options_.verify != Verify::source) add_configuration(build_dir, package);
  }

  /// Users and copies of headers. Catkin finds packages behind symbolic links, too.
  void add_source_space(const std::string& space) {
    found_.trees.insert(space);
    const Expected<std::vector<std::string>> packages = find_packages_at(space);
    if (!packages) return;
    for (const std::string& package : *packages)
      if (!is_below(package, space)) found_.trees.insert(package);
  }

  void add_compile_commands(const std::string& build_dir) {
    depend_on(build_dir + "/compile_commands.json");
    if (const auto commands = read_compile_commands(build_dir))
      for (const CompileCommand& command : *commands)
        for (const std::string& file : command.response_files) depend_on(file);
  }

  /// Where sources and results share folders, only what is surely none of the sources is left out.
  void omit(const std::string& build_dir, const std::string& package) {
    for (const std::string& path : build_paths(build_dir, {package})) found_.omitted.insert(path);
  }

  std::string build_dir_of(const PackagePlace& package) const {
    const Expected<std::string> found = find_build_dir(package, options_.build_dir, options_.packages);
    return found ? *found : find_configured_dir(package, options_.build_dir, options_.packages);
  }

  void add_messages(const std::string& package, const std::string& build_dir) {
    const MessageSources sources = message_sources(package, build_dir);
    say("messages", std::vector<std::string>(sources.folders.begin(), sources.folders.end()));
    for (const std::string& folder : sources.folders) depend_on(folder, Access::tree);
    if (!sources.generator.empty()) depend_on(sources.generator);
  }

  /// What CMake looks at and does not list: where packages, libraries and programs are searched for.
  void add_configuration(const std::string& build_dir, const std::string& package) {
    const std::unique_ptr<UserBuild> user = UserBuild::find(build_dir);
    if (!user) return;
    omit(user->build_dir, package);
    if (!configured_.insert(user->build_dir).second) return;
    found_.trees.insert(user->source);
    for (const char* tree : {"CATKIN_DEVEL_PREFIX", "CMAKE_INSTALL_PREFIX"})
      if (const std::string folder = user->cache.value(tree); !folder.empty())
        found_.omitted.insert(canonical_path(folder));
    const std::string cmake = user->cache.value("CMAKE_COMMAND");
    depend_on(program_path(cmake.empty() ? "cmake" : cmake));
    depend_on(fs::path(std::getenv("HOME") ? std::getenv("HOME") : "/") / ".cmake/packages", Access::names2);
    depend_on("/var/lib/dpkg/status");  // whatever else is installed by packages
    std::istringstream list(user->cache.value("CMAKE_PREFIX_PATH") + ";" +
                            user->cache.value("CMAKE_INSTALL_PREFIX") + ";/usr;/usr/local;/");
    for (std::string prefix; std::getline(list, prefix, ';');) add_prefix(prefix);
    std::istringstream paths(std::getenv("CMAKE_PREFIX_PATH") ? std::getenv("CMAKE_PREFIX_PATH") : "");
    for (std::string prefix; std::getline(paths, prefix, ':');) add_prefix(prefix);
    for (const std::string& prefix : find_tzc_prefixes(options_.tzc_includes)) add_prefix(prefix);
    refuse_what_cannot_be_followed(user->source);
  }

  void add_prefix(const fs::path& prefix) {
    if (!prefix.is_absolute() || !prefixes_.insert(prefix).second) return;
    depend_on(prefix, Access::names);
    for (const char* folder : {"bin", "include", "lib64"}) depend_on(prefix / folder, Access::names);
    for (const char* folder : {"share", "lib/cmake", "lib/pkgconfig", "share/pkgconfig"})
      depend_on(prefix / folder, Access::names2);
    depend_on(prefix / "lib", Access::names);
    for (const char* folder : {"lib/pkgconfig", "share/pkgconfig"}) depend_on(prefix / folder, Access::tree);
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(prefix / "lib", none)) {
      const std::string name = entry.path().filename();
      if (name.rfind("python", 0) == 0) add_python(entry.path());
      if (name.find("-linux-gnu") == std::string::npos) continue;
      depend_on(entry.path(), Access::names);
      depend_on(entry.path() / "cmake", Access::names2);
      depend_on(entry.path() / "pkgconfig", Access::tree);
    }
  }

  /// catkin's CMake files run these modules.
  void add_python(const fs::path& python) {
    for (const char* packages : {"dist-packages", "site-packages"}) {
      depend_on(python / packages, Access::names);
      std::error_code none;
      for (const auto& entry : fs::directory_iterator(python / packages, none)) {
        const std::string name = entry.path().filename();
        if (name == "em.py") depend_on(entry.path());
        if (name.rfind("catkin", 0) == 0 || name.rfind("gen", 0) == 0) depend_on(entry.path(), Access::tree);
      }
    }
  }

  /// A CMake file of the workspace that asks other programs may read anything.
  void refuse_what_cannot_be_followed(const std::string& source) {
    std::error_code failed;
    const auto options = fs::directory_options::skip_permission_denied;
    for (auto at = fs::recursive_directory_iterator(source, options, failed), end = decltype(at){};
         !failed && at != end; at.increment(failed)) {
      std::error_code ignored;
      if (found_.omitted.count(at->path()) != 0 || at->path().filename() == ".git")
        at.disable_recursion_pending();
      if (!has_cmake_name(at->path()) || at->is_symlink(ignored) || !at->is_regular_file(ignored)) continue;
      const Expected<std::string> text = read_file(at->path());
      if (text && reaches_beyond(*text)) found_.complete = false;
    }
  }

  const PortInputs& inputs_;
  const PortOptions& options_;
  std::ostringstream settings_;
  std::set<std::string> configured_, prefixes_;
  CacheInputs found_;
};

}  // namespace

bool is_session_variable(const std::string& name) {
  static const std::set<std::string> names = {"_",
                                              "SHLVL",
                                              "OLDPWD",
                                              "PWD",
                                              "TERM",
                                              "COLORTERM",
                                              "LS_COLORS",
                                              "DISPLAY",
                                              "WINDOWID",
                                              "COLUMNS",
                                              "LINES",
                                              "SSH_TTY",
                                              "SSH_CLIENT",
                                              "SSH_CONNECTION",
                                              "STY",
                                              "TMUX",
                                              "SSH_AUTH_SOCK",
                                              "TMUX_PANE",
                                              "XAUTHORITY",
                                              "HISTSIZE",
                                              "HISTFILE",
                                              "PS1",
                                              "BUILD_ID",
                                              "WAYLAND_DISPLAY",
                                              "INVOCATION_ID",
                                              "JOURNAL_STREAM",
                                              "BUILD_TAG",
                                              "XDG_SESSION_ID",
                                              "BUILD_URL",
                                              "BUILD_NUMBER",
                                              "DBUS_SESSION_BUS_ADDRESS"};
  // Of CI systems, of git while it runs a hook, and of terminals.
  static const char* const prefixes[] = {
      "GITHUB_",         "RUNNER_", "ACTIONS_", "CI_",  "GITLAB_", "JENKINS_", "GIT_",
      "GNOME_TERMINAL_", "KITTY_",  "VSCODE_",  "VTE_", "TERM_",   "WT_"};
  return names.count(name) != 0 ||
         std::any_of(std::begin(prefixes), std::end(prefixes),
                     [&](const char* prefix) { return name.rfind(prefix, 0) == 0; });
}

CacheInputs cache_inputs(const std::vector<std::string>& packages, const PortInputs& inputs) {
  return Collector(inputs).run(packages);
}

}  // namespace tzc::rewriter
