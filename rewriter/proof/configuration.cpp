// SPDX-License-Identifier: BSD-3-Clause
#include "proof/configuration.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

#include "buildfiles/build_trees.h"
#include "buildfiles/find_packages.h"
#include "edits/files.h"
#include "proof/process.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Entries that a project or the user sets, not CMake's internal ones.
bool is_carried_over(const CacheEntry& entry) {
  return entry.type != "INTERNAL" && entry.type != "STATIC" && !ends_with(entry.value, "NOTFOUND") &&
         entry.name != "CMAKE_PREFIX_PATH" && entry.name != "CATKIN_DEVEL_PREFIX" &&
         entry.name != "CMAKE_INSTALL_PREFIX";
}

/// A file or package that CMake has found, as find_program(), find_library() and find_package() note it.
bool is_found(const CacheEntry& entry) {
  return (entry.type == "FILEPATH" || ends_with(entry.name, "_DIR")) && is_there(entry.value);
}

/// Whether nothing but this workspace's own results lies there. A system's or a robot's prefix (/usr, that of ROS)
/// holds what the build has found, too, and finds it there again.
bool is_moved(const std::string& tree, const CmakeCache& cache) {
  const auto finds_there = [&](const CacheEntry& entry) {
    return is_found(entry) && is_below(entry.value, tree);
  };
  const std::vector<CacheEntry>& entries = cache.entries();
  return !tree.empty() && std::none_of(entries.begin(), entries.end(), finds_there);
}

std::string on_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

/// CMake's first error, without the trace after it.
std::string first_message(const std::string& errors) {
  const std::size_t begin = errors.find("CMake Error");
  if (begin == std::string::npos) return errors.substr(0, errors.find('\n'));
  const std::size_t end = std::min(errors.find("\n\n\n", begin), errors.find("\nCall Stack", begin));
  return on_one_line(errors.substr(begin, end == std::string::npos ? end : end - begin));
}

/// ROS 1 is what these packages are for; some of Debian's CMake files look for ROS 2 without this.
std::map<std::string, std::string> environment() {
  std::map<std::string, std::string> variables{{"LC_ALL", "C.UTF-8"}};
  if (!std::getenv("ROS_VERSION")) variables["ROS_VERSION"] = "1";
  return variables;
}

}  // namespace

std::unique_ptr<UserBuild> UserBuild::find(const std::string& build_dir) {
  auto user = std::make_unique<UserBuild>();
  user->cache = CmakeCache::nearest(build_dir);
  user->build_dir = user->cache.folder();
  user->source = user->cache.value("CMAKE_HOME_DIRECTORY");
  if (user->source.empty() || !is_there(user->source)) return nullptr;
  return user;
}

bool UserBuild::is_workspace() const {
  return !is_there(source + "/package.xml");
}

std::string UserBuild::root() const {
  return is_workspace() ? source : fs::path(source).parent_path().string();
}

Configuration::Configuration(const UserBuild& user, const std::vector<std::string>& packages,
                             std::vector<std::string> prefixes)
    : user_(user), packages_(packages), prefixes_(std::move(prefixes)) {}

/// CMake runs what each package of a workspace says, which may write into the folder of that package.
std::vector<std::string> Configuration::configured_packages() const {
  std::set<std::string> all(packages_.begin(), packages_.end());
  if (user_.is_workspace())
    if (const Expected<std::vector<std::string>> found = find_packages_at(user_.source))
      all.insert(found->begin(), found->end());
  return {all.begin(), all.end()};
}

Expected<void> Configuration::prepare() {
  if (sources_) return {};
  Expected<ScratchFolder> folder = ScratchFolder::make();
  if (!folder) return folder.error();
  folder_ = std::make_unique<ScratchFolder>(std::move(*folder));
  const std::vector<std::string> packages = configured_packages();
  std::vector<std::string> omitted = build_paths(user_.build_dir, packages);
  for (const char* name : {"CATKIN_DEVEL_PREFIX", "CMAKE_INSTALL_PREFIX"})
    if (const std::string tree = user_.cache.value(name); is_below(tree, user_.source))
      omitted.push_back(tree);
  sources_ = std::make_unique<ScratchWorkspace>(user_.root(), packages, *folder_ / "src", omitted);
  return sources_->make();
}

