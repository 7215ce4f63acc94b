// SPDX-License-Identifier: BSD-3-Clause
#include "parse/edited_files.h"

#include <llvm/Support/Path.h>

#include <utility>

namespace tzc::rewriter {
namespace {

using llvm::vfs::Status;

class EditedFile : public llvm::vfs::File {
 public:
  EditedFile(Status status, const std::string& content) : status_(std::move(status)), content_(content) {}

  llvm::ErrorOr<Status> status() override { return status_; }
  llvm::ErrorOr<std::unique_ptr<llvm::MemoryBuffer>> getBuffer(const llvm::Twine& name, std::int64_t, bool,
                                                               bool) override {
    return llvm::MemoryBuffer::getMemBufferCopy(content_, name);
  }
  std::error_code close() override { return {}; }

 private:
  Status status_;
  const std::string& content_;
};

std::string last_part(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

/// GCC's precompiled headers hold the old text, and Clang cannot read them. Their headers are read instead.
bool is_gcc_pch(const llvm::Twine& path) {
  return llvm::StringRef(path.str()).ends_with(".gch");
}

}  // namespace

EditedFiles::EditedFiles(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> disk, const FileContents& contents)
    : ProxyFileSystem(std::move(disk)), contents_(contents) {
  for (const auto& item : contents) names_.insert(last_part(item.first));
}

const std::string* EditedFiles::content_of(const llvm::Twine& path) {
  const std::string text = path.str();
  const auto known = known_.find(text);
  if (known != known_.end()) return known->second;
  llvm::SmallString<256> real;
  // A link may have another name than its file.
  const bool may_be = names_.count(last_part(text)) != 0 || llvm::sys::fs::is_symlink_file(text);
  const std::string* content = nullptr;
  if (may_be && !getRealPath(path, real))
    if (const auto found = contents_.find(real.str().str()); found != contents_.end())
      content = &found->second;
  return known_.emplace(text, content).first->second;
}

llvm::ErrorOr<Status> EditedFiles::status(const llvm::Twine& path) {
  if (is_gcc_pch(path)) return std::make_error_code(std::errc::no_such_file_or_directory);
  llvm::ErrorOr<Status> status = ProxyFileSystem::status(path);
  const std::string* content = status ? content_of(path) : nullptr;
  return content ? Status::copyWithNewSize(*status, content->size()) : status;
}

llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> EditedFiles::openFileForRead(const llvm::Twine& path) {
  const std::string* content = content_of(path);
  if (!content) return ProxyFileSystem::openFileForRead(path);
  llvm::ErrorOr<Status> found = status(path);
  if (!found) return found.getError();
  return std::unique_ptr<llvm::vfs::File>(std::make_unique<EditedFile>(*found, *content));
}

}  // namespace tzc::rewriter
