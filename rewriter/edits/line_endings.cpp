// SPDX-License-Identifier: BSD-3-Clause
#include "edits/line_endings.h"

namespace tzc::rewriter {
namespace {

void use_crlf(std::string& text) {
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
    text.replace(at, 1, "\r\n");
}

}  // namespace

void keep_line_endings(Edits& edits, const ReadFile& read) {
  std::map<std::string, bool> is_crlf;
  for (Edit& edit : edits) {
    if (edit.text.find('\n') == std::string::npos) continue;
    const auto [known, is_new] = is_crlf.emplace(edit.file, false);
    if (is_new) known->second = read(edit.file).value_or("").find("\r\n") != std::string::npos;
    if (known->second) use_crlf(edit.text);
  }
}

}  // namespace tzc::rewriter
