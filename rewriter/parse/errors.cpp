// SPDX-License-Identifier: BSD-3-Clause
#include "parse/errors.h"

#include <clang/Basic/DiagnosticDriver.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>
#include <clang/Parse/ParseDiagnostic.h>

#include <utility>

#include "edits/files.h"

namespace tzc::rewriter {
namespace {

Location location_of(const clang::Diagnostic& info) {
  if (!info.hasSourceManager() || info.getLocation().isInvalid()) return {};
  const clang::SourceManager& manager = info.getSourceManager();
  const clang::SourceLocation at = manager.getFileLoc(info.getLocation());
  const clang::PresumedLoc presumed = manager.getPresumedLoc(at, false);
  if (presumed.isInvalid()) return {};
  std::string file = presumed.getFilename();
  if (const auto entry = manager.getFileEntryRefForID(manager.getFileID(at)))
    if (const llvm::StringRef real = entry->getFileEntry().tryGetRealPathName(); !real.empty())
      file = real.str();
  return {canonical_path(file), presumed.getLine(), presumed.getColumn()};
}

/// The token at or behind a place in a file.
clang::SourceLocation next_token(const clang::Diagnostic& info, const clang::LangOptions& language) {
  clang::Token token;
  const bool failed =
      info.getLocation().isMacroID() ||
      clang::Lexer::getRawToken(info.getLocation(), token, info.getSourceManager(), language, true);
  return failed ? clang::SourceLocation() : token.getLocation();
}

/// -fext-numeric-literals and what else only GCC has, or has with more values: Clang goes on without it.
bool is_about_option(const clang::Diagnostic& info) {
  switch (info.getID()) {
    case clang::diag::err_drv_unknown_argument:
    case clang::diag::err_drv_unknown_argument_with_suggestion:
    case clang::diag::err_drv_unsupported_opt:
    case clang::diag::err_drv_unsupported_opt_with_suggestion:
    case clang::diag::err_drv_unsupported_opt_for_target:
    case clang::diag::err_drv_unsupported_option_argument:
    case clang::diag::err_drv_invalid_value:
    case clang::diag::err_drv_invalid_value_with_suggestion:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool Errors::is_about_ignored_alignas(const clang::Diagnostic& info, const std::string& text) {
  const clang::SourceLocation expected = std::exchange(behind_class_, {});
  if (language_ && info.getID() == clang::diag::err_expected_after)
    behind_class_ = next_token(info, *language_);
  return expected.isValid() && text.rfind("'alignas' attribute only applies to", 0) == 0 &&
         info.getSourceManager().getExpansionLoc(info.getLocation()) == expected;
}

void Errors::HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) {
  DiagnosticConsumer::HandleDiagnostic(level, info);
  if (level == clang::DiagnosticsEngine::Note && last_was_error_) {
    errors_.back().notes.push_back(location_of(info));
    return;
  }
  last_was_error_ = level >= clang::DiagnosticsEngine::Error;
  if (!last_was_error_) return;
  if (is_about_option(info)) {
    last_was_error_ = false;
    has_excused_ = true;
    return;
  }
  llvm::SmallString<256> text;
  info.FormatDiagnostic(text);
  if (is_about_ignored_alignas(info, text.str().str())) {
    errors_.pop_back();  // the semicolon that Clang missed in front of it
    last_was_error_ = false;
    has_excused_ = true;
    return;
  }
  errors_.push_back({location_of(info), text.str().str(), {}});
}

}  // namespace tzc::rewriter
