// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/flow_uses.h"

#include <set>

#include "facts/flow/array_bounds.h"
#include "facts/flow/deleters.h"
#include "facts/flow/generic_callables.h"
#include "facts/flow/message_copies.h"
#include "facts/flow/overwrites.h"
#include "facts/flow/stock_vectors.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// sizeof, typeid, decltype: a ported message has another type.
constexpr const char* asks_for_its_type = "the program asks for its type";

unsigned argument_index(llvm::ArrayRef<const clang::Expr*> arguments, const clang::Expr* argument) {
  for (unsigned i = 0; i < arguments.size(); ++i)
    if (arguments[i] == argument) return i;
  return static_cast<unsigned>(arguments.size());
}

/// array.resize(n); null: it is no such call.
const clang::CXXMemberCallExpr* resize_of(const Unit& unit, const clang::MemberExpr* array) {
  const auto* method = parent_as<clang::MemberExpr>(unit.ast(), *array);
  if (!method || method->getMemberDecl()->getNameAsString() != "resize") return nullptr;
  return parent_as<clang::CXXMemberCallExpr>(unit.ast(), *method);
}

/// Leaves the fill of a resize out, or says that it is needed; none: this is none. Instances of a template have one text.
std::optional<Change> zero_fill_change(const Unit& unit, const clang::MemberExpr* array) {
  const clang::CXXMemberCallExpr* resize = resize_of(unit, array);
  if (resize == nullptr) return {};
  if (std::optional<Change> change = without_zero_fill(unit, resize)) return change;
  const std::optional<Place> where = zero_fill_place(unit, resize);
  return where ? std::optional(Change{*where, "", zero_fill_rule, {}}) : std::nullopt;
}

/// What a message is copied into is another object; what a pointer is copied into leads to the same one.
bool leads_to_the_same(const clang::Expr* pointer, const clang::Expr* copy) {
  return !message_of(pointer->getType()) && !message_of(copy->getType());
}

/// A variable template, or a static member of a class template: its instances are not looked into.
bool lasts_in_template(const clang::VarDecl* variable) {
  return variable->getDescribedVarTemplate() || llvm::isa<clang::VarTemplateSpecializationDecl>(variable) ||
         (variable->isStaticDataMember() && variable->getDeclContext()->isDependentContext());
}

/// decltype(publisher): as the type of a declaration it is the ported one where the publisher is ported, and the declaration takes part in
/// the port. Anywhere else (a template's argument, a name for the type, before ::) it is a question. The variable, parameter or member whose
/// type is this one, or a reference or pointer to it; null: it is part of something else.
const clang::ValueDecl* declared_as(clang::ASTContext& ast, const clang::TypeLoc& type) {
  auto around = clang::DynTypedNode::create(type);
  for (;;) {
    const clang::DynTypedNodeList parents = ast.getParents(around);
    if (parents.size() != 1) return nullptr;
    around = parents[0];
    if (const auto* variable = around.get<clang::VarDecl>()) return variable;
    if (const auto* field = around.get<clang::FieldDecl>()) return field;
    const auto* outer = around.get<clang::TypeLoc>();
    const bool leads_to_it =
        outer && (outer->getAs<clang::ReferenceTypeLoc>() || outer->getAs<clang::PointerTypeLoc>() ||
                  outer->getUnqualifiedLoc().getAs<clang::DecltypeTypeLoc>());
    if (!leads_to_it) return nullptr;
  }
}

}  // namespace

FlowEnd UseFollower::follow(const clang::Expr* leaf, const EntityId& id) {
  const auto known = ends_.find({leaf, id});
  if (known != ends_.end()) return known->second;
  at_ = leaf;
  id_ = id;
  end_ = {};
  handle_ = nullptr;
  while (step()) {
  }
  FlowEnd end = end_;
  if (const clang::Expr* handle = handle_) end = follow(handle, entities_.declare_temporary(handle));
  return ends_[{leaf, id}] = end;
}

