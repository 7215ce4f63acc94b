// SPDX-License-Identifier: BSD-3-Clause
#include "engine/trusted_functions.h"

#include <llvm/Support/SourceMgr.h>
#include <llvm/Support/YAMLTraits.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <vector>

namespace tzc::rewriter {
namespace {

struct Entry {
  std::string function, reason;
};

struct Settings {
  std::vector<Entry> keeps_nothing;
};

}  // namespace
}  // namespace tzc::rewriter

LLVM_YAML_IS_SEQUENCE_VECTOR(tzc::rewriter::Entry)

template <>
struct llvm::yaml::MappingTraits<tzc::rewriter::Entry> {
  static void mapping(IO& io, tzc::rewriter::Entry& entry) {
    io.mapRequired("function", entry.function);
    io.mapRequired("reason", entry.reason);
  }
  static std::string validate(IO&, tzc::rewriter::Entry& entry) {
    static const std::regex name("[A-Za-z_]\\w*(::~?[A-Za-z_]\\w*)*(::operator\\S+)?");
    if (!std::regex_match(entry.function, name))
      return "'" + entry.function +
             "' is no qualified name of a function; write it without arguments: camera::read_frame";
    if (entry.reason.find_first_not_of(" \t") == std::string::npos)
      return "'" + entry.function + "' has no reason; say why it keeps no pointer";
    return "";
  }
};

template <>
struct llvm::yaml::MappingTraits<tzc::rewriter::Settings> {
  static void mapping(IO& io, tzc::rewriter::Settings& settings) {
    io.mapRequired("keeps_nothing", settings.keeps_nothing);
  }
};

namespace tzc::rewriter {
namespace {

constexpr const char* form =
    "The file has the form\n"
    "    keeps_nothing:\n"
    "      - function: camera::read_frame\n"
    "        reason: it copies the frame and returns";

std::optional<std::filesystem::path> find_file(std::filesystem::path folder) {
  for (;; folder = folder.parent_path()) {
    std::filesystem::path file = folder / ".tzc-rewrite.yaml";
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return file;
    if (folder == folder.parent_path()) return {};
  }
}

struct FirstError {
  std::string text;
  int line = 0;
};

void note_error(const llvm::SMDiagnostic& diagnostic, void* context) {
  auto& first = *static_cast<FirstError*>(context);
  if (first.text.empty()) first = {diagnostic.getMessage().str(), diagnostic.getLineNo()};
}

Expected<TrustedFunctions> parse(const std::string& text, const std::string& file) {
  FirstError error;
  llvm::yaml::Input input(text, nullptr, note_error, &error);
  Settings settings;
  input >> settings;
  if (input.error())
    return Error{error.text.empty() ? "no settings in it" : error.text,
                 error.line > 0 ? file + ":" + std::to_string(error.line) : file, form};
  TrustedFunctions trusted;
  for (const Entry& entry : settings.keeps_nothing)
    if (!trusted.emplace(entry.function, entry.reason).second)
      return Error{"'" + entry.function + "' is there twice", file, "Remove one of the entries."};
  return trusted;
}

Expected<TrustedFunctions> trusted_in(const std::string& package_dir) {
  const std::optional<std::filesystem::path> path = find_file(package_dir);
  if (!path) return TrustedFunctions();
  std::ifstream stream(*path);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf()))
    return Error{"cannot be read", path->string(), "Make it a file that you may read, or remove it."};
  return parse(text.str(), path->string());
}

}  // namespace

Expected<TrustedFunctions> load_trusted_functions(const FolderSet& packages) {
  TrustedFunctions all;
  for (const std::string& package : packages) {
    Expected<TrustedFunctions> trusted = trusted_in(package);
    if (!trusted) return trusted.error();
    all.merge(*trusted);
  }
  return all;
}

}  // namespace tzc::rewriter
