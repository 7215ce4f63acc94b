// SPDX-License-Identifier: BSD-3-Clause
#include "format/format.h"

#include <clang/Format/Format.h>
#include <clang/Tooling/Core/Replacement.h>
#include <llvm/Config/llvm-config.h>

#include <vector>

#include "edits/diff.h"
#include "format/continuations.h"
#include "format/line_width.h"
#include "format/styled_lines.h"

namespace tzc::rewriter {
namespace {

/// The byte ranges of the lines of `after` that `before` does not have.
std::vector<clang::tooling::Range> changed_ranges(const std::string& before, const std::string& after) {
  std::vector<clang::tooling::Range> ranges;
  std::size_t offset = 0;
  for (const DiffLine& line : diff_lines(before, after)) {
    if (line.change == LineChange::removed) continue;
    if (line.change == LineChange::added)
      ranges.emplace_back(static_cast<unsigned>(offset), static_cast<unsigned>(line.text.size()));
    offset += line.text.size();
  }
  return ranges;
}

/// The .clang-format that applies; none where there is none or Clang cannot read it, which is for its owner's own clang-format to say.
clang::format::FormatStyle style_of(const std::string& path, const std::string& text) {
#if LLVM_VERSION_MAJOR >= 19  // earlier ones write what they cannot read to stderr
  const auto in_silence = [](const llvm::SMDiagnostic&, void*) {};
  llvm::Expected<clang::format::FormatStyle> style =
      clang::format::getStyle("file", path, "none", text, nullptr, true, in_silence);
#else
  llvm::Expected<clang::format::FormatStyle> style =
      clang::format::getStyle("file", path, "none", text, nullptr, true);
#endif
  if (style) return *style;
  llvm::consumeError(style.takeError());
  return clang::format::getNoStyle();
}

}  // namespace

std::string format_changes(const std::string& path, const std::string& before, const std::string& after) {
  clang::format::FormatStyle style = style_of(path, after);
  if (style == clang::format::getNoStyle()) return wrapped(path, before, realigned(before, after));
  if (style.DisableFormat) return after;
  style.MaxEmptyLinesToKeep = 1000;  // keeps the empty lines before a changed line
  style.SortIncludes = clang::format::FormatStyle::SI_Never;
  const std::string aligned =
      realigned(before, after);  // lines behind a bracket that moved are changed ones, too
  const auto replacements = clang::format::reformat(style, aligned, changed_ranges(before, aligned), path);
  const std::string styled = with_changed_lines_styled(before, aligned, replacements, style.TabWidth);
  return styled.empty() ? aligned : styled;
}

}  // namespace tzc::rewriter
