// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>
#include <llvm/Config/llvm-config.h>

// What the supported versions of LLVM call by different names.

namespace tzc::rewriter {

inline bool is_pure_virtual(const clang::FunctionDecl* function) {
#if LLVM_VERSION_MAJOR >= 18
  return function->isPureVirtual();
#else
  return function->isPure();
#endif
}

}  // namespace tzc::rewriter
