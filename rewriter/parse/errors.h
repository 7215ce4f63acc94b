// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/Basic/Diagnostic.h>

#include <string>
#include <vector>

#include "parse/diagnostic.h"

namespace clang {
class LangOptions;
}

namespace tzc::rewriter {

/// Collects what Clang refuses, with two exceptions. Options of GCC that Clang's driver does not know: the package's own compiler
/// judges what the port writes, with them. And `struct P { ... } alignas(16);`. GCC warns that it ignores the attribute, and
/// Clang goes on as if it were not there, too. Eigen 3.4 made this of `} EIGEN_ALIGN16;`, which many point types end in.
class Errors : public clang::DiagnosticConsumer {
 public:
  explicit Errors(std::vector<Diagnostic>& errors) : errors_(errors) {}

  void BeginSourceFile(const clang::LangOptions& language, const clang::Preprocessor*) override {
    language_ = &language;
  }
  void EndSourceFile() override { language_ = nullptr; }
  void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override;

  bool has_excused() const { return has_excused_; }

 private:
  bool is_about_ignored_alignas(const clang::Diagnostic& info, const std::string& text);

  std::vector<Diagnostic>& errors_;
  const clang::LangOptions* language_ = nullptr;
  clang::SourceLocation
      behind_class_;  ///< what stands where the last error misses a semicolon; invalid: it does not
  bool last_was_error_ = false;
  bool has_excused_ = false;
};

}  // namespace tzc::rewriter
