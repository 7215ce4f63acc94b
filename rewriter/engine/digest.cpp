// SPDX-License-Identifier: BSD-3-Clause
#include "engine/digest.h"

#include <llvm/ADT/ArrayRef.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/BLAKE3.h>

namespace tzc::rewriter {

std::string blake3_digest(std::string_view text) {
  llvm::BLAKE3 hasher;
  hasher.update(llvm::StringRef(text.data(), text.size()));
  const auto result = hasher.final();
  return llvm::toHex(llvm::ArrayRef<std::uint8_t>(result.data(), result.size()), true);
}

}  // namespace tzc::rewriter
