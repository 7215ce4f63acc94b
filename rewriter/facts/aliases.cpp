// SPDX-License-Identifier: BSD-3-Clause
// Pointers, references, iterators and views into a message's data. Publishing hands the data over: none of
// them may be used afterwards, and none may be kept where it is not seen.
#include <clang/AST/ParentMapContext.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

bool owns_its_elements(clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getCanonicalType()->getAsCXXRecordDecl();
  if (!record) return false;
  static const std::set<std::string> owners = {"vector", "basic_string", "set", "deque", "list"};
  return record->isInStdNamespace() && owners.count(record->getNameAsString()) != 0;
}

/// Can an object of this type point into the data?
bool may_point(clang::QualType type) {
  if (type->isVoidType() || type->isArithmeticType() || type->isEnumeralType()) return false;
  return !owns_its_elements(type.getNonReferenceType());
}

struct Alias {
  const clang::VarDecl* variable;
  std::vector<Key> keys;
};

/// Follows a pointer into data upwards to where it is kept.
class PointerFollower {
 public:
  PointerFollower(Unit& unit, const clang::Expr* at, std::vector<Key> keys)
      : unit_(unit), at_(at), keys_(std::move(keys)) {}
  std::optional<Alias> run() {
    while (step()) {
    }
    return alias_;
  }

 private:
  bool step();
  bool into_decl(const clang::Decl* decl);
  bool into_expression(const clang::Expr* parent);
  bool into_assignment(const clang::Expr* target);
  bool into_method(const clang::MemberExpr* member);
  bool into_call(const clang::CallExpr* call);
  bool go_on(const clang::Expr* next) {
    at_ = next;
    return true;
  }
  bool keep(const std::string& where) {
    for (const Key& key : keys_)
      add_obstacle(unit_, key, codes::TZC1003, "a pointer into its data is kept " + where,
                   at_->getBeginLoc());
    return false;
  }
  bool points() const {
    return (at_->isLValue() && !llvm::isa<clang::ImplicitCastExpr>(at_)) || may_point(at_->getType());
  }

  Unit& unit_;
  const clang::Expr* at_;
  std::vector<Key> keys_;
  std::optional<Alias> alias_;
};

bool PointerFollower::step() {
  const auto parents = unit_.ast().getParents(*at_);
  if (parents.empty()) return false;
  if (const auto* decl = parents[0].get<clang::Decl>()) return into_decl(decl);
  const auto* statement = parents[0].get<clang::Stmt>();
  if (llvm::isa_and_nonnull<clang::ReturnStmt>(statement))
    return may_point(at_->getType()) ? keep("by the caller") : false;
  const auto* parent = llvm::dyn_cast_or_null<clang::Expr>(statement);
  return parent && into_expression(parent);
}

bool PointerFollower::into_decl(const clang::Decl* decl) {
  if (llvm::isa<clang::FieldDecl, clang::CXXConstructorDecl>(decl))
    return may_point(at_->getType()) || llvm::isa<clang::FieldDecl>(decl) ? keep("in a member") : false;
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  if (!variable || variable->isImplicit()) return false;
  if (!variable->getType()->isReferenceType() && !may_point(variable->getType())) return false;
  if (!variable->isLocalVarDecl() || variable->isStaticLocal())
    return keep("in '" + variable->getNameAsString() + "'");
  alias_ = Alias{variable, keys_};
  return false;
}

bool PointerFollower::into_assignment(const clang::Expr* target) {
  if (target == at_ || !may_point(at_->getType())) return false;
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(target->IgnoreParenImpCasts());
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  if (!variable || !variable->isLocalVarDecl())
    return may_point(target->getType()) ? keep("in '" + unit_.source.text(target->getSourceRange()) + "'")
                                        : false;
  if (may_point(variable->getType())) alias_ = Alias{variable, keys_};
  return false;
}

bool PointerFollower::into_method(const clang::MemberExpr* member) {
  static const std::set<std::string> copies = {"clone", "copyTo", "convertTo", "size",
                                               "total", "empty",  "type"};
  if (!llvm::isa<clang::CXXMethodDecl>(member->getMemberDecl())) return go_on(member);
  if (copies.count(member->getMemberDecl()->getNameAsString())) return false;
  const auto parents = unit_.ast().getParents(*member);
  const auto* call = parents.empty() ? nullptr : parents[0].get<clang::CXXMemberCallExpr>();
  if (!call) return false;
  const bool reference = call->isLValue();
  return reference || may_point(call->getType()) ? go_on(call) : false;
}

bool PointerFollower::into_call(const clang::CallExpr* call) {
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
  if (op && op->isAssignmentOp() && op->getOperator() == clang::OO_Equal)
    return into_assignment(op->getArg(0) == at_ ? at_ : op->getArg(0));
  const bool element = op && at_ == op->getArg(0) &&
                       (op->getOperator() == clang::OO_Subscript || op->getOperator() == clang::OO_Star ||
                        op->getOperator() == clang::OO_Arrow);
  if (element) return go_on(call);
  const bool may_return_it = call->getType()->isPointerType() || op || !call->isLValue();
  return may_return_it && may_point(call->getType()) ? go_on(call) : false;
}

