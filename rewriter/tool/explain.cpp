// SPDX-License-Identifier: BSD-3-Clause
#include "tool/explain.h"

#include <fmt/format.h>

#include <cctype>

#include "report/code_pages.h"

namespace tzc::rewriter {
namespace {

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

Answer explain(const std::string& code_or_slug) {
  const CodeInfo* info = find_code(code_or_slug);
  if (!info) info = find_code(upper(code_or_slug));
  if (!info)
    return {"tzc-rewrite: there is no code " + code_or_slug + "; these are all:\n" + list_of_codes(), 2};
  return {std::string(info->page), 0};
}

std::string list_of_codes() {
  std::string text;
  for (const CodeInfo& info : all_codes())
    text += fmt::format("{}  {:<26} {}\n", info.code, info.slug, info.title);
  return text;
}

}  // namespace tzc::rewriter
