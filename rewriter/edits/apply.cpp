// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <tuple>

#include "edits/apply.h"

namespace tzc::rewriter {
namespace {

bool same(const Edit& a, const Edit& b) {
  return std::tie(a.offset, a.length, a.text) == std::tie(b.offset, b.length, b.text);
}

/// Insertions stand before a replacement that starts at the same place.
bool before(const Edit& a, const Edit& b) {
  return std::make_pair(a.offset, a.length != 0) < std::make_pair(b.offset, b.length != 0);
}

Error conflict(const Edit& first, const Edit& second) {
  return {"edits of the rules '" + first.rule + "' and '" + second.rule + "' overlap at byte " +
              std::to_string(second.offset),
          second.file, ""};
}

}  // namespace

Edits in_order(const Edits& edits) {
  Edits unique;
  for (const Edit& edit : edits) {
    const bool known =
        std::any_of(unique.begin(), unique.end(), [&](const Edit& e) { return same(e, edit); });
    if (!known) unique.push_back(edit);
  }
  std::stable_sort(unique.begin(), unique.end(), before);
  return unique;
}

Expected<std::string> apply_edits(std::string_view content, const Edits& edits) {
  std::string result;
  std::size_t at = 0;
  const Edit* last = nullptr;
  const Edits ordered = in_order(edits);
  for (const Edit& edit : ordered) {
    if (edit.offset > content.size() || edit.length > content.size() - edit.offset)
      return Error{"an edit of the rule '" + edit.rule + "' lies outside the file", edit.file, ""};
    if (edit.offset < at) return conflict(*last, edit);
    result.append(content.substr(at, edit.offset - at)).append(edit.text);
    at = edit.offset + edit.length;
    last = &edit;
  }
  return result.append(content.substr(at));
}

std::vector<std::pair<Edit, Edit>> overlaps(const Edits& edits) {
  std::vector<std::pair<Edit, Edit>> found;
  for (const auto& [file, of_file] : by_file(edits)) {
    std::optional<Edit> widest;  // the one that ends last of those before
    for (const Edit& edit : in_order(of_file)) {
      if (widest && edit.offset < widest->offset + widest->length) found.emplace_back(*widest, edit);
      if (!widest || edit.offset + edit.length >= widest->offset + widest->length) widest = edit;
    }
  }
  return found;
}

std::map<std::string, Edits> by_file(const Edits& edits) {
  std::map<std::string, Edits> files;
  for (const Edit& edit : edits) files[edit.file].push_back(edit);
  return files;
}

}  // namespace tzc::rewriter
