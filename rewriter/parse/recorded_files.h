// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <llvm/Support/VirtualFileSystem.h>

#include "model/file_accesses.h"

namespace tzc::rewriter {

/// A file system that notes what is asked of it, answered or not: a parse is a function of its command line and of
/// these answers.
class RecordedFiles : public llvm::vfs::ProxyFileSystem {
 public:
  /// `accesses` must outlive the file system.
  RecordedFiles(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> disk, FileAccesses& accesses)
      : ProxyFileSystem(std::move(disk)), accesses_(accesses) {}

  llvm::ErrorOr<llvm::vfs::Status> status(const llvm::Twine& path) override;
  llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> openFileForRead(const llvm::Twine& path) override;
  llvm::vfs::directory_iterator dir_begin(const llvm::Twine& folder, std::error_code& failed) override;

 private:
  void note(const llvm::Twine& path, Access access);
  FileAccesses& accesses_;
};

}  // namespace tzc::rewriter