/// The user's build, devel and install folders, and what stands for them. Packages that are configured one by
/// one find each other in the user's devel space, so only what such a package writes is moved. An in-source
/// build folder is no tree of its own: its paths lead to sources.
PathMap Configuration::user_trees() const {
  PathMap map;
  if (!builds_in_source(user_.build_dir, user_.source)) map.add(user_.build_dir, build_dir());
  if (!user_.is_workspace()) return map;
  if (const std::string devel = user_.cache.value("CATKIN_DEVEL_PREFIX"); !devel.empty())
    map.add(devel, *folder_ / "devel");
  if (const std::string install = user_.cache.value("CMAKE_INSTALL_PREFIX"); is_moved(install, user_.cache))
    map.add(install, *folder_ / "install");
  return map;
}

CacheEntry Configuration::mapped(CacheEntry entry) const {
  entry.value = user_trees().in_word(entry.value);
  if (!ends_with(entry.name, "_DIR")) entry.value = sources_->to_scratch().in_word(entry.value);
  const bool is_output = ends_with(entry.name, "OUTPUT_DIRECTORY") || ends_with(entry.name, "OUTPUT_PATH");
  if (is_output && !is_below(entry.value, folder_->path())) entry.value = *folder_ / "output";
  return entry;
}

/// The user's prefix path, then the prefixes of this run.
std::string Configuration::prefix_path() const {
  std::string path = user_.cache.value("CMAKE_PREFIX_PATH");
  if (path.empty())
    if (const char* list = std::getenv("CMAKE_PREFIX_PATH")) {
      path = list;
      for (char& c : path)
        if (c == ':') c = ';';
    }
  for (const std::string& prefix : prefixes_) path += (path.empty() ? "" : ";") + prefix;
  return path;
}

std::string Configuration::initial_cache() const {
  std::string text;
  for (const CacheEntry& entry : user_.cache.entries())
    if (is_carried_over(entry)) text += cache_command(mapped(entry));
  text += cache_command({"CMAKE_PREFIX_PATH", "STRING", prefix_path()});
  text += cache_command({"CATKIN_DEVEL_PREFIX", "PATH", *folder_ / "devel"});
  text += cache_command({"CMAKE_INSTALL_PREFIX", "PATH", *folder_ / "install"});
  text += cache_command({"CMAKE_EXPORT_COMPILE_COMMANDS", "BOOL", "ON"});
  return text;
}

std::string Configuration::source_dir() const {
  return user_.is_workspace() ? sources_->folder() : sources_->to_scratch().in_word(user_.source);
}

Expected<void> Configuration::configure(const FileContents& contents) {
  if (Expected<void> done = prepare(); !done) return done;
  if (Expected<void> done = sources_->write(contents); !done) return done;
  std::error_code ignored;
  for (const char* tree : {"build", "devel", "install"}) fs::remove_all(*folder_ / tree, ignored);
  fs::create_directories(build_dir() + "/.cmake/api/v1/query", ignored);
  for (const char* query : {"codemodel-v2", "cmakeFiles-v1"})
    std::ofstream(build_dir() + "/.cmake/api/v1/query/" + query).flush();
  std::ofstream(*folder_ / "initial.cmake", std::ios::binary) << initial_cache();
  const std::string cmake = user_.cache.value("CMAKE_COMMAND");
  const ProcessResult result = run_process(
      Command{{cmake.empty() ? "cmake" : cmake, "-S", source_dir(), "-B", build_dir(), "-G",
               user_.cache.value("CMAKE_GENERATOR"), "-C", *folder_ / "initial.cmake", "-Wno-dev"},
              build_dir(),
              environment()});
  if (result.status == 0) return {};
  return Error{sources_->to_user().in_word(first_message(result.errors)), "", ""};
}

Expected<void> Configuration::build(unsigned jobs) const {
  const std::string cmake = user_.cache.value("CMAKE_COMMAND");
  std::vector<std::string> words = {cmake.empty() ? "cmake" : cmake, "--build", build_dir(), "--parallel"};
  if (jobs > 0) words.push_back(std::to_string(jobs));
  const ProcessResult result = run_process(Command{words, build_dir(), environment()});
  if (result.status == 0) return {};
  const std::string text = result.output + "\n" + result.errors;
  std::size_t at = text.find("error:");
  if (at == std::string::npos) at = std::min(text.find("FAILED"), text.size() - 1);
  const std::size_t before = text.rfind('\n', at);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::string line = text.substr(begin, text.find('\n', begin) - begin);
  return Error{"the build of the scratch copy fails: " + sources_->to_user().in_word(line), "", ""};
}

}  // namespace tzc::rewriter
