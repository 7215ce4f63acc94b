// SPDX-License-Identifier: BSD-3-Clause
#include "edits/dual.h"

#include <regex>
#include <sstream>
#include <string_view>
#include <vector>

#include "edits/diff.h"
#include "edits/source_text.h"

namespace tzc::rewriter {
namespace {

using Lines = std::vector<DiffLine>;

bool ends_with_backslash(std::string_view line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  return !line.empty() && line.back() == '\\';
}

/// Whether what follows the text belongs to a comment, or to a string of several lines.
bool is_open_after(const std::string& text) {
  return without_comments(text + "x").back() != 'x';
}

class Writer {
 public:
  explicit Writer(const Lines& lines) : lines_(lines) {}

  /// The number of the line that cannot be wrapped; 0: all is well.
  unsigned run() {
    for (std::size_t at = 0; at < lines_.size();) {
      if (lines_[at].change == LineChange::same) {
        pass(lines_[at++]);
        continue;
      }
      const unsigned number = lines_[at].old_number + lines_[at].new_number;
      if (goes_on_after("")) return number;
      const std::string removed = lines_of(at, LineChange::removed), added = lines_of(at, LineChange::added);
      if (goes_on_after(removed) || goes_on_after(added)) return number;
      wrap(removed, added);
    }
    return 0;
  }

  std::string text;

 private:
  void pass(const DiffLine& line) {
    text += line.text;
    passed_ += line.text;
  }

  std::string lines_of(std::size_t& at, LineChange change) const {
    std::string all;
    for (; at < lines_.size() && lines_[at].change == change; ++at) all += lines_[at].text;
    if (!all.empty() && all.back() != '\n') all += "\n";
    return all;
  }

  /// Whether what follows the lines, which follow those that do not change, is no line of its own.
  bool goes_on_after(const std::string& lines) const {
    return ends_with_backslash(lines.empty() ? passed_ : lines) || is_open_after(passed_ + lines);
  }

  void wrap(const std::string& removed, const std::string& added) {
    const std::string& sample = added.empty() ? removed : added;
    const std::string end = sample.size() > 1 && sample[sample.size() - 2] == '\r' ? "\r\n" : "\n";
    text += (added.empty() ? "#ifndef " : "#ifdef ") + std::string(dual_macro) + end + added;
    if (!removed.empty()) text += (added.empty() ? "" : "#else" + end) + removed;
    text += "#endif" + end;
  }

  const Lines& lines_;
  std::string passed_;  ///< the lines that do not change
};

}  // namespace

Expected<std::string> dual_text(const std::string& path, const std::string& before,
                                const std::string& after) {
  const Lines lines = diff_lines(before, after);
  Writer writer(lines);
  if (const unsigned line = writer.run())
    return Error{"the change lies in a directive or comment that spans lines, --dual cannot wrap it",
                 path + ":" + std::to_string(line),
                 "port without --dual, or leave the file out with --except"};
  return writer.text;
}

bool in_dual_branch(const std::string& content, unsigned line) {
  static const std::regex directive("^\\s*#\\s*(if|ifdef|ifndef|endif)\\b\\s*(\\w*)");
  std::vector<std::string> open;
  std::istringstream stream(content);
  std::string text;
  for (unsigned number = 1; number <= line && std::getline(stream, text); ++number) {
    std::smatch match;
    if (!std::regex_search(text, match, directive)) continue;
    if (match[1] != "endif")
      open.push_back(match[2]);
    else if (!open.empty() && number < line)
      open.pop_back();
  }
  return !open.empty() && open.back() == dual_macro;
}

}  // namespace tzc::rewriter
