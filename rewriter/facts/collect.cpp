// SPDX-License-Identifier: BSD-3-Clause
#include <clang/AST/ParentMapContext.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include "facts/advertise_sites.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

class Collector : public clang::RecursiveASTVisitor<Collector> {
 public:
  explicit Collector(Unit& unit) : unit_(unit) {}
  bool shouldVisitTemplateInstantiations() const { return true; }

  bool VisitVarDecl(clang::VarDecl* variable) {
    if (!dependent(variable->getType())) collect_declaration_birth(unit_, variable);
    declare(unit_, variable);
    check_source_of(variable);
    return true;
  }
  bool VisitFieldDecl(clang::FieldDecl* field) {
    declare(unit_, field);
    return true;
  }
  bool VisitFunctionDecl(clang::FunctionDecl* function) {
    if (!llvm::isa<clang::CXXDestructorDecl>(function)) declare_result(unit_, function);
    collect_helper(unit_, function);
    if (function->isThisDeclarationADefinition() && !function->isDependentContext() && !is_lambda(function))
      functions_.push_back(function);
    return true;
  }
  bool VisitCXXRecordDecl(clang::CXXRecordDecl* record) {
    if (!record->isThisDeclarationADefinition()) return true;
    for (const clang::CXXBaseSpecifier& base : record->bases())
      if (const clang::CXXRecordDecl* of = base.getType()->getAsCXXRecordDecl())
        unit_.facts.bases[usr_of(record)].insert(usr_of(of));
    return true;
  }
  bool VisitCXXForRangeStmt(clang::CXXForRangeStmt* loop) {
    const Key variable = loop->getLoopVariable() ? declare(unit_, loop->getLoopVariable()) : Key();
    if (variable.empty() || !loop->getRangeInit()) return true;
    for (const Key& key : sources_of(unit_, loop->getRangeInit()).keys)
      add_flow(unit_, key, variable, loop->getForLoc(), "looped over");
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) {
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(reference->getDecl()))
      check_address_taken(function, reference);
    else
      leaf(reference, declare(unit_, reference->getDecl()), true);
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) {
    if (llvm::isa<clang::FieldDecl, clang::VarDecl>(member->getMemberDecl()))
      leaf(member, declare(unit_, member->getMemberDecl()), true);
    return true;
  }
  bool VisitCXXNewExpr(clang::CXXNewExpr* expr) { return object(expr, expr->getAllocatedTypeSourceInfo()); }
  bool VisitCXXTemporaryObjectExpr(clang::CXXTemporaryObjectExpr* expr) {
    return object(expr, expr->getTypeSourceInfo());
  }
  bool VisitExplicitCastExpr(clang::ExplicitCastExpr* cast) {
    check_const_cast(unit_, cast);
    return carried_by(cast->getType(), unit_.rules) ? object(cast, cast->getTypeInfoAsWritten()) : true;
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* construct) {
    if (in_package(construct)) collect_library_construction(unit_, construct);
    const std::string name = qualified_name_of(construct->getConstructor()->getParent());
    const ClassRename* rename = unit_.rules.find_class_or_ported(name);
    if (rename && rename->role == ClassRename::Role::filter && in_package(construct))
      collect_filter(unit_, construct, filter_of(unit_, construct));
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call);
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) {
    check_lambda(lambda);
    return true;
  }

  void finish() {
    for (const clang::FunctionDecl* function : functions_) collect_aliases(unit_, function);
    connect_births(unit_);
  }

 private:
  static bool dependent(clang::QualType type) { return type->isDependentType(); }
  static bool is_lambda(const clang::FunctionDecl* function) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
    return method && method->getParent()->isLambda();
  }
  bool in_package(const clang::Expr* expr) const { return unit_.source.in_package(expr->getBeginLoc()); }

  void leaf(const clang::Expr* expr, const Key& key, bool is_name);
  bool object(const clang::Expr* expr, const clang::TypeSourceInfo* type);
  void member_call(clang::CXXMemberCallExpr* call);
  void made_object(clang::CallExpr* call);
  void ported_call(clang::CallExpr* call, const std::string& function);
  void note_publisher_arguments(clang::CallExpr* call);
  std::vector<Key> messages_among(const clang::CallExpr* call);
  void adapter_birth(clang::CXXMemberCallExpr* call, const MethodCall& rule);
  void check_source_of(const clang::VarDecl* variable);
  void check_address_taken(const clang::FunctionDecl* function, const clang::DeclRefExpr* reference);
  void check_lambda(const clang::LambdaExpr* lambda);
  void pin_parameters(const clang::FunctionDecl* function, const std::string& name);

  Unit& unit_;
  std::vector<const clang::FunctionDecl*> functions_;
};

void Collector::leaf(const clang::Expr* expr, const Key& key, bool is_name) {
  if (key.empty() || expr->isTypeDependent()) return;
  const Sink sink = follow_use(unit_, expr, key);
  const Entity& entity = unit_.facts.entities[key];
  const bool standing = entity.home == Home::member || entity.home == Home::global;
  if (is_name && standing && sink.publish && message_of(expr->getType()))
    unit_.members.push_back({key, expr, function_around(unit_, *expr)});
}