bool UseFollower::go_on(const clang::Expr* next) {
  at_ = next;
  return carried_by(next->getType(), unit_.rules).has_value();
}

bool UseFollower::refuse(const char* code, const std::string& reason) {
  entities_.add_obstacle(id_, code, reason, at_->getBeginLoc());
  return false;
}

/// The value goes on: what it becomes must not be ported either.
template <class Call>
void UseFollower::note_generic_code(const Call* call) {
  if (entities_.is_message(id_) && may_call_generic_code(unit_, call) && !has_generic_deleter(unit_, call))
    refuse(codes::TZC1001, "a library may give it to a template that takes anything");
}

/// Where instances of a template share the expression, the value goes on in each of them; what it ends in is written there once.
bool UseFollower::step() {
  const auto parents = written_parents(unit_.ast(), clang::DynTypedNode::create(*at_));
  if (parents.empty()) return false;
  const clang::Expr* here = at_;
  const FlowEnd end = end_;
  for (const clang::DynTypedNode& instance : llvm::ArrayRef(parents).drop_front()) {
    if (into(instance))
      while (step()) {
      }
    at_ = here;
  }
  end_ = end;
  return into(parents.front());
}

bool UseFollower::into(const clang::DynTypedNode& around) {
  if (const auto* decl = around.get<clang::Decl>()) return into_decl(decl);
  if (const auto* type = around.get<clang::TypeLoc>()) {
    const clang::ValueDecl* declared = declared_as(unit_.ast(), *type);
    if (entities_.is_message(id_) || !declared)
      return refuse(entities_.is_message(id_) ? codes::TZC1001 : codes::TZC1010, asks_for_its_type);
    entities_.add_flow(id_, entities_.declare(declared),
                       {at_->getBeginLoc(), "gives '" + declared->getNameAsString() + "' its type"});
    return false;
  }
  const auto* statement = around.get<clang::Stmt>();
  if (!statement) return false;
  if (const auto* returned = llvm::dyn_cast<clang::ReturnStmt>(statement)) return into_return(returned);
  if (llvm::isa<clang::AsmStmt, clang::CoreturnStmt>(statement))
    return refuse(codes::TZC1001, "this use of it is not understood");
  const auto parent_of = [&](const clang::Stmt* of) {
    return of == at_ ? statement : parent_as<clang::Stmt>(unit_.ast(), *of);
  };
  if (is_value_of_statements(at_, parent_of))
    return refuse(codes::TZC1001, "it is the value of a statement expression");
  // No other statement uses the value of an expression.
  const auto* parent = llvm::dyn_cast<clang::Expr>(statement);
  return parent ? into_expression(parent) : false;
}

bool UseFollower::into_decl(const clang::Decl* decl) {
  if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(decl))
    return into_initializer(constructor);
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(decl);
  if (!variable && !field) return false;
  if (variable && variable->isCXXForRangeDecl()) return false;
  if (variable && variable->isImplicit() && !variable->isInitCapture()) return false;
  if (llvm::isa<clang::DecompositionDecl>(decl) && message_of(variable->getType()))
    return refuse(codes::TZC1001, "its fields are bound to names");
  if (variable && lasts_in_template(variable))
    return refuse(codes::TZC1001, "a variable of a template starts with it");
  const auto* value = llvm::cast<clang::ValueDecl>(decl);
  const EntityId target = entities_.declare(value);
  if (target.empty())
    return value->getType()->isDependentType() || value->getType()->isScalarType()
               ? false
               : refuse(codes::TZC1001, "it becomes part of '" + value->getNameAsString() + "'");
  end_.variable = variable;
  end_.member = field;
  const bool copies = variable && later_copy(unit_, variable);
  entities_.add_flow(id_, target,
                     {at_->getBeginLoc(), "initialises '" + value->getNameAsString() + "'", copies});
  return false;
}

