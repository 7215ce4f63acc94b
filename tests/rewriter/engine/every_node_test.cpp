// SPDX-License-Identifier: BSD-3-Clause
// Nothing that Clang's tree may hold crashes the analysis: every kind of node, beside messages that are published.
#include <clang/AST/RecursiveASTVisitor.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "edits/files.h"
#include "golden/case.h"
#include "parse/parse.h"

namespace tzc::rewriter {
namespace {

using ::testing::IsEmpty;

std::set<std::string> kinds_of_clang() {
  return {
#define ABSTRACT_STMT(KIND)
#define STMT(KIND, BASE) #KIND,
#include <clang/AST/StmtNodes.inc>
  };
}

/// What no code has that GCC compiles.
bool is_of_another_language(const std::string& kind) {
  for (const char* language : {"ObjC", "OMP", "OpenACC", "SEH", "MS", "CUDA", "SYCL"})
    if (kind.rfind(language, 0) == 0) return true;
  static const std::set<std::string> others = {
      "AsTypeExpr",
      "CXXAddrspaceCastExpr",  // OpenCL
      "CXXUuidofExpr",         // Microsoft's
      "BlockExpr",
      "ExtVectorElementExpr",
      "MatrixSubscriptExpr",
      "FixedPointLiteral",  // Clang's own
      "ArraySectionExpr",   // in OpenMP's clauses alone
      "DesignatedInitUpdateExpr",
      "NoInitExpr",  // C's
      "PackIndexingExpr",
      "EmbedExpr",  // C++26
      "RecoveryExpr",
      "TypoExpr",
      "PseudoObjectExpr",  // errors, and properties
  };
  return others.count(kind) != 0;
}

class Kinds : public clang::RecursiveASTVisitor<Kinds> {
 public:
  bool shouldVisitTemplateInstantiations() const { return true; }
  bool shouldVisitImplicitCode() const { return true; }
  bool VisitStmt(clang::Stmt* node) {
    found.insert(node->getStmtClassName());
    return true;
  }
  bool VisitInitListExpr(clang::InitListExpr* list) {  // as it is written, and as it is meant
    for (const clang::InitListExpr* form : {list->getSyntacticForm(), list->getSemanticForm()})
      if (form)
        for (const clang::Stmt* part : form->children())
          if (part) found.insert(part->getStmtClassName());
    return true;
  }
  std::set<std::string> found;
};

class EveryNode : public ::testing::Test {
 protected:
  const std::string code = read_file(TZC_EVERY_NODE).operator*();
  const test::Package package{{{"src/node.cpp", code}}};
  const CompileUnit unit{
      package.dir() + "/src/node.cpp",
      package.dir(),
      {"c++", "-std=c++20", "-fopenmp", "-I" TZC_FAKES, "-c", package.dir() + "/src/node.cpp"}};
};

TEST_F(EveryNode, is_there) {
  Kinds kinds;
  const ParseResult parsed = parse(unit, {}, [&](clang::ASTContext& ast) { kinds.TraverseAST(ast); });
  ASSERT_THAT(parsed.errors, IsEmpty()) << parsed.errors[0].text << parsed.errors[0].where.line;
  std::set<std::string> missing;
  for (const std::string& kind : kinds_of_clang())
    if (!kinds.found.count(kind) && !is_of_another_language(kind)) missing.insert(kind);
  EXPECT_THAT(missing, IsEmpty()) << "every_node.source has to show them";
}

/// All the way: read, solved, edited and verified.
TEST_F(EveryNode, is_ported_without_a_crash) {
  std::string command;
  for (const std::string& word : unit.arguments) command += word + " ";
  std::ofstream(package.dir() + "/build/compile_commands.json")
      << "[{\"directory\":\"" << unit.directory << "\",\"file\":\"" << unit.file << "\",\"command\":\""
      << command << "\"}]";
  const Expected<PortPlan> plan = plan_port(package.options({}));
  ASSERT_TRUE(plan) << to_string(plan.error());
  std::size_t ported = 0;
  for (const Site& site : plan->report.sites)
    ported += site.kind == SiteKind::advertise && site.level != Level::plain;
  EXPECT_EQ(ported, 1u);
  EXPECT_GT(plan->report.sites.size(), 25u);
}

}  // namespace
}  // namespace tzc::rewriter
