// SPDX-License-Identifier: BSD-3-Clause
// Which calls of allocate() do nothing: those for stock messages with arrays, in each instance of a template.
#include "verify/idle_allocations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "parse/parse.h"
#include "support/temp_dir.h"

namespace tzc::rewriter {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const char* const messages =
    R"(namespace std { template <class T> class allocator {}; template <class T> class vector {}; }
namespace std { class string {}; }
namespace boost { template <class T> class shared_ptr {}; }
namespace pkg {
template <class A> struct Image_ { int height; std::vector<unsigned char> data; };
template <class A> struct Text_ { std::string data; };
template <class A> struct Pair_ { Image_<A> left, right; };
typedef Image_<std::allocator<void>> Image;
typedef Text_<std::allocator<void>> Text;
typedef Pair_<std::allocator<void>> Pair;
Image image;
Pair pair;
}
namespace tzc {
namespace pkg { struct Image {}; }
struct Publisher {
  template <class M> bool allocate(M&) const { return true; }
  template <class M> bool allocate(const boost::shared_ptr<M>&) const { return true; }
};
template <class M> bool allocate(M&) { return true; }
}
struct Pool { template <class M> void allocate(M&) {} };
)";

/// Lines of the code behind the messages.
std::vector<unsigned> idle_lines(const std::string& code) {
  const ::tzc::test::TempDir folder;
  const std::string path = folder.write("unit.cpp", messages + code);
  std::vector<unsigned> lines;
  const unsigned before = static_cast<unsigned>(std::count(messages, messages + std::strlen(messages), '\n'));
  const ParseResult result = parse(
      {path, folder.path(), {"c++", "-std=c++17", "-c", path}}, ParseOptions(), [&](clang::ASTContext& ast) {
        for (const IdleAllocation& call : idle_allocations(ast, FolderSet(folder.path())))
          lines.push_back(call.line - before);
      });
  for (const Diagnostic& error : result.errors) ADD_FAILURE() << error.text;
  return lines;
}

TEST(IdleAllocations, a_stock_message_with_arrays) {
  EXPECT_THAT(
      idle_lines("void f(tzc::Publisher& p, pkg::Image& m) {\n p.allocate(m);\n tzc::allocate(m);\n}\n"),
      ElementsAre(2, 3));
  EXPECT_THAT(
      idle_lines("void f(tzc::Publisher& p, boost::shared_ptr<pkg::Image>& m) {\n p.allocate(m);\n}\n"),
      ElementsAre(2));
  EXPECT_THAT(idle_lines("void f(pkg::Pair& m) { tzc::allocate(m); }\n"), ElementsAre(1));
}

TEST(IdleAllocations, not_a_twin_a_message_without_arrays_or_another_function) {
  EXPECT_THAT(idle_lines("void f(tzc::pkg::Image& m) { tzc::allocate(m); }\n"), IsEmpty());
  EXPECT_THAT(idle_lines("void f(pkg::Text& m) { tzc::allocate(m); }\n"), IsEmpty());
  EXPECT_THAT(idle_lines("void f(Pool& p, pkg::Image& m) { p.allocate(m); }\n"), IsEmpty());
}

TEST(IdleAllocations, one_instance_of_several) {
  const std::string relay =
      "template <class M> void relay(const M& in) {\n M out = in;\n tzc::allocate(out);\n}\n";
  EXPECT_THAT(idle_lines(relay), IsEmpty());
  EXPECT_THAT(idle_lines(relay + "void f(tzc::pkg::Image& a, pkg::Text& b) { relay(a); relay(b); }\n"),
              IsEmpty());
  EXPECT_THAT(idle_lines(relay + "void f(tzc::pkg::Image& a, pkg::Image& b) { relay(a); relay(b); }\n"),
              ElementsAre(3));
  const std::string generic =
      "void f(pkg::Image& m) {\n auto g = [](auto& in) { tzc::allocate(in); };\n g(m);\n}\n";
  EXPECT_THAT(idle_lines(generic), ElementsAre(2));
}

}  // namespace
}  // namespace tzc::rewriter
