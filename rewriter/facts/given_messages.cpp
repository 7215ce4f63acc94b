// SPDX-License-Identifier: BSD-3-Clause
#include "facts/given_messages.h"

#include "facts/calls.h"
#include "facts/message_parts.h"
#include "facts/message_type.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned max_depth = 12;

bool outlives_functions(const MessagePart& part) {
  return part.rfind("c:", 0) == 0;
}

bool is_root(const MessagePart& part) {
  return part.find_first_of("/[") == MessagePart::npos;
}

bool is_library_container(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXRecordDecl* record = call->getRecordDecl();
  if (!record || unit.declares(call->getMethodDecl())) return false;
  const std::string name = qualified_name_of(record);
  return name.rfind("std::", 0) == 0 || name.rfind("boost::", 0) == 0;
}

/// What an expression leads on to without making another object; null: it is a name, a call, or something else.
const clang::Expr* operand_of(const clang::Expr* expr) {
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expr)) return cast->getSubExpr();
  if (const auto* full = llvm::dyn_cast<clang::FullExpr>(expr)) return full->getSubExpr();
  if (const auto* made = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr)) return made->getSubExpr();
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(expr)) return bound->getSubExpr();
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getSubExpr();
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return element->getBase();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr)) return op->getArg(0);
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
  return made && made->getNumArgs() > 0 ? made->getArg(0) : nullptr;
}

class GivenMessages {
 public:
  GivenMessages(const Unit& unit, const FunctionView& view, EscapeFacts& facts)
      : unit_(unit),
        view_(view),
        parts_(unit, view),
        function_(usr_of(pattern_of(view.function()))),
        facts_(facts) {}

  void look_at(const clang::Stmt* stmt);

 private:
  std::string holder_of(const clang::Expr* expr, unsigned depth = 0) const;
  std::string holder_of_name(const clang::VarDecl* variable, unsigned depth) const;
  std::string holder_of_call(const clang::CallExpr* call, unsigned depth) const;
  const clang::Expr* leads_to(const clang::VarDecl* variable) const;
  std::string unique(const clang::ValueDecl* decl) const;
  void give(const clang::Expr* message, const std::string& holder, const std::string& how);
  void member_call(const clang::CXXMemberCallExpr* call);
  void construction(const clang::CXXConstructExpr* construct);

  const Unit& unit_;
  const FunctionView& view_;
  MessageParts parts_;
  std::string function_;
  EscapeFacts& facts_;
};

/// A variable of a function has its name in that function only.
std::string GivenMessages::unique(const clang::ValueDecl* decl) const {
  const std::string root = parts_.root_of(decl);
  return root.rfind("local ", 0) == 0 ? root + " of " + function_ : root;
}

/// The range of a loop over it, or what a reference, a pointer or an iterator was made from; null: neither.
const clang::Expr* GivenMessages::leads_to(const clang::VarDecl* variable) const {
  for (const clang::Stmt* stmt : view_.statements())
    if (const auto* loop = llvm::dyn_cast<clang::CXXForRangeStmt>(stmt))
      if (loop->getLoopVariable() == variable) return loop->getRangeInit();
  const bool is_message = !variable->getType()->isReferenceType() && is_stock_or_twin(variable->getType());
  return is_message || !variable->isLocalVarDecl() || variable->isStaticLocal() ? nullptr
                                                                                : variable->getInit();
}

std::string GivenMessages::holder_of_name(const clang::VarDecl* variable, unsigned depth) const {
  const clang::Expr* const from = leads_to(variable);
  const std::string holder = from ? holder_of(from, depth) : std::string();
  return holder.empty() ? unique(variable) : holder;
}

std::string GivenMessages::holder_of_call(const clang::CallExpr* call, unsigned depth) const {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return {};
  if (passes_through(function)) return holder_of(call->getArg(0), depth);
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (!unit_.declares(function))
    return method ? holder_of(method->getImplicitObjectArgument(), depth) : std::string();
  const MessagePart part = parts_.part_of(call);
  return outlives_functions(part) ? part.substr(0, part.find_first_of("/["))
                                  : result_root(usr_of(pattern_of(function)));
}

std::string GivenMessages::holder_of(const clang::Expr* expr, unsigned depth) const {
  if (depth > max_depth) return {};
  expr = expr->IgnoreParens();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
    return variable ? holder_of_name(variable, depth + 1) : std::string();
  }
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr))
    return unit_.source.in_package(member->getMemberDecl()->getLocation())
               ? unique(member->getMemberDecl())
               : holder_of(member->getBase(), depth + 1);
  if (const clang::Expr* operand = operand_of(expr)) return holder_of(operand, depth + 1);
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  return call ? holder_of_call(call, depth + 1) : std::string();
}

void GivenMessages::give(const clang::Expr* message, const std::string& holder, const std::string& how) {
  if (holder.empty() || !is_stock_or_twin(message->getType())) return;
  const MessagePart part = parts_.part_of(message);
  if (!outlives_functions(part) || !is_root(part) || part == holder) return;
  facts_.given_messages.push_back({part, holder, how, unit_.location(message->getBeginLoc())});
}

void GivenMessages::member_call(const clang::CXXMemberCallExpr* call) {
  if (is_publish(call)) {
    const Place place = unit_.source.where(call->getExprLoc());
    for (const clang::Expr* argument : call->arguments())
      if (std::string holder = holder_of(argument); !holder.empty())
        facts_.published_from[{place.file, place.begin}].insert(std::move(holder));
  } else if (is_library_container(unit_, call)) {
    for (const clang::Expr* argument : call->arguments())
      give(argument, holder_of(call->getImplicitObjectArgument()),
           "stored by '" + call->getMethodDecl()->getNameAsString() + "'");
  }
}

/// A copy for a parameter, or for the caller.
void GivenMessages::construction(const clang::CXXConstructExpr* construct) {
  if (!construct->getConstructor()->isCopyOrMoveConstructor()) return;
  const clang::Stmt* inner = construct;
  const clang::Stmt* around = view_.parent(inner);
  while (llvm::isa_and_nonnull<clang::CastExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                               clang::CXXBindTemporaryExpr, clang::CXXConstructExpr>(around)) {
    inner = around;
    around = view_.parent(around);
  }
  if (llvm::isa_and_nonnull<clang::ReturnStmt>(around) && !view_.lambda_around(around))
    return give(construct->getArg(0), result_root(function_),
                "returned from '" + view_.function()->getNameAsString() + "'");
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
  const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
  if (!unit_.declares(callee) || llvm::isa<clang::CXXOperatorCallExpr>(call)) return;
  for (unsigned i = 0; i < call->getNumArgs(); ++i)
    if (call->getArg(i) == inner)
      give(construct->getArg(0), parameter_root(usr_of(pattern_of(callee)), i),
           "passed to '" + callee->getNameAsString() + "'");
}

void GivenMessages::look_at(const clang::Stmt* stmt) {
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) return construction(construct);
  if (const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(stmt)) return member_call(call);
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(stmt);
  if (!op || op->getOperator() != clang::OO_Equal || op->getNumArgs() != 2 || op->getArg(1)->isLValue())
    return;
  give(op->getArg(1), holder_of(op->getArg(0)), "moved to '" + unit_.text(op->getArg(0)) + "'");
}

}  // namespace

void note_given_messages(const Unit& unit, const FunctionView& view, EscapeFacts& facts) {
  GivenMessages finder(unit, view, facts);
  for (const clang::Stmt* stmt : view.statements()) finder.look_at(stmt);
}

}  // namespace tzc::rewriter
