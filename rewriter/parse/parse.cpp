// SPDX-License-Identifier: BSD-3-Clause
#include "parse/parse.h"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendActions.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Tooling/Tooling.h>
#include <llvm/Support/VirtualFileSystem.h>

#include <cstring>
#include <memory>
#include <utility>

#include "edits/files.h"
#include "parse/crash_net.h"
#include "parse/edited_files.h"
#include "parse/errors.h"
#include "parse/gcc_headers.h"
#include "parse/note_preprocessing.h"
#include "parse/recorded_files.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace tzc::rewriter {
namespace {

using Then = std::function<void(clang::ASTContext&)>;

class Consumer : public clang::ASTConsumer {
 public:
  Consumer(const ParseOptions& options, const Then& then, const ParseResult& result)
      : options_(options), then_(then), result_(result) {}

  void HandleTranslationUnit(clang::ASTContext& ast) override {
    if (result_.errors.empty()) then_(ast);
  }

  bool shouldSkipFunctionBody(clang::Decl* decl) override {
    if (!options_.skip_system_bodies || decl->isTemplated()) return false;
    const clang::SourceManager& manager = decl->getASTContext().getSourceManager();
    return manager.isInSystemHeader(manager.getExpansionLoc(decl->getLocation()));
  }

 private:
  const ParseOptions& options_;
  const Then& then_;
  const ParseResult& result_;
};

class Action : public clang::ASTFrontendAction {
 public:
  Action(const ParseOptions& options, const Then& then, ParseResult& result)
      : options_(options), then_(then), result_(result) {}

  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler,
                                                        llvm::StringRef) override {
    note_preprocessing(compiler.getPreprocessor(), result_.preprocessor);
    compiler.getFrontendOpts().SkipFunctionBodies = options_.skip_system_bodies;
    return std::make_unique<Consumer>(options_, then_, result_);
  }

 private:
  const ParseOptions& options_;
  const Then& then_;
  ParseResult& result_;
};

/// What Clang counts as errors and its group can turn off, GCC accepts in old ROS code and its libraries: "a"MACRO"b", a number that is
/// narrowed in braces, register, throw(...). The package's own compiler judges what the
/// port writes.
constexpr const char* leniency[] = {"-w", "-Wno-everything", "-fno-caret-diagnostics"};

std::vector<std::string> command_line(const CompileUnit& unit, const ParseOptions& options) {
  std::vector<std::string> line = unit.arguments;
  line[0] = "clang++";
  line.insert(line.end(), std::begin(leniency), std::end(leniency));
  line.push_back("-resource-dir");
  line.push_back(TZC_CLANG_RESOURCE_DIR);
  line.push_back("-ferror-limit=0");  // so that one round of verification finds as many as possible
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

void run_clang(const CompileUnit& unit, const ParseOptions& options, const Then& then, ParseResult& result) {
  clang::FileSystemOptions file_options;
  file_options.WorkingDir = unit.directory;
  auto manager = llvm::makeIntrusiveRefCnt<clang::FileManager>(file_options, files_of(unit, options));
  bool is_parsed = false;
  const Then noted = [&](clang::ASTContext& ast) {
    is_parsed = true;
    then(ast);
  };
  clang::tooling::ToolInvocation invocation(command_line(unit, options),
                                            std::make_unique<Action>(options, noted, result), manager.get());
  Errors errors(result.errors);
  invocation.setDiagnosticConsumer(&errors);
  const bool succeeded = invocation.run() || errors.has_excused();
  if (!(succeeded && is_parsed) && result.errors.empty())
    result.errors.push_back({{unit.file, 0, 0}, "the compile command is not understood", {}});
}

/// The trees of the units before would stay, free, in the heap of each thread that has parsed one.
void give_free_memory_back() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace

ParseResult parse(const CompileUnit& unit, const ParseOptions& options, const Then& then) {
  auto result = std::make_unique<ParseResult>();
  const int signal = signal_that_ends([&] { run_clang(unit, options, then, *result); });
  give_free_memory_back();
  if (signal == 0) return std::move(*result);
  static_cast<void>(result.release());  // half made: nothing may touch it again
  ParseResult crashed;
  crashed.crashed = true;
  crashed.errors.push_back(
      {{unit.file, 0, 0}, std::string("tzc-rewrite crashed on it (") + ::strsignal(signal) + ")", {}});
  return crashed;
}

}  // namespace tzc::rewriter
