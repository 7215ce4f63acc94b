// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a thread waits for another one. What is not behind such a place, no other thread changes meanwhile in a program
// without data races.

#include <clang/AST/Decl.h>
#include <clang/AST/Stmt.h>

namespace tzc::rewriter {

/// scoped_lock lock(m), MutexLocker, mutex_.lock(), pthread_mutex_lock(), thread_.join(), ready_.wait(), a member function or
/// operator of std::atomic or std::future; also where a volatile is read.
bool takes_lock(const clang::Stmt* stmt);

/// Whether a statement of its body does, lambdas included.
bool takes_locks(const clang::FunctionDecl* definition);

/// A lock that no other thread can have meanwhile: not std::shared_lock, nor a join.
bool takes_exclusive_lock(const clang::Stmt* stmt);

}  // namespace tzc::rewriter