bool UseFollower::into_initializer(const clang::CXXConstructorDecl* constructor) {
  for (const clang::CXXCtorInitializer* initializer : constructor->inits()) {
    if (!initializer->getMember() || !initializer->isWritten()) continue;
    const clang::SourceRange range = initializer->getInit()->getSourceRange();
    const auto& manager = unit_.source.manager();
    const clang::SourceLocation here = at_->getBeginLoc();
    if (manager.isBeforeInTranslationUnit(here, range.getBegin()) ||
        manager.isBeforeInTranslationUnit(range.getEnd(), here))
      continue;
    end_.member = initializer->getMember();
    entities_.add_flow(id_, entities_.declare(initializer->getMember()),
                       {here, "initialises '" + initializer->getMember()->getNameAsString() + "'"});
  }
  return false;
}

bool UseFollower::into_return(const clang::ReturnStmt* statement) {
  const clang::FunctionDecl* function = enclosing_function(unit_.ast(), *statement);
  if (!function) return false;
  const EntityId target = entities_.declare_result(function);
  if (!target.empty())
    entities_.add_flow(id_, target,
                       {at_->getBeginLoc(), "returned from '" + function->getNameAsString() + "'"});
  return false;
}

bool UseFollower::into_expression(const clang::Expr* parent) {
  if (parent->isTypeDependent()) {  // the instances tell, but an argument may be the same node in them
    const auto* call = llvm::dyn_cast<clang::CallExpr>(parent);
    if (call && !llvm::isa<clang::CXXMemberCallExpr>(call)) into_call(call);
    return false;
  }
  if (parent->getType()->isVoidPointerType() && !at_->getType()->isVoidPointerType())
    return refuse(codes::TZC1001, "its address is kept as '" + parent->getType().getAsString() + "'");
  if (llvm::isa<clang::ParenExpr, clang::ImplicitCastExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                clang::CXXBindTemporaryExpr, clang::ArraySubscriptExpr>(parent))
    return go_on(parent);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) return into_member(member);
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent)) return into_operator(op);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(parent)) return into_call(call);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(parent))
    return into_constructor(construct);
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(parent)) return into_cast(cast);
  if (parent->getType()->isMemberPointerType())
    return refuse(entities_.is_message(id_) ? codes::TZC1001 : codes::TZC1010,
                  "a pointer to the member leads to it");
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(parent)) return go_on(op);
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(parent)) return into_binary(op);
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(parent))
    return choice->getCond() == at_ ? false : go_on(choice);
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(parent)) return into_list(list);
  if (llvm::isa<clang::CXXNewExpr>(parent)) {
    entities_.add_flow(id_, entities_.declare_temporary(parent),
                       {at_->getBeginLoc(), "copied into a new object", copies_message(parent)});
    return false;
  }
  if (llvm::isa<clang::CXXStdInitializerListExpr>(parent)) return go_on(parent);
  if (llvm::isa<clang::UnaryExprOrTypeTraitExpr, clang::CXXTypeidExpr>(parent))
    return refuse(entities_.is_message(id_) ? codes::TZC1001 : codes::TZC1010, asks_for_its_type);
  if (llvm::isa<clang::LambdaExpr, clang::CXXDeleteExpr, clang::CXXDependentScopeMemberExpr,
                clang::UnresolvedMemberExpr>(parent))
    return false;
  return refuse(codes::TZC1001, "this use of it is not understood");
}

bool UseFollower::into_method(const clang::MemberExpr* member) {
  const auto* call = parent_as<clang::CXXMemberCallExpr>(unit_.ast(), *member);
  if (!call) return refuse(codes::TZC1001, "a member function of it is named but not called");
  note_generic_code(call);
  if (unit_.rules.find_class_or_ported(qualified_name_of(call->getRecordDecl()))) return false;
  const std::string method = member->getMemberDecl()->getNameAsString();
  for (const clang::Expr* argument : call->arguments())
    if (carried_by(argument->getType(), unit_.rules)) check_source(argument);
  if (entities_.is_message(id_) && (method == "type" || method == "target_type"))
    return refuse(codes::TZC1001, asks_for_its_type);
  static const std::set<std::string> of_holders = {"use_count", "unique", "expired", "lock"};
  if (entities_.is_message(id_) && of_holders.count(method) != 0)
    return refuse(codes::TZC1001, "the program asks who else holds it");
  if (method == "reset" && call->getNumArgs() > 0) check_source(call->getArg(0));
  return go_on(call);
}

