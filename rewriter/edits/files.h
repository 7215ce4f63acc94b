// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"
#include "model/folder_set.h"

namespace tzc::rewriter {

/// Whether a file or folder is to be seen there. What may not be looked at counts as absent.
bool is_there(const std::string& path);

Expected<std::string> read_file(const std::string& path);

/// Writes through to the disk (fsync). The folder must exist. `mode`: of a file that is new.
Expected<void> write_file(const std::string& path, std::string_view content, unsigned mode = 0666);

/// Makes the entries of a folder durable. Best effort: not every file system can.
void sync_folder(const std::string& path);

/// Whether the file is called as main files of C++ are.
bool is_cpp_source(const std::string& path);

/// Whether nvcc compiles it: C++ that is not analysed.
bool is_cuda_source(const std::string& path);

/// Whether the file is called as headers of C++ are, those that hold the bodies of templates among them.
bool is_cpp_header(const std::string& path);

/// FNV-1a over the content. Detects change, not malice.
std::uint64_t content_hash(std::string_view content);

/// Whether a file is text of moderate size: sources, headers and build files may have any name.
bool is_text_file(const std::string& path);

/// Path -> hash of every file below a package that the analysis may read.
using Snapshot = std::map<std::string, std::uint64_t>;
Snapshot snapshot(const std::string& package_dir);

/// Without the files that the analysis did not read, unless they are called as sources and build files are: a log may change.
Snapshot of_read_files(Snapshot all, const std::set<std::string>& read);

/// An error that names the first file that changed or vanished since, or the first source or build file that appeared.
Expected<void> check_unchanged(const std::string& package_dir, const Snapshot& since);

/// The deepest folder that is or holds each of them; at least one.
std::string common_folder(const std::vector<std::string>& folders);

/// `path` without symbolic links; as it is, made normal, where it does not exist.
std::string canonical_path(const std::string& path);

}  // namespace tzc::rewriter
