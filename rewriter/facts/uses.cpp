// SPDX-License-Identifier: BSD-3-Clause
// Follows a value upwards through the expressions around it.
#include <clang/AST/ParentMapContext.h>

#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

class Follower {
 public:
  Follower(Unit& unit, const clang::Expr* leaf, Key key) : unit_(unit), at_(leaf), key_(std::move(key)) {}

  Sink run() {
    while (step()) {
    }
    return sink_;
  }

 private:
  bool step();
  bool into_decl(const clang::Decl* decl);
  bool into_expression(const clang::Expr* parent);
  bool into_member(const clang::MemberExpr* member);
  bool into_method(const clang::MemberExpr* member);
  bool into_list(const clang::InitListExpr* list);
  void note_resize(const clang::MemberExpr* array);
  bool into_operator(const clang::CXXOperatorCallExpr* call);
  bool into_binary(const clang::BinaryOperator* op);
  bool into_call(const clang::CallExpr* call);
  bool into_constructor(const clang::CXXConstructExpr* construct);
  bool into_cast(const clang::ExplicitCastExpr* cast);
  bool into_return(const clang::ReturnStmt* statement);
  bool into_initializer(const clang::CXXConstructorDecl* constructor);

  bool go_on(const clang::Expr* next) {
    at_ = next;
    return carried_by(next->getType(), unit_.rules).has_value();
  }
  bool done() const { return false; }
  bool refuse(const char* code, const std::string& reason) {
    add_obstacle(unit_, key_, code, reason, at_->getBeginLoc());
    return false;
  }
  void assign(const clang::Expr* target, const clang::Expr* value, const clang::Expr* statement);
  void check_source(const clang::Expr* value);

  Unit& unit_;
  const clang::Expr* at_;
  Key key_;
  Sink sink_;
};

unsigned argument_index(llvm::ArrayRef<const clang::Expr*> arguments, const clang::Expr* argument) {
  for (unsigned i = 0; i < arguments.size(); ++i)
    if (arguments[i] == argument) return i;
  return static_cast<unsigned>(arguments.size());
}

bool Follower::step() {
  const auto parents = unit_.ast().getParents(*at_);
  if (parents.empty()) return done();
  if (const auto* decl = parents[0].get<clang::Decl>()) return into_decl(decl);
  const auto* statement = parents[0].get<clang::Stmt>();
  if (!statement) return done();
  if (const auto* returned = llvm::dyn_cast<clang::ReturnStmt>(statement)) return into_return(returned);
  const auto* parent = llvm::dyn_cast<clang::Expr>(statement);
  return parent ? into_expression(parent) : done();
}

bool Follower::into_decl(const clang::Decl* decl) {
  if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(decl))
    return into_initializer(constructor);
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(decl);
  if (!variable && !field) return done();
  if (variable && variable->isCXXForRangeDecl()) return done();
  if (variable && variable->isImplicit() && !variable->isInitCapture()) return done();
  const auto* value = llvm::cast<clang::ValueDecl>(decl);
  const Key target = declare(unit_, value);
  if (target.empty())
    return value->getType()->isDependentType() || value->getType()->isScalarType()
               ? done()
               : refuse(codes::TZC1001, "it becomes part of '" + value->getNameAsString() + "'");
  sink_.variable = variable;
  add_flow(unit_, key_, target, at_->getBeginLoc(), "initialises '" + value->getNameAsString() + "'");
  return done();
}

bool Follower::into_initializer(const clang::CXXConstructorDecl* constructor) {
  for (const clang::CXXCtorInitializer* initializer : constructor->inits()) {
    if (!initializer->getMember() || !initializer->isWritten()) continue;
    const clang::SourceRange range = initializer->getInit()->getSourceRange();
    const auto& manager = unit_.source.manager();
    const clang::SourceLocation here = at_->getBeginLoc();
    if (manager.isBeforeInTranslationUnit(here, range.getBegin()) ||
        manager.isBeforeInTranslationUnit(range.getEnd(), here))
      continue;
    add_flow(unit_, key_, declare(unit_, initializer->getMember()), here,
             "initialises '" + initializer->getMember()->getNameAsString() + "'");
  }
  return done();
}

