// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <llvm/Support/VirtualFileSystem.h>

#include <map>
#include <set>
#include <string>

#include "model/edit.h"

namespace tzc::rewriter {

/// The disk with other text in some files, under every name that leads to them: a build may name a file through
/// symbolic links, the edits name it by its canonical path. Identities stay those of the disk. For one thread.
class EditedFiles : public llvm::vfs::ProxyFileSystem {
 public:
  /// `contents` must outlive the file system.
  EditedFiles(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> disk, const FileContents& contents);

  llvm::ErrorOr<llvm::vfs::Status> status(const llvm::Twine& path) override;
  llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> openFileForRead(const llvm::Twine& path) override;

 private:
  const std::string* content_of(const llvm::Twine& path);

  const FileContents& contents_;
  std::set<std::string> names_;  ///< last parts of the paths: most files are told apart by these
  std::map<std::string, const std::string*> known_;
};

}  // namespace tzc::rewriter