bool UseFollower::into_member(const clang::MemberExpr* member) {
  if (llvm::isa<clang::CXXMethodDecl>(member->getMemberDecl())) return into_method(member);
  if (!llvm::isa<clang::FieldDecl>(member->getMemberDecl())) return false;
  if (is_data_array(member->getType())) {
    entities_.add_data_use(id_, member->getMemberLoc(), growth_at(unit_, member, entities_[id_].type));
    if (std::optional<Change> change = zero_fill_change(unit_, member))
      entities_.add_use(id_, std::move(*change));
    for (Change& change : changes_for_stock_vector(unit_, member)) entities_.add_use(id_, std::move(change));
    return false;
  }
  return go_on(member);
}

/// {a, b}: elements of a container, or parts of an aggregate. A list as written has no type; its semantic
/// form has.
bool UseFollower::into_list(const clang::InitListExpr* list) {
  const clang::InitListExpr* typed = list->isSemanticForm() ? list : list->getSemanticForm();
  if (!typed) return false;
  if (carried_by(typed->getType(), unit_.rules)) return go_on(typed);
  const clang::CXXRecordDecl* record = typed->getType()->getAsCXXRecordDecl();
  unsigned index = 0;
  if (record)
    for (const clang::FieldDecl* field : record->fields())
      if (index < list->getNumInits() && list->getInit(index++) == at_) {
        entities_.add_flow(id_, entities_.declare(field),
                           {at_->getBeginLoc(), "becomes a part of an aggregate"});
        return false;
      }
  return refuse(codes::TZC1001, "it becomes part of an aggregate");
}

/// What is assigned must be understood too: else the value may be one that cannot be ported. A message that is copied from a library
/// is a stock one, which a ported one can be assigned; it may be of any size.
void UseFollower::check_source(const clang::Expr* value, bool copies) {
  if (!sources_.of(value).foreign) return;
  if (copies) return entities_.add_data_use(id_, value->getBeginLoc());
  const std::string text = unit_.text(value);
  if (entities_.is_message(id_))
    refuse(codes::TZC1013, "'" + text + "' is a message that " + builder_of(value) + " builds");
  else
    refuse(codes::TZC1017, "'" + text + "' is a publisher that " + builder_of(value) + " advertises");
}

void UseFollower::assign(const clang::Expr* target, const clang::Expr* value, const clang::Expr* statement) {
  const bool copies = is_copied_by_assignment(target, value);
  if (at_ == target) return check_source(value, copies);
  end_.target = target;
  end_.statement = statement;
  const bool is_filter = entities_[id_].role == EntityRole::filter;  // may be kept as one of its bases
  if (!is_filter && target->getType()->isRecordType() && !carried_by(target->getType(), unit_.rules)) {
    refuse(entities_.is_message(id_) ? codes::TZC1001 : codes::TZC1010,
           "it becomes part of '" + unit_.text(target) + "', whose type does not tell");
    return;
  }
  const FlowSources targets = sources_.of(target);
  for (const EntityId& to : targets.entities)
    entities_.add_flow(id_, to,
                       {at_->getBeginLoc(), "assigned to '" + unit_.text(target) + "'", copies,
                        copies ? copied_as_stock(unit_, value) : std::vector<Change>()});
  if (targets.foreign && !message_of(at_->getType()))  // a message is copied
    refuse(entities_.is_message(id_) ? codes::TZC1001 : codes::TZC1010,
           "it is assigned to '" + unit_.text(target) + "', and nothing shows where that is");
}