bool PointerFollower::into_expression(const clang::Expr* parent) {
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(parent)) {
    if (cast->getCastKind() == clang::CK_LValueToRValue && !may_point(cast->getType())) return false;
    return go_on(cast);
  }
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) return into_method(member);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(parent)) return into_call(call);
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(parent)) {
    if (op->isAssignmentOp()) return op->getLHS() == at_ ? false : into_assignment(op->getLHS());
    return op->isAdditiveOp() && may_point(op->getType()) ? go_on(op) : false;
  }
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(parent))
    return may_point(construct->getType()) ? go_on(construct) : false;
  if (llvm::isa<clang::LambdaExpr>(parent)) return false;
  return points() ? go_on(parent) : false;
}

// ------------------------------------------------------------------------------------------------------------------

unsigned offset_of(Unit& unit, clang::SourceLocation location) {
  return unit.source.where(location).begin;
}

struct Handover {
  unsigned offset;
  const clang::Stmt* loop;
};

const clang::Stmt* loop_around(Unit& unit, const clang::Stmt& stmt) {
  clang::DynTypedNode node = clang::DynTypedNode::create(stmt);
  for (;;) {
    const auto parents = unit.ast().getParents(node);
    if (parents.empty()) return nullptr;
    node = parents[0];
    if (node.get<clang::FunctionDecl>()) return nullptr;
    const auto* statement = node.get<clang::Stmt>();
    if (statement &&
        llvm::isa<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt>(statement))
      return statement;
  }
}

/// The aliases of one function, their uses, and where their messages are handed over.
class AliasVisitor : public clang::RecursiveASTVisitor<AliasVisitor> {
 public:
  explicit AliasVisitor(Unit& unit) : unit_(unit) {}

  bool VisitMemberExpr(clang::MemberExpr* member) {
    if (!is_data_array(member->getType())) return true;
    const Sources sources = sources_of(unit_, member->getBase());
    if (!sources.keys.empty()) follow(member, sources.keys);
    return true;
  }
  bool VisitVarDecl(clang::VarDecl* variable) {
    const auto carried = carried_by(variable->getType(), unit_.rules);
    const bool accessor = carried && carried->rename && carried->rename->role == ClassRename::Role::accessor;
    if (accessor && variable->isLocalVarDecl() && variable->getInit() && is_iterator(*carried->rename))
      add({variable, sources_of(unit_, variable->getInit()).keys});
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) {
    references_.push_back(reference);
    return true;
  }
  bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* call) {
    const clang::CXXMethodDecl* method = call->getMethodDecl();
    if (method && call->getNumArgs() > 0 && method->getNameAsString() == "publish" &&
        is_publisher_class(qualified_name_of(method->getParent())))
      hand_over(call, call->getArg(0));
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) {
    if (is_package_function(unit_, call->getDirectCallee()) && !llvm::isa<clang::CXXOperatorCallExpr>(call))
      for (const clang::Expr* argument : call->arguments())
        if (carried_by(argument->getType(), unit_.rules)) hand_over(call, argument);
    return true;
  }

  void finish() {
    for (std::size_t i = 0; i < aliases_.size(); ++i)
      for (const clang::DeclRefExpr* reference : references_)
        if (reference->getDecl() == aliases_[i].variable) follow(reference, aliases_[i].keys);
    for (const Alias& alias : aliases_)
      for (const clang::DeclRefExpr* reference : references_)
        if (reference->getDecl() == alias.variable) check(alias, reference);
  }

 private:
  static bool is_iterator(const ClassRename& rename) {
    return llvm::StringRef(rename.from).ends_with("Iterator");
  }
  void follow(const clang::Expr* expr, const std::vector<Key>& keys) {
    if (auto alias = PointerFollower(unit_, expr, keys).run()) add(*alias);
  }
  void add(const Alias& alias) {
    for (const Alias& known : aliases_)
      if (known.variable == alias.variable) return;
    if (aliases_.size() < 500) aliases_.push_back(alias);
  }
  void hand_over(const clang::CallExpr* call, const clang::Expr* message) {
    for (const Key& key : sources_of(unit_, message).keys)
      handovers_[key].push_back({offset_of(unit_, call->getEndLoc()), loop_around(unit_, *call)});
  }
  bool outlives(const Alias& alias, unsigned use, const Handover& handover) const {
    const unsigned born = offset_of(unit_, alias.variable->getLocation());
    if (born < handover.offset && use > handover.offset) return true;
    if (!handover.loop) return false;
    const unsigned begin = offset_of(unit_, handover.loop->getBeginLoc());
    const unsigned end = offset_of(unit_, handover.loop->getEndLoc());
    return born < begin && use > begin && use < end;
  }
  void check(const Alias& alias, const clang::DeclRefExpr* reference) {
    const unsigned use = offset_of(unit_, reference->getLocation());
    for (const Key& key : alias.keys)
      for (const Handover& handover : handovers_[key])
        if (outlives(alias, use, handover))
          add_obstacle(unit_, key, codes::TZC1003,
                       "'" + alias.variable->getNameAsString() +
                           "' points into its data and is used after the message was handed over",
                       reference->getLocation());
  }

  Unit& unit_;
  std::vector<Alias> aliases_;
  std::vector<const clang::DeclRefExpr*> references_;
  std::map<Key, std::vector<Handover>> handovers_;
};

}  // namespace

void collect_aliases(Unit& unit, const clang::FunctionDecl* function) {
  AliasVisitor visitor(unit);
  visitor.TraverseDecl(const_cast<clang::FunctionDecl*>(function));
  visitor.finish();
}

}  // namespace tzc::rewriter