bool Follower::into_return(const clang::ReturnStmt* statement) {
  const clang::FunctionDecl* function = function_around(unit_, *statement);
  if (!function) return done();
  const Key target = declare_result(unit_, function);
  if (!target.empty())
    add_flow(unit_, key_, target, at_->getBeginLoc(), "returned from '" + function->getNameAsString() + "'");
  return done();
}

bool Follower::into_expression(const clang::Expr* parent) {
  if (parent->isTypeDependent()) return done();  // the template's instances tell
  if (llvm::isa<clang::ParenExpr, clang::ImplicitCastExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                clang::CXXBindTemporaryExpr, clang::ArraySubscriptExpr>(parent))
    return go_on(parent);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) return into_member(member);
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent)) return into_operator(op);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(parent)) return into_call(call);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(parent))
    return into_constructor(construct);
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(parent)) return into_cast(cast);
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(parent)) return go_on(op);
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(parent)) return into_binary(op);
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(parent))
    return choice->getCond() == at_ ? done() : go_on(choice);
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(parent)) return into_list(list);
  if (llvm::isa<clang::CXXNewExpr>(parent)) {
    add_flow(unit_, key_, declare_temporary(unit_, parent), at_->getBeginLoc(), "copied into a new object");
    return done();
  }
  if (llvm::isa<clang::CXXStdInitializerListExpr>(parent)) return go_on(parent);
  if (llvm::isa<clang::LambdaExpr, clang::UnaryExprOrTypeTraitExpr, clang::CXXTypeidExpr,
                clang::CXXDeleteExpr, clang::CXXDependentScopeMemberExpr, clang::UnresolvedMemberExpr>(
          parent))
    return done();
  return refuse(codes::TZC1001, "this use of it is not understood");
}

bool Follower::into_method(const clang::MemberExpr* member) {
  const auto parents = unit_.ast().getParents(*member);
  const auto* call = parents.empty() ? nullptr : parents[0].get<clang::CXXMemberCallExpr>();
  if (!call) return refuse(codes::TZC1001, "a member function of it is named but not called");
  if (unit_.rules.find_class_or_ported(qualified_name_of(call->getRecordDecl()))) return done();
  const std::string method = member->getMemberDecl()->getNameAsString();
  for (const clang::Expr* argument : call->arguments())
    if (carried_by(argument->getType(), unit_.rules)) check_source(argument);
  if (method == "reset" && call->getNumArgs() > 0) check_source(call->getArg(0));
  return go_on(call);
}

bool Follower::into_member(const clang::MemberExpr* member) {
  if (llvm::isa<clang::CXXMethodDecl>(member->getMemberDecl())) return into_method(member);
  if (!llvm::isa<clang::FieldDecl>(member->getMemberDecl())) return done();
  if (is_data_array(member->getType())) {
    unit_.facts.data_uses.push_back({key_, location_of(unit_.source.where(member->getMemberLoc())), true});
    note_resize(member);
    return done();
  }
  return go_on(member);
}

/// {a, b}: elements of a container, or parts of an aggregate. A list as written has no type; its semantic
/// form has.
bool Follower::into_list(const clang::InitListExpr* list) {
  const clang::InitListExpr* typed = list->isSemanticForm() ? list : list->getSemanticForm();
  if (!typed) return done();
  if (carried_by(typed->getType(), unit_.rules)) return go_on(typed);
  const clang::CXXRecordDecl* record = typed->getType()->getAsCXXRecordDecl();
  unsigned index = 0;
  if (record)
    for (const clang::FieldDecl* field : record->fields())
      if (index < list->getNumInits() && list->getInit(index++) == at_) {
        add_flow(unit_, key_, declare(unit_, field), at_->getBeginLoc(), "becomes a part of an aggregate");
        return done();
      }
  return refuse(codes::TZC1001, "it becomes part of an aggregate");
}

void Follower::note_resize(const clang::MemberExpr* array) {
  const auto parents = unit_.ast().getParents(*array);
  const auto* method = parents.empty() ? nullptr : parents[0].get<clang::MemberExpr>();
  if (!method || method->getMemberDecl()->getNameAsString() != "resize") return;
  const auto calls = unit_.ast().getParents(*method);
  const auto* resize = calls.empty() ? nullptr : calls[0].get<clang::CXXMemberCallExpr>();
  if (resize) collect_overwrite(unit_, resize, {key_});
}

