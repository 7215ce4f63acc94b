// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/folder_set.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

/// A call of allocate() for a stock message that has arrays: it compiles and does nothing.
struct IdleAllocation {
  std::string file;
  unsigned line = 0;
  std::string type;  ///< of the message
};

/// In the order in which the unit reads them. Where an edit wrote the call, the message was meant to be ported and is not, in this instance of a
/// template at least: its elements would be copied, and the report would say zero_copy. A stock message without arrays is none: an instance may
/// be for a message that has nothing to allocate.
std::vector<IdleAllocation> idle_allocations(clang::ASTContext& ast, const FolderSet& packages);

}  // namespace tzc::rewriter
