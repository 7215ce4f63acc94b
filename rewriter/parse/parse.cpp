// SPDX-License-Identifier: BSD-3-Clause
#include "parse/parse.h"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendActions.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Tooling/Tooling.h>
#include <llvm/Support/VirtualFileSystem.h>

#include <map>
#include <memory>
#include <utility>

#include "edits/files.h"
#include "parse/edited_files.h"
#include "parse/gcc_headers.h"
#include "parse/recorded_files.h"

namespace tzc::rewriter {
namespace {

using Then = std::function<void(clang::ASTContext&)>;

class Errors : public clang::DiagnosticConsumer {
 public:
  explicit Errors(std::vector<Diagnostic>& errors) : errors_(errors) {}

  void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override {
    DiagnosticConsumer::HandleDiagnostic(level, info);
    if (level == clang::DiagnosticsEngine::Note && last_was_error_) {
      errors_.back().notes.push_back(location_of(info));
      return;
    }
    last_was_error_ = level >= clang::DiagnosticsEngine::Error;
    if (!last_was_error_) return;
    llvm::SmallString<256> text;
    info.FormatDiagnostic(text);
    errors_.push_back({location_of(info), text.str().str(), {}});
  }

 private:
  static Location location_of(const clang::Diagnostic& info) {
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

  std::vector<Diagnostic>& errors_;
  bool last_was_error_ = false;
};

/// Clang announces each directive that it looks at, and then what it skips behind it: behind the others it compiles.
class Branches : public clang::PPCallbacks {
 public:
  Branches(const clang::SourceManager& manager, ParseResult& result) : manager_(manager), result_(result) {}

  void If(clang::SourceLocation at, clang::SourceRange, ConditionValueKind) override { count(at, 1); }
  void Ifdef(clang::SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override {
    count(at, 1);
  }
  void Ifndef(clang::SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override {
    count(at, 1);
  }
  void Elif(clang::SourceLocation at, clang::SourceRange, ConditionValueKind value,
            clang::SourceLocation) override {
    if (value != CVK_False) count(at, 1);  // in the midst of what is skipped
  }
  void Else(clang::SourceLocation at, clang::SourceLocation) override { count(at, 1); }

  void SourceRangeSkipped(clang::SourceRange range, clang::SourceLocation) override {
    const clang::SourceLocation begin = manager_.getExpansionLoc(range.getBegin());
    if (manager_.isInSystemHeader(begin)) return;
    count(begin, -1);
    const std::string file = path_of(manager_.getFileID(begin));
    if (file.empty()) return;
    result_.skipped.push_back({file, manager_.getSpellingLineNumber(begin), manager_.getFileOffset(begin),
                               manager_.getFileOffset(range.getEnd())});
  }

  void EndOfMainFile() override {
    for (const auto& [where, times] : compiled_)
      if (times > 0) result_.compiled.insert({path_of(where.first), where.second});
  }

 private:
  std::string path_of(clang::FileID file) const {
    const auto entry = manager_.getFileEntryRefForID(file);
    return entry ? canonical_path(entry->getFileEntry().tryGetRealPathName().str()) : "";
  }
  void count(clang::SourceLocation at, int times) {
    if (!manager_.isInSystemHeader(at))
      compiled_[{manager_.getFileID(at), manager_.getSpellingLineNumber(at)}] += times;
  }

  const clang::SourceManager& manager_;
  ParseResult& result_;
  std::map<std::pair<clang::FileID, unsigned>, int>
      compiled_;  ///< a file has another ID each time that it is read
};

class Consumer : public clang::ASTConsumer {
 public:
  Consumer(const ParseOptions& options, const Then& then) : options_(options), then_(then) {}

  void HandleTranslationUnit(clang::ASTContext& ast) override { then_(ast); }

  bool shouldSkipFunctionBody(clang::Decl* decl) override {
    if (!options_.skip_system_bodies || decl->isTemplated()) return false;
    const clang::SourceManager& manager = decl->getASTContext().getSourceManager();
    return manager.isInSystemHeader(manager.getExpansionLoc(decl->getLocation()));
  }

 private:
  const ParseOptions& options_;
  const Then& then_;
};

class Action : public clang::ASTFrontendAction {
 public:
  Action(const ParseOptions& options, const Then& then, ParseResult& result)
      : options_(options), then_(then), result_(result) {}

  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler,
                                                        llvm::StringRef) override {
    compiler.getPreprocessor().addPPCallbacks(
        std::make_unique<Branches>(compiler.getSourceManager(), result_));
    compiler.getFrontendOpts().SkipFunctionBodies = options_.skip_system_bodies;
    return std::make_unique<Consumer>(options_, then_);
  }

 private:
  const ParseOptions& options_;
  const Then& then_;
  ParseResult& result_;
};

/// Old ROS code and its libraries do not parse without these.
constexpr const char* leniency[] = {"-w",
                                    "-fno-caret-diagnostics",
                                    "-Wno-enum-constexpr-conversion",
                                    "-Wno-missing-template-arg-list-after-template-kw",
                                    "-Wno-dynamic-exception-spec",
                                    "-Wno-register"};

std::vector<std::string> command_line(const CompileUnit& unit, const ParseOptions& options) {
  std::vector<std::string> line = unit.arguments;
  line[0] = "clang++";
  line.insert(line.end(), std::begin(leniency), std::end(leniency));
  line.push_back("-resource-dir");
  line.push_back(TZC_CLANG_RESOURCE_DIR);
  line.push_back(options.all_errors ? "-ferror-limit=0" : "-ferror-limit=20");
  for (const std::string& dir : options.include_dirs) {
    line.push_back("-idirafter");
    line.push_back(dir);
  }
  line.insert(line.end(), {"-idirafter", gcc_header_dir, "-include", gcc_prelude});
  return line;
}

llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> files_of(const CompileUnit& unit,
                                                         const ParseOptions& options) {
  llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> disk(llvm::vfs::createPhysicalFileSystem().release());
  disk->setCurrentWorkingDirectory(unit.directory);
  if (options.accesses) disk = llvm::makeIntrusiveRefCnt<RecordedFiles>(disk, *options.accesses);
  auto files = llvm::makeIntrusiveRefCnt<llvm::vfs::OverlayFileSystem>(
      llvm::makeIntrusiveRefCnt<EditedFiles>(disk, options.overlay));
  auto memory = llvm::makeIntrusiveRefCnt<llvm::vfs::InMemoryFileSystem>();
  for (const auto& [path, content] : gcc_headers())
    memory->addFile(path, 0, llvm::MemoryBuffer::getMemBuffer(content, path));
  files->pushOverlay(memory);
  files->setCurrentWorkingDirectory(unit.directory);
  return files;
}

}  // namespace

ParseResult parse(const CompileUnit& unit, const ParseOptions& options, const Then& then) {
  ParseResult result;
  clang::FileSystemOptions file_options;
  file_options.WorkingDir = unit.directory;
  auto manager = llvm::makeIntrusiveRefCnt<clang::FileManager>(file_options, files_of(unit, options));
  clang::tooling::ToolInvocation invocation(command_line(unit, options),
                                            std::make_unique<Action>(options, then, result), manager.get());
  Errors errors(result.errors);
  invocation.setDiagnosticConsumer(&errors);
  if (!invocation.run() && result.errors.empty())
    result.errors.push_back({{unit.file, 0, 0}, "the compile command is not understood", {}});
  return result;
}

}  // namespace tzc::rewriter
