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

/// Also where a thread begins, or may be told something: thread_(...), ready_.notify_all(), semaphore.post(). By name, and rather too often:
/// what stands in code without any of these happens before, or after, all that another thread does, as one whole.
bool may_synchronize(const clang::Stmt* stmt);

/// lock_guard, unique_lock, MutexLocker: a class whose objects have a lock that no other thread can have meanwhile. Not std::shared_lock.
bool names_exclusive_lock(llvm::StringRef name);

}  // namespace tzc::rewriter
