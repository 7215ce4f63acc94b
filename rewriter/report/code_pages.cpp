// SPDX-License-Identifier: BSD-3-Clause
#include "report/code_pages.h"

namespace tzc::rewriter {
namespace {

struct Page {
  std::string_view code, text;
};

constexpr Page pages[] = {
#include "pages.inc"
    {"", ""}};

std::string_view page_of(std::string_view code) {
  for (const Page& page : pages)
    if (page.code == code) return page.text;
  return "";
}

}  // namespace

const std::vector<CodeInfo>& all_codes() {
  static const std::vector<CodeInfo> table = {
#define X(code, slug, title) {#code, slug, title, page_of(#code)},
#include "model/codes.def"
#undef X
  };
  return table;
}

const CodeInfo* find_code(std::string_view code_or_slug) {
  for (const CodeInfo& info : all_codes())
    if (info.code == code_or_slug || info.slug == code_or_slug) return &info;
  return nullptr;
}

}  // namespace tzc::rewriter