bool Collector::object(const clang::Expr* expr, const clang::TypeSourceInfo* type) {
  if (expr->isTypeDependent() || !in_package(expr)) return true;
  const Key key = declare_temporary(unit_, expr);
  if (key.empty()) return true;
  if (type) retype(unit_, type->getTypeLoc(), unit_.facts.entities[key]);
  const Sink sink = follow_use(unit_, expr, key);
  const clang::QualType pointee = pointee_of(expr->getType());
  const bool makes = llvm::isa<clang::CXXNewExpr>(expr) || message_of(expr->getType());
  const auto message = message_of(pointee.isNull() ? expr->getType() : pointee);
  if (makes && message && message->has_data) collect_object_birth(unit_, expr, key, sink);
  return true;
}

void Collector::made_object(clang::CallExpr* call) {
  const Key key = declare_temporary(unit_, call);
  if (key.empty()) return;
  const auto* callee = llvm::dyn_cast<clang::DeclRefExpr>(call->getCallee()->IgnoreParenImpCasts());
  if (callee && callee->hasExplicitTemplateArgs())
    for (const clang::TemplateArgumentLoc& argument : callee->template_arguments())
      if (argument.getTypeSourceInfo())
        retype(unit_, argument.getTypeSourceInfo()->getTypeLoc(), unit_.facts.entities[key]);
  const Sink sink = follow_use(unit_, call, key);
  const clang::CXXRecordDecl* made = pointee_of(call->getType())->getAsCXXRecordDecl();
  const ClassRename* rename = made ? unit_.rules.find_class_or_ported(qualified_name_of(made)) : nullptr;
  if (rename && rename->role == ClassRename::Role::filter) collect_made_filter(unit_, call, made, key);
  const auto message = message_of(pointee_of(call->getType()));
  if (message && message->has_data) collect_object_birth(unit_, call, key, sink);
}

std::vector<Key> Collector::messages_among(const clang::CallExpr* call) {
  std::vector<Key> messages;
  for (const clang::Expr* argument : call->arguments()) {
    const auto carried = carried_by(argument->getType(), unit_.rules);
    if (!carried || carried->carrier != Carrier::message) continue;
    const Sources sources = sources_of(unit_, argument);
    messages.insert(messages.end(), sources.keys.begin(), sources.keys.end());
  }
  return messages;
}

void Collector::note_publisher_arguments(clang::CallExpr* call) {
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) || !is_package_function(unit_, call->getDirectCallee()))
    return;
  for (const clang::Expr* argument : call->arguments()) {
    const auto carried = carried_by(argument->getType(), unit_.rules);
    if (!carried || carried->carrier != Carrier::publisher) continue;
    const Sources sources = sources_of(unit_, argument);
    const clang::Expr* written = argument->IgnoreImplicit();
    const bool pointer = !pointee_of(argument->getType()).isNull();
    if (!sources.keys.empty())
      unit_.publishers.push_back({written, pointer, sources.keys[0], messages_among(call),
                                  function_around(unit_, *call),
                                  unit_.source.where(call->getBeginLoc()).begin});
  }
}

bool Collector::VisitCallExpr(clang::CallExpr* call) {
  if (call->isTypeDependent() || !in_package(call)) return true;
  collect_wait_for_message(unit_, call);
  collect_helper_call(unit_, call);
  if (makes_object(call)) made_object(call);
  if (auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) member_call(member);
  collect_library_advertise(unit_, call);
  note_publisher_arguments(call);
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (function) ported_call(call, qualified_name_of(function));
  if (function && !makes_object(call) && is_package_function(unit_, function))
    leaf(call, declare_result(unit_, function), false);
  return true;
}

/// tzc::advertise<M>(nh, ...), tzc::subscribe(nh, ...): an earlier run wrote them.
void Collector::ported_call(clang::CallExpr* call, const std::string& function) {
  const MethodCall* rule = unit_.rules.find_ported_function(function);
  if (!rule) return;
  const bool subscribes =
      rule->role == MethodCall::Role::subscribe || rule->role == MethodCall::Role::subscribe_transport;
  if (subscribes) return collect_ported_subscribe(unit_, call, *rule);
  collect_ported_advertise(unit_, call, *rule);
  follow_use(unit_, call, declare_temporary(unit_, call));
}

