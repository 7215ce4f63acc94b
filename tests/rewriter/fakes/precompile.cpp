// SPDX-License-Identifier: BSD-3-Clause
// usage: tzc_precompile_fakes RESOURCE_FOLDER HEADER OUTPUT
// Writes the precompiled form of HEADER, for the language that the cases are written in.
#include <clang/Frontend/FrontendActions.h>
#include <clang/Tooling/Tooling.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: " << argv[0] << " RESOURCE_FOLDER HEADER OUTPUT\n";
    return 2;
  }
  const std::vector<std::string> command{"c++",   "-std=c++17", "-resource-dir", argv[1], "-x", "c++-header",
                                         argv[2], "-o",         argv[3]};
  llvm::IntrusiveRefCntPtr<clang::FileManager> files(new clang::FileManager(clang::FileSystemOptions()));
  clang::tooling::ToolInvocation invocation(command, std::make_unique<clang::GeneratePCHAction>(),
                                            files.get());
  return invocation.run() ? 0 : 1;
}
