// SPDX-License-Identifier: BSD-3-Clause
#include "remarks/suppressions.h"

#include <map>
#include <regex>
#include <sstream>

#include "edits/files.h"
#include "model/codes.h"
#include "remarks/statement_lines.h"
#include "report/code_pages.h"

namespace tzc::rewriter {
namespace {

struct Suppression {
  Location where;
  unsigned covers = 0;  ///< the line to which it applies
  unsigned first = 0;   ///< where its statement begins: a port may have broken that into lines
  unsigned last = 0;    ///< where its statement ends
  std::set<std::string> codes;
  std::string reason;
  bool used = false;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::set<std::string> split_codes(const std::string& list) {
  std::set<std::string> codes;
  std::istringstream stream(list);
  for (std::string code; std::getline(stream, code, ',');) codes.insert(trimmed(code));
  if (codes.empty()) codes.insert("");
  return codes;
}

bool is_comment_line(const std::string& line) {
  return trimmed(line).rfind("//", 0) == 0;
}

/// A comment after code applies to its own line, one on a line of its own to the next line of code.
unsigned covered_line(const std::vector<std::string>& lines, std::size_t at) {
  while (at < lines.size() && is_comment_line(lines[at])) ++at;
  return static_cast<unsigned>(at) + 1;
}

/// `match`: its codes and its reason. A comment behind code stands at the statement's end, one above it at the beginning.
Suppression covering(unsigned line, bool is_above, const StatementLines& statements,
                     const std::smatch& match) {
  Suppression suppression;
  suppression.covers = line;
  suppression.first = is_above ? line : statements.first(line);
  suppression.last = is_above ? statements.last(line) : line;
  suppression.codes = split_codes(match[1]);
  suppression.reason = trimmed(match[2]);
  return suppression;
}

std::vector<Suppression> find_all(const std::string& file) {
  static const std::regex comment(R"(//.*\btzc-ignore\[([^\]]*)\](?:\s*:(.*))?)");
  static const std::regex without_codes(R"(//\s*tzc-ignore\b)");
  std::vector<Suppression> found;
  const Expected<std::string> content = read_file(file);
  if (!content || content->find("tzc-ignore") == std::string::npos) return found;
  std::vector<std::string> lines;
  std::istringstream stream(*content);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const StatementLines statements(*content);
  std::smatch match;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Suppression suppression;
    if (std::regex_search(lines[i], match, comment))
      suppression = covering(covered_line(lines, i), is_comment_line(lines[i]), statements, match);
    else if (!std::regex_search(lines[i], match, without_codes))
      continue;
    suppression.where = {file, static_cast<unsigned>(i) + 1, static_cast<unsigned>(match.position(0)) + 1};
    found.push_back(std::move(suppression));
  }
  return found;
}

class Suppressor {
 public:
  Suppressor(Report& report, std::set<std::string> files) : report_(report) {
    for (const Site& site : report.sites) files.insert(site.where.file);
    for (const std::string& file : files)
      for (Suppression& suppression : find_all(file)) check(std::move(suppression));
  }

  void run() {
    for (Suppression& suppression : all_) {
      mark_sites(suppression, suppression.covers, suppression.covers);
      if (!suppression.used) mark_sites(suppression, suppression.first, suppression.last);
    }
    for (const Suppression& suppression : all_)
      if (!suppression.used) note(codes::TZC3006, suppression, "the comment suppresses nothing; remove it");
  }

 private:
  /// Those that begin in one of these lines.
  void mark_sites(Suppression& suppression, unsigned first, unsigned last) {
    for (Site& site : report_.sites) {
      if (site.code.empty() || site.where.file != suppression.where.file || site.where.line < first ||
          site.where.line > last || suppression.codes.count(site.code) == 0)
        continue;
      site.suppressed = suppression.used = true;
      site.suppression_reason = suppression.reason;
    }
  }

  void check(Suppression suppression) {
    if (suppression.codes.empty() || suppression.reason.empty())
      return note(codes::TZC3005, suppression,
                  "a suppression needs codes and a reason: // tzc-ignore[TZCnnnn]: reason");
    for (const std::string& code : suppression.codes)
      if (!find_code(code)) return note(codes::TZC3005, suppression, "there is no code '" + code + "'");
    all_.push_back(std::move(suppression));
  }

  void note(const char* code, const Suppression& suppression, const std::string& text) {
    report_.notes.push_back({code, suppression.where, text});
  }

  Report& report_;
  std::vector<Suppression> all_;
};

}  // namespace

void apply_suppressions(Report& report, const std::set<std::string>& more_files) {
  Suppressor(report, more_files).run();
}

}  // namespace tzc::rewriter