void Collector::member_call(clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method || !call->getRecordDecl()) return;
  const std::string object = qualified_name_of(method->getParent());
  const std::string name = method->getNameAsString();
  if (name == "publish" && is_publisher_class(object)) return collect_publish(unit_, call);
  collect_library_member_call(unit_, call);
  if (name == "registerCallback") collect_registered_callback(unit_, call);
  const ClassRename* rename = unit_.rules.find_class_or_ported(object);
  if (rename && rename->role == ClassRename::Role::filter && name == "subscribe")
    return collect_filter(unit_, call);
  const MethodCall* rule = unit_.rules.find_method(object, name, written_arguments(call));
  if (!rule) return;
  switch (rule->role) {
    case MethodCall::Role::advertise:
    case MethodCall::Role::advertise_transport:
      collect_advertise(unit_, call, *rule);
      follow_use(unit_, call, declare_temporary(unit_, call));
      return;
    case MethodCall::Role::subscribe:
    case MethodCall::Role::subscribe_transport:
      return collect_subscribe(unit_, call, *rule);
    case MethodCall::Role::builds_message:
      return adapter_birth(call, *rule);
    case MethodCall::Role::fills_message:
      return;
  }
}

void Collector::adapter_birth(clang::CXXMemberCallExpr* call, const MethodCall& rule) {
  const Key key = declare_temporary(unit_, call);
  if (key.empty()) return;
  follow_use(unit_, call, key);
  Birth birth;
  birth.entity = key;
  birth.adapter = true;
  birth.where = location_of(unit_.source.where(call->getExprLoc()));
  birth.changes = receiver_first(unit_, call, rule.to, rule.rule, rule.header, "$PUB");
  if (birth.changes.empty())
    return add_obstacle(unit_, key, codes::TZC1006, "the call comes from a macro", call->getBeginLoc());
  const clang::FunctionDecl* function = function_around(unit_, *call);
  if (function) birth.record = record_usr_of(function);
  unit_.facts.data_uses.push_back({key, birth.where, true});
  unit_.births.push_back({birth, function});
}

/// A variable that starts with a message, or publisher, of code outside the package.
void Collector::check_source_of(const clang::VarDecl* variable) {
  const Key key = declare(unit_, variable);
  if (key.empty() || !variable->getInit() || variable->isCXXForRangeDecl() || variable->isImplicit()) return;
  if (llvm::isa<clang::ParmVarDecl>(variable) || variable->getInit()->isTypeDependent()) return;
  if (!sources_of(unit_, variable->getInit()).foreign) return;
  const bool message = unit_.facts.entities[key].carrier == Carrier::message;
  const std::string text = unit_.source.text(variable->getInit()->getSourceRange());
  add_obstacle(unit_, key, message ? codes::TZC1013 : codes::TZC1017,
               "it starts as '" + text + "', which code outside the package builds", variable->getLocation());
}

/// A function whose address is taken is called by others: a callback. What it takes stays as it is.
void Collector::check_address_taken(const clang::FunctionDecl* function,
                                    const clang::DeclRefExpr* reference) {
  if (!is_package_function(unit_, function)) return;
  const auto parents = unit_.ast().getParents(*reference);
  const auto* cast = parents.empty() ? nullptr : parents[0].get<clang::ImplicitCastExpr>();
  const auto outer = cast ? unit_.ast().getParents(*cast) : parents;
  const auto* call = outer.empty() ? nullptr : outer[0].get<clang::CallExpr>();
  if (call && call->getCallee() == (cast ? static_cast<const clang::Expr*>(cast) : reference)) return;
  const std::string name = function->getNameAsString();
  pin_parameters(function, name);
  if (const Key key = declare_result(unit_, function); !key.empty())
    add_obstacle(unit_, key, codes::TZC1005, "'" + name + "' is called through its address",
                 reference->getLocation());
}

/// A lambda that is not kept in a variable is called by others.
void Collector::check_lambda(const clang::LambdaExpr* lambda) {
  if (!unit_.source.in_package(lambda->getBeginLoc())) return;
  clang::DynTypedNode node = clang::DynTypedNode::create(*lambda);
  for (;;) {
    const auto parents = unit_.ast().getParents(node);
    if (parents.empty()) break;
    node = parents[0];
    if (const auto* variable = node.get<clang::VarDecl>())
      if (const auto* record = variable->getType()->getAsCXXRecordDecl(); record && record->isLambda())
        return;
    const auto* statement = node.get<clang::Stmt>();
    if (!statement ||
        !llvm::isa<clang::ImplicitCastExpr, clang::MaterializeTemporaryExpr, clang::CXXConstructExpr,
                   clang::CXXBindTemporaryExpr, clang::FullExpr>(statement))
      break;
  }
  pin_parameters(lambda->getCallOperator(), "lambda");
}

void Collector::pin_parameters(const clang::FunctionDecl* function, const std::string& name) {
  for (const clang::ParmVarDecl* parameter : function->parameters()) {
    const Key key = declare(unit_, parameter);
    if (key.empty()) continue;
    const bool message = unit_.facts.entities[key].carrier == Carrier::message;
    add_obstacle(unit_, key, message ? codes::TZC1004 : codes::TZC1005,
                 "it comes in through the callback '" + name + "'", parameter->getLocation());
  }
}

}  // namespace

void collect(Unit& unit) {
  Collector collector(unit);
  collector.TraverseAST(unit.ast());
  collector.finish();
}

}  // namespace tzc::rewriter
