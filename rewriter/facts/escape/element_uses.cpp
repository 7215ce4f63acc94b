// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/element_uses.h"

#include <set>

#include "facts/escape/filled_message.h"
#include "facts/escape/held_locks.h"
#include "facts/escape/kept_pointers.h"
#include "facts/escape/threads.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

using Kind = ElementUse::Kind;
using Kinds = KeptPointers::Kinds;

class UseReader {
 public:
  UseReader(const FunctionView& view, const KeptPointers& kept) : view_(view), kept_(kept) {}

  /// None: the elements do not matter.
  Kinds of_array(const clang::MemberExpr* array) const {
    const clang::Stmt* mention = array;
    const clang::Stmt* around = around_of(mention);
    if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(around)) return of_method(member);
    if (const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(around)) {
      if (op->getOperator() == clang::OO_Subscript) return of_element(op);
      if (op->isAssignmentOp()) return {op->getArg(0) == mention ? Kind::rebuild : Kind::walk};
    }
    if (const clang::VarDecl* variable = variable_of_loop(around)) return {of_loop(variable)};
    return {of_argument(around, mention).value_or(Kind::walk)};
  }

 private:
  /// The node around parentheses and implicit casts; `inner` becomes what lies directly in it.
  const clang::Stmt* around_of(const clang::Stmt*& inner) const {
    const clang::Stmt* around = view_.parent(inner);
    while (llvm::isa_and_nonnull<clang::ParenExpr, clang::ImplicitCastExpr>(around)) {
      inner = around;
      around = view_.parent(around);
    }
    return around;
  }

  Kinds of_method(const clang::MemberExpr* member) const {
    static const std::set<std::string> about_sizes = {"size", "empty", "capacity", "max_size",
                                                      "get_allocator"};
    static const std::set<std::string> pointers = {"begin", "end",     "rbegin", "rend", "cbegin",
                                                   "cend",  "crbegin", "crend",  "data"};
    static const std::set<std::string> one = {"at", "front", "back"};
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
    const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(view_.parent(member));
    if (!method || !call) return {Kind::walk};
    const std::string name = method->getNameAsString();
    if (about_sizes.count(name)) return {};
    if (one.count(name)) return of_element(call);
    if (!pointers.count(name)) return {method->isConst() ? Kind::walk : Kind::rebuild};
    const clang::Stmt* pointer = call;
    const clang::Stmt* around = around_of(pointer);
    if (const std::optional<Kind> given = of_argument(around, pointer)) return {*given};
    return kept_.kinds_of(call);
  }

  /// data[i] = 1, data[i] += 1, ++data[i]; a pointer to it lives on.
  Kinds of_element(const clang::Expr* element) const {
    const clang::Stmt* inner = element;
    const clang::Stmt* around = view_.parent(inner);
    while (llvm::isa_and_nonnull<clang::ParenExpr>(around)) inner = around, around = view_.parent(around);
    if (is_assigned(around, inner)) return {Kind::write};
    const auto* address = llvm::dyn_cast_or_null<clang::UnaryOperator>(around);
    if (address && address->getOpcode() == clang::UO_AddrOf) return kept_.kinds_of(address);
    return {is_address(around) ? Kind::walk : Kind::look};
  }
  static bool is_address(const clang::Stmt* around) {
    const auto* op = llvm::dyn_cast_or_null<clang::UnaryOperator>(around);
    return (op && op->getOpcode() == clang::UO_AddrOf) ||
           llvm::isa_and_nonnull<clang::DeclStmt, clang::CallExpr, clang::CXXConstructExpr>(around);
  }

  static std::optional<Kind> of_argument(const clang::Stmt* around, const clang::Stmt* argument) {
    const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
    const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
    if (!function) return {};
    for (unsigned i = 0; i < call->getNumArgs(); ++i)
      if (call->getArg(i) == argument && writes_to(qualified_name_of(function), i)) return Kind::write;
    return {};
  }

  /// The variable of a loop over a range whose range the declaration names; null: it is another one.
  const clang::VarDecl* variable_of_loop(const clang::Stmt* around) const {
    const auto* declaration = llvm::dyn_cast_or_null<clang::DeclStmt>(around);
    const auto* loop =
        declaration ? llvm::dyn_cast_or_null<clang::CXXForRangeStmt>(view_.parent(declaration)) : nullptr;
    return loop && loop->getRangeStmt() == declaration ? loop->getLoopVariable() : nullptr;
  }
  Kind of_loop(const clang::VarDecl* variable) const {
    for (const clang::DeclRefExpr* use : view_.uses(variable))
      if (variable->getType()->isReferenceType() && is_assigned(view_.parent(use), use)) return Kind::write;
    return Kind::walk;
  }

  const FunctionView& view_;
  const KeptPointers& kept_;
};

}  // namespace

std::vector<ElementUse> element_uses(const EscapeContext& context, const SeenFunction& seen) {
  const FunctionView& view = seen.view;
  std::vector<ElementUse> uses;
  const ThreadCode code(context, view);
  const KeptPointers kept(seen, code);
  const UseReader reader(view, kept);
  const HeldLocks locks(code, view);
  const bool is_constructor = llvm::isa<clang::CXXConstructorDecl>(view.function());
  const auto add = [&](const clang::Expr* message, const clang::Expr* at, Kind kind, bool read_only) {
    ElementUse use;
    use.kind = kind;
    use.read_only = read_only;
    use.code = code.around(at);
    if (is_constructor && !is_closure(use.code)) return;  // no other thread has the object
    use.locks = locks.at(at);
    use.captured = is_closure(use.code) && names_captured(message);
    use.where = context.unit.location(at->getExprLoc());
    for (const EntityId& id : context.sources_of(message)) {
      use.message = id;
      uses.push_back(use);
    }
  };
  for (const clang::Stmt* stmt : view.statements()) {
    const auto* array = llvm::dyn_cast<clang::MemberExpr>(stmt);
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt);
    if (array && is_data_array(array->getType())) {
      for (const Kind kind : reader.of_array(array))
        add(array->getBase(), array, kind, is_only_read(view, array));
    } else if (made && is_cloud_iterator(made->getConstructor()->getParent()) && made->getNumArgs() > 1) {
      const bool read_only = made->getConstructor()->getParent()->getName().contains("Const");
      for (const Kind kind : kept.kinds_of(made)) add(made->getArg(0), made, kind, read_only);
    } else if (const clang::Expr* message = filled_message(context.unit, stmt))
      add(message, message, Kind::write, false);
  }
  return uses;
}

}  // namespace tzc::rewriter
