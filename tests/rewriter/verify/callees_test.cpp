// SPDX-License-Identifier: BSD-3-Clause
// What a unit's calls are compared by must not tell where code stands: each port moves lines.
#include "verify/callees.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "parse/parse.h"
#include "support/temp_dir.h"
#include "verify/changed_calls.h"

namespace tzc::rewriter {
namespace {

/// One source, and the lines of the original that its own stand for; 0: it is new.
struct Text {
  std::vector<std::string> lines;
  std::vector<unsigned> origins;
};

Text text_of(const std::string& code) {
  Text text;
  for (std::size_t begin = 0, end = 0; begin < code.size(); begin = end + 1) {
    end = code.find('\n', begin);
    text.lines.push_back(code.substr(begin, end - begin));
    text.origins.push_back(static_cast<unsigned>(text.lines.size()));
  }
  return text;
}

void insert(Text& text, std::size_t at, const std::string& line) {
  text.lines.insert(text.lines.begin() + static_cast<long>(at), line);
  text.origins.insert(text.origins.begin() + static_cast<long>(at), 0);
}

class CalleesTest : public ::testing::Test {
 protected:
  std::vector<PackageCall> calls_of(const Text& text) const {
    std::string code;
    for (const std::string& line : text.lines) code += line + "\n";
    const std::string file = package_.write("node.cpp", code);
    std::vector<PackageCall> calls;
    const ParseResult parsed =
        parse({file, package_.path(), {"c++", "-std=c++17", "-c", file}}, ParseOptions(),
              [&](clang::ASTContext& ast) { calls = package_calls(ast, package_.path()); });
    if (!parsed.errors.empty())
      throw std::runtime_error("does not parse: " + parsed.errors[0].text + "\n" + code);
    return calls;
  }

  std::optional<PackageCall> change(const Text& before, const Text& now) const {
    const std::vector<PackageCall> calls = calls_of(before);
    OriginalUnit original{calls, {}, {}, {}};
    original.has = [](const std::string&) { return true; };
    original.is_line = [&](const std::string& file, unsigned edited, unsigned line) {
      return file.empty() ? edited == line : now.origins[edited - 1] == line;
    };
    original.is_replaced = [](const PackageCall&) { return false; };
    return changed_call(original, calls_of(now));
  }

 private:
  ::tzc::test::TempDir package_;
};

const char* const closures_in_two_functions = R"(
int count = 0;
template <class F>
struct Guard {
  explicit Guard(F given) : f(given) {}
  ~Guard() { f(); }
  F f;
};
template <class F>
Guard<F> at_end(F f) { return Guard<F>(f); }
struct Node {
  void left() { auto done = at_end([this] { ++count_; }); }
  void right() { auto done = at_end([] { ++count; }); }
  int count_ = 0;
};
)";

const char* const closures_in_one_function = R"(
void use(int) {}
void drop(int) {}
template <class F>
void each(F f) { for (int i = 0; i < 3; ++i) f(i); }
template <class F>
void twice(F f) {
  each([&](int i) { f(i); });
  each([&](int i) { f(-i); });
}
int main() {
  each([](int i) { use(i); });
  each([](int i) {
    drop(i);
    each([i](int j) { use(i * j); });
    each([i](int j) { drop(i + j); });
  });
  twice([](int i) { use(i); });
  twice([](int i) { drop(i); });
}
)";

const char* const generic_closures = R"(
struct Small {};
struct Large {};
void use(Small) {}
void use(Large) {}
template <class F>
auto with_both(F f) { f(Small()); f(Large()); return [f] { f(Small()); }; }
template <class... F>
void all(F... f) { (f(), ...); }
int main() {
  auto one = with_both([](auto given) { use(given); });
  auto other = with_both([](auto given) { use(given); use(given); });
  all(one, other, [] { use(Small()); });
  all(other, one);
}
)";

const char* const types_without_a_name = R"(
struct { int a; } const first = {1}, * second = &first;
enum { red, green };
namespace { enum { blue }; }
struct Outer {
  enum { inner };
  struct { int b; } part;
};
#define BOTH(f, g) f([](int a) { return a; }); g([](int a) { return a + 1; })
template <class T>
int size_of(T given) { return sizeof(given); }
template <class T, T value>
int value_of() { return size_of(value); }
template <class T>
struct Holder {
  operator T() const { return held; }
  T held;
};
template <class T>
void destroy(T* given) { given->~T(); }
template <class F>
int apply(F f) { return f(1) + size_of(&f) + size_of(Holder<F>{f}); }
int left() {
  struct Local { int c; int get() const { return size_of(c); } } local = {1};
  enum { here };
  auto f = [](int a) { return a; };
  destroy(&f);
  static_cast<void>(static_cast<decltype(f)>(Holder<decltype(f)>{f}));
  return size_of(local) + size_of(here) + size_of(&local) + size_of(&Local::c) + local.get();
}
int right() {
  struct Local { long d; } local = {1};
  enum { here };
  auto f = [](int a) { return a; };
  destroy(&f);
  BOTH(apply, apply);
  return size_of(local) + size_of(here) + size_of(&local) + size_of(Holder<Local*>{&local});
}
int main() {
  size_of(first), size_of(second), size_of(red), size_of(blue), size_of(Outer::inner), size_of(Outer().part);
  value_of<decltype(red), green>(), value_of<decltype(blue), blue>();
  apply([](int a) { return apply([a](int b) { return a + b; }); });
}
)";

