# SPDX-License-Identifier: BSD-3-Clause
# LLVM's major versions that are known to work, the best first. scripts/packages.d says which of them a distribution has.
set(TZC_LLVM_VERSIONS 19 18 17 16)
list(GET TZC_LLVM_VERSIONS 0 TZC_LLVM_NEWEST)
list(GET TZC_LLVM_VERSIONS -1 TZC_LLVM_OLDEST)
