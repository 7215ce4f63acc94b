// SPDX-License-Identifier: BSD-3-Clause
#include "parse/recorded_files.h"

#include <llvm/ADT/SmallString.h>

namespace tzc::rewriter {

void RecordedFiles::note(const llvm::Twine& path, Access access) {
  llvm::SmallString<256> absolute;
  path.toVector(absolute);
  if (makeAbsolute(absolute)) return accesses_.give_up();
  accesses_.note(absolute.str().str(), access);
}

llvm::ErrorOr<llvm::vfs::Status> RecordedFiles::status(const llvm::Twine& path) {
  note(path, Access::content);
  return ProxyFileSystem::status(path);
}

llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> RecordedFiles::openFileForRead(const llvm::Twine& path) {
  note(path, Access::content);
  return ProxyFileSystem::openFileForRead(path);
}

llvm::vfs::directory_iterator RecordedFiles::dir_begin(const llvm::Twine& folder, std::error_code& failed) {
  note(folder, Access::names);
  return ProxyFileSystem::dir_begin(folder, failed);
}

}  // namespace tzc::rewriter