const char* const names_pasted_together = R"(
#define PASTED(first, second) first##second
#define REGISTER(Class, id)                        \
  struct Proxy##id {                               \
    Proxy##id() { count = count + sizeof(Class); } \
  };                                               \
  static Proxy##id g_proxy_##id;                   \
  bool create##Class() { return new Class() != nullptr; }
int count = 0;
struct Node { Node() {} };
struct Other { Other() {} };
REGISTER(Node, 0)
REGISTER(Other, 1)
int main() { return createNode() && createOther(); }
)";

const std::vector<const char*> sources = {closures_in_two_functions, closures_in_one_function,
                                          generic_closures, types_without_a_name};

TEST_F(CalleesTest, a_unit_whose_lines_have_moved_has_no_changed_call) {
  std::mt19937 random(1);
  for (const char* source : sources) {
    const Text before = text_of(source);
    for (int round = 0; round < 12; ++round) {
      Text now = before;
      for (unsigned i = random() % 9 + 1; i > 0; --i)
        insert(now, random() % (now.lines.size() + 1), std::string(random() % 3, ' ') + "// a comment");
      const std::optional<PackageCall> found = change(before, now);
      EXPECT_FALSE(found) << found->callee << " called in line " << found->line << " of" << source;
    }
  }
}

TEST_F(CalleesTest, a_unit_whose_columns_have_moved_has_no_changed_call) {
  for (const char* source : sources) {
    Text now = text_of(source);
    for (std::string& line : now.lines)
      if (line.rfind('#', 0) != 0) line = "/* a comment */ " + line;
    EXPECT_FALSE(change(text_of(source), now)) << source;
  }
}

/// As a header of TZC may, which a port includes: it pastes names before those of the package.
TEST_F(CalleesTest, names_that_are_pasted_before_are_no_change) {
  const Text before = text_of(names_pasted_together);
  Text now = before;
  for (int i = 0; i < 40; ++i) {
    insert(now, 8, "int PASTED(some_name_that_is_not_short_, " + std::to_string(i) + ");");
    const std::optional<PackageCall> found = change(before, now);
    ASSERT_FALSE(found) << found->callee << " called in line " << found->line << ", behind " << i + 1;
  }
}

/// Line `at` (from 0) of the second source, changed.
Text with_line(std::size_t at, const std::string& line) {
  Text text = text_of(closures_in_one_function);
  text.lines[at] = line;
  return text;
}

TEST_F(CalleesTest, a_closure_that_calls_another_function_is_a_change) {
  const Text before = text_of(closures_in_one_function);
  ASSERT_EQ(before.lines[11], "  each([](int i) { use(i); });");
  EXPECT_TRUE(change(before, with_line(11, "  each([](int i) { drop(i); });")));
}

TEST_F(CalleesTest, another_closure_is_a_change) {
  const std::string code =
      "template <class F>\nvoid each(F f) { f(1); }\n"
      "void run() {\nauto one = [](int) {};\nauto other = [](int) {};\n"
      "each(one);\n}\n";
  Text now = text_of(code);
  now.lines[5] = "each(other);";
  const std::optional<PackageCall> found = change(text_of(code), now);
  ASSERT_TRUE(found);
  EXPECT_EQ(picked_by(*found), "lambda in 'run'");
}

TEST_F(CalleesTest, a_closure_more_is_a_change) {
  Text now = with_line(11, "  each(another);");
  insert(now, 11, "  auto another = [](int i) { use(i); };");
  EXPECT_TRUE(change(text_of(closures_in_one_function), now));
}

TEST_F(CalleesTest, another_function_in_an_instance_for_a_closure_is_a_change) {
  const std::string code =
      "struct A { void put(int) {}\nvoid put(long) {} };\n"
      "template <class F>\nvoid each(F f) { A().put(f()); }\n"
      "void run() {\nauto f = [] { return 1; };\neach(f);\neach([] { return 2L; });\n}\n";
  Text now = text_of(code);
  EXPECT_FALSE(change(text_of(code), now));
  now.lines[5] = "auto f = [] { return 1L; };";
  const std::optional<PackageCall> found = change(text_of(code), now);
  ASSERT_TRUE(found);
  EXPECT_EQ(picked_by(*found), "'A::put'");
}

TEST_F(CalleesTest, a_generic_closure_is_compared_by_what_it_is_called_for) {
  const std::string code =
      "void use(int) {}\nvoid use(long) {}\n"
      "int main() {\nauto f = [](auto a) { use(a); };\n"
      "f(1);\n}\n";
  Text now = text_of(code);
  now.lines[4] = "f(1L);";
  EXPECT_TRUE(change(text_of(code), now));
}

}  // namespace
}  // namespace tzc::rewriter