/// What is assigned must be understood too: else the value may be one that can not be ported.
void Follower::check_source(const clang::Expr* value) {
  if (!sources_of(unit_, value).foreign) return;
  const Entity& entity = unit_.facts.entities[key_];
  const std::string text = unit_.source.text(value->getSourceRange());
  if (entity.carrier == Carrier::message)
    refuse(codes::TZC1013, "'" + text + "' is a message that code outside the package builds");
  else
    refuse(codes::TZC1017, "'" + text + "' is a publisher that code outside the package advertises");
}

void Follower::assign(const clang::Expr* target, const clang::Expr* value, const clang::Expr* statement) {
  if (at_ == target) return check_source(value);
  sink_.target = target;
  sink_.statement = statement;
  for (const Key& key : sources_of(unit_, target).keys)
    add_flow(unit_, key_, key, at_->getBeginLoc(),
             "assigned to '" + unit_.source.text(target->getSourceRange()) + "'");
}

bool Follower::into_operator(const clang::CXXOperatorCallExpr* call) {
  const clang::OverloadedOperatorKind op = call->getOperator();
  if (op == clang::OO_Equal) {
    assign(call->getArg(0), call->getArg(1), call);
    return at_ == call->getArg(0) ? go_on(call) : done();
  }
  if (op == clang::OO_Call) return into_call(call);
  if (is_package_function(unit_, call->getDirectCallee())) return into_call(call);
  return at_ == call->getArg(0) ? go_on(call) : done();
}

bool Follower::into_binary(const clang::BinaryOperator* op) {
  if (op->getOpcode() == clang::BO_Assign) {
    assign(op->getLHS(), op->getRHS(), op);
    return done();
  }
  if (op->getOpcode() == clang::BO_Comma) return at_ == op->getRHS() ? go_on(op) : done();
  return op->isAdditiveOp() ? go_on(op) : done();
}

bool Follower::into_call(const clang::CallExpr* call) {
  if (call->getCallee() == at_) return done();
  const llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
  unsigned index = argument_index(arguments, at_);
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) {
    const clang::CXXRecordDecl* record = method->getRecordDecl();
    const bool published = record && is_publisher_class(qualified_name_of(record)) &&
                           method->getMethodDecl() && method->getMethodDecl()->getNameAsString() == "publish";
    if (published && !llvm::StringRef(qualified_name_of(record)).ends_with("SingleSubscriberPublisher"))
      sink_.publish = method;
    const clang::Expr* object = method->getImplicitObjectArgument();
    if (method->getMethodDecl() && method->getMethodDecl()->getNameAsString() == "reset") {
      sink_.target = object;
      sink_.statement = call;
    }
  }
  return hand_to_call(unit_, key_, call, index) == Handed::result ? go_on(call) : done();
}

bool Follower::into_constructor(const clang::CXXConstructExpr* construct) {
  const llvm::ArrayRef<const clang::Expr*> arguments(construct->getArgs(), construct->getNumArgs());
  const unsigned index = argument_index(arguments, at_);
  if (hand_to_constructor(unit_, key_, construct, index) == Handed::done) return done();
  if (!llvm::isa<clang::CXXTemporaryObjectExpr>(construct)) return go_on(construct);
  add_flow(unit_, key_, declare_temporary(unit_, construct), at_->getBeginLoc(), "copied into a temporary");
  return done();
}

bool Follower::into_cast(const clang::ExplicitCastExpr* cast) {
  if (cast->getType()->isVoidType() || cast->getType()->isBooleanType()) return done();
  if (!carried_by(cast->getType(), unit_.rules))
    return refuse(codes::TZC1001, "it is cast to '" + cast->getType().getAsString() + "'");
  const Key target = declare_temporary(unit_, cast);
  add_flow(unit_, key_, target, at_->getBeginLoc(), "cast");
  return done();
}

}  // namespace

Sink follow_use(Unit& unit, const clang::Expr* leaf, const Key& key) {
  return Follower(unit, leaf, key).run();
}

}  // namespace tzc::rewriter
