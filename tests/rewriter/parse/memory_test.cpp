// SPDX-License-Identifier: BSD-3-Clause
// What a unit's tree took goes back to the system: units are many, and the package's compiler needs memory, too.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

#include "parse/parse.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

/// Of this process, in KB.
long resident() {
  std::ifstream file("/proc/self/statm");
  long size = 0, pages = 0;
  file >> size >> pages;
  return pages * (::sysconf(_SC_PAGESIZE) / 1024);
}

std::string functions(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    text += "int f" + number + "(int a, long b) { return a + static_cast<int>(b) * " + number + "; }\n";
  }
  return text;
}

struct Kilobytes {
  long during = 0, after = 0;
};

/// That a parse of the unit takes, and leaves. What was found in the tree is kept: it lies behind the tree in the heap.
Kilobytes parse_it(const CompileUnit& unit) {
  const long before = resident();
  Kilobytes used;
  std::vector<std::string> found;
  const ParseResult result = parse(unit, ParseOptions(), [&](clang::ASTContext&) {
    used.during = resident() - before;
    for (int i = 0; i < 100; ++i) found.emplace_back(1000, 'x');
  });
  EXPECT_TRUE(result.errors.empty());
  used.after = resident() - before;
  return used;
}

TEST(Parse, gives_its_memory_back) {
  const test::TempDir folder;
  const auto parse_file = [&](const std::string& text) {
    const std::string path = folder.write("unit.cpp", text);
    return parse_it({path, folder.path(), {"c++", "-c", path}});
  };
  parse_file(functions(1));  // what Clang keeps for good
  const Kilobytes used = parse_file(functions(30000));
  EXPECT_GT(used.during, 20000);
  EXPECT_LT(used.after, used.during / 4);
}

}  // namespace
}  // namespace tzc::rewriter
