// SPDX-License-Identifier: BSD-3-Clause
#include "transaction/journal.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

std::string package_of(const std::string& folder) {
  return fs::path(folder).parent_path().string();
}

Error unreadable(const std::string& path) {
  return {"is not a journal of tzc-rewrite", path,
          "restore the package's files from version control, then remove " +
              fs::path(path).parent_path().string()};
}

/// Downloaded packages are not trusted: an entry that leads out of the package makes the journal invalid.
bool is_inside(const JournalEntry& entry, const std::string& folder) {
  std::error_code failed;
  const std::string target = fs::canonical(entry.target, failed).string();
  return !failed && target == entry.target && is_below(target, package_of(folder)) &&
         fs::path(entry.staged).parent_path() == folder;
}

Expected<Journal> parse(const json& document, const std::string& folder) {
  if (document.at("version") != 1) return unreadable(journal_path(folder));
  Journal journal;
  for (const json& file : document.at("files")) {
    const JournalEntry entry{folder + "/" + file.at("staged").get<std::string>(),
                             package_of(folder) + "/" + file.at("target").get<std::string>(), file.at("old"),
                             file.at("new")};
    if (!is_inside(entry, folder)) return unreadable(journal_path(folder));
    journal.push_back(entry);
  }
  return journal;
}

}  // namespace

std::string journal_path(const std::string& folder) {
  return folder + "/journal.json";
}

std::string unfinished_journal_path(const std::string& folder) {
  return journal_path(folder) + ".part";
}

Expected<void> write_journal(const std::string& folder, const Journal& journal) {
  json files = json::array();
  for (const JournalEntry& entry : journal)
    files.push_back({{"staged", fs::path(entry.staged).filename().string()},
                     {"target", fs::path(entry.target).lexically_relative(package_of(folder)).string()},
                     {"old", entry.old_hash},
                     {"new", entry.new_hash}});
  const std::string text =
      json{{"version", 1}, {"files", files}}.dump(1, ' ', false, json::error_handler_t::replace);
  const std::string path = journal_path(folder), unfinished = unfinished_journal_path(folder);
  if (Expected<void> done = write_file(unfinished, text); !done) return done;
  if (std::rename(unfinished.c_str(), path.c_str()) != 0)
    return Error{std::string("cannot be written: ") + std::strerror(errno), path, ""};
  sync_folder(folder);
  return {};
}

Expected<Journal> read_journal(const std::string& folder) {
  const std::string path = journal_path(folder);
  const Expected<std::string> text = read_file(path);
  if (!text) return text.error();
  try {
    return parse(json::parse(*text), folder);
  } catch (const json::exception&) {
    return unreadable(path);
  }
}

}  // namespace tzc::rewriter