bool UseFollower::into_operator(const clang::CXXOperatorCallExpr* call) {
  const clang::OverloadedOperatorKind op = call->getOperator();
  note_generic_code(call);
  if (op == clang::OO_Equal) {
    const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call->getDirectCallee());
    if (method && at_ == call->getArg(1) && unit_.declares(method) && method->isUserProvided())
      return into_call(call);
    assign(call->getArg(0), call->getArg(1), call);
    return at_ == call->getArg(0) ? go_on(call) : false;
  }
  if (op == clang::OO_Call) return into_call(call);
  if (unit_.declares(call->getDirectCallee())) return into_call(call);
  if (at_ == call->getArg(0)) return go_on(call);
  const bool only_reads = call->isComparisonOp() || op == clang::OO_LessLess || op == clang::OO_Subscript ||
                          !entities_.is_message(id_);
  return only_reads ? false : refuse(codes::TZC1001, "it is given to an operator of a library");
}

/// What is assigned goes to the target, which is the value of the assignment.
bool UseFollower::into_binary(const clang::BinaryOperator* op) {
  if (op->getOpcode() == clang::BO_Assign) assign(op->getLHS(), op->getRHS(), op);
  if (op->isAssignmentOp()) return at_ == op->getLHS() ? go_on(op) : false;
  if (op->getOpcode() == clang::BO_Comma) return at_ == op->getRHS() ? go_on(op) : false;
  if (op->isPtrMemOp()) return refuse(codes::TZC1001, "it is used through a pointer to member");
  return op->isAdditiveOp() ? go_on(op) : false;
}

bool UseFollower::into_call(const clang::CallExpr* call) {
  if (call->getCallee() == at_) return false;
  const llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
  note_generic_code(call);
  unsigned index = argument_index(arguments, at_);
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) {
    const clang::CXXRecordDecl* record = method->getRecordDecl();
    const bool published = record && is_publisher_class(qualified_name_of(record)) &&
                           method->getMethodDecl() && method->getMethodDecl()->getNameAsString() == "publish";
    if (published && !llvm::StringRef(qualified_name_of(record)).ends_with("SingleSubscriberPublisher"))
      end_.publish = method;
    const clang::Expr* object = method->getImplicitObjectArgument();
    if (method->getMethodDecl() && method->getMethodDecl()->getNameAsString() == "reset") {
      end_.target = object;
      end_.statement = call;
    }
  }
  return effects_.of_call(id_, call, index) == CallEffect::result ? go_on(call) : false;
}

bool UseFollower::into_constructor(const clang::CXXConstructExpr* construct) {
  const llvm::ArrayRef<const clang::Expr*> arguments(construct->getArgs(), construct->getNumArgs());
  const unsigned index = argument_index(arguments, at_);
  note_generic_code(construct);
  if (effects_.of_constructor(id_, construct, index) == CallEffect::done) return false;
  if (!llvm::isa<clang::CXXTemporaryObjectExpr>(construct)) return go_on(construct);
  entities_.add_flow(id_, entities_.declare_temporary(construct),
                     {at_->getBeginLoc(), "copied into a temporary"});
  if (leads_to_the_same(at_, construct)) handle_ = construct;
  return false;
}

bool UseFollower::into_cast(const clang::ExplicitCastExpr* cast) {
  if (cast->getType()->isVoidType() || cast->getType()->isBooleanType()) return false;
  if (!carried_by(cast->getType(), unit_.rules))
    return refuse(codes::TZC1001, "it is cast to '" + cast->getType().getAsString() + "'");
  const EntityId target = entities_.declare_temporary(cast);
  entities_.add_flow(id_, target, {at_->getBeginLoc(), "cast"});
  if (leads_to_the_same(at_, cast)) handle_ = cast;
  return false;
}

}  // namespace tzc::rewriter
