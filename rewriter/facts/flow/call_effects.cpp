// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/call_effects.h"

#include "facts/flow/message_copies.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bound_calls.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_advertise.h"
#include "facts/syntax/type_blind.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

clang::SourceRange callee_name(const clang::CallExpr* call) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(call->getCallee()->IgnoreParenImpCasts());
  return reference ? reference->getNameInfo().getSourceRange().isValid()
                         ? clang::SourceRange(reference->getBeginLoc(), reference->getNameInfo().getEndLoc())
                         : clang::SourceRange()
                   : clang::SourceRange();
}

bool swaps(const std::string& function) {
  return function == "std::swap" || function == "boost::swap";
}

/// f(publisher, x) in a template or generic lambda, where the type of x is not known: the only f that is declared.
const clang::FunctionDecl* only_candidate(const clang::CallExpr* call) {
  const auto* names = llvm::dyn_cast<clang::UnresolvedLookupExpr>(call->getCallee()->IgnoreParenImpCasts());
  if (!names || names->getNumDecls() != 1) return nullptr;
  return llvm::dyn_cast<clang::FunctionDecl>((*names->decls_begin())->getUnderlyingDecl());
}

/// Templates of ROS that read a message of any type by its traits and serializer, which twins have, and keep nothing.
bool reads_any_message(const std::string& function, const clang::CallExpr* call) {
  static const std::set<std::string> names = {"rosbag::Bag::write", "ros::serialization::serializationLength",
                                              "ros::serialization::serializeMessage"};
  if (names.count(function) != 0 || function.rfind("ros::message_traits::", 0) == 0) return true;
  if (function != "ros::serialization::serialize" || call->getNumArgs() == 0) return false;
  const clang::CXXRecordDecl* stream = call->getArg(0)->getType()->getAsCXXRecordDecl();
  return stream && qualified_name_of(stream).rfind("ros::serialization::", 0) == 0;
}

/// shared_ptr<Image>(frame, &frame->image): the frame's destructor runs when the last subscriber lets go of the image.
bool shows_its_end(const clang::CXXConstructExpr* construct) {
  if (construct->getNumArgs() != 2 || pointee_of(construct->getType()).isNull()) return false;
  const clang::QualType owner = pointee_of(construct->getArg(0)->getType());
  const clang::CXXRecordDecl* record = owner.isNull() ? nullptr : owner->getAsCXXRecordDecl();
  const bool is_known = record && record->hasDefinition();
  const clang::CXXDestructorDecl* destructor = is_known ? record->getDestructor() : nullptr;
  return destructor && destructor->isUserProvided();
}

/// The only one that takes so many arguments; null: none, or one of several, a base class's or a template's.
const clang::CXXConstructorDecl* only_constructor(const clang::CXXRecordDecl* record, unsigned arguments) {
  const clang::CXXConstructorDecl* only = nullptr;
  if (!record || !record->hasDefinition()) return nullptr;
  for (const clang::Decl* decl : record->decls()) {
    if (llvm::isa<clang::ConstructorUsingShadowDecl>(decl)) return nullptr;
    const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(decl);
    if (pattern && llvm::isa<clang::CXXConstructorDecl>(pattern->getTemplatedDecl())) return nullptr;
    const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(decl);
    if (!constructor || constructor->isCopyOrMoveConstructor() || constructor->getNumParams() < arguments ||
        constructor->getMinRequiredArguments() > arguments)
      continue;
    if (only) return nullptr;
    only = constructor;
  }
  return only;
}

/// A ported message, publisher or filter has another type. A template that only calls its functions does the same with both. An object that
/// is made of it may be one of a class that asks: Outlet outlet{publisher};
bool asks_for_type(const Unit& unit, const clang::FunctionDecl* function, unsigned argument) {
  if (!is_type_blind(unit, function, argument)) return true;
  const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(function);
  const clang::FunctionDecl* pattern = constructor ? constructor->getTemplateInstantiationPattern() : nullptr;
  const auto* made =
      pattern ? llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(constructor->getParent()) : nullptr;
  return made && argument < pattern->getNumParams() &&
         pattern->getParamDecl(argument)->getType()->isDependentType() && !is_type_blind(unit, made);
}

}  // namespace

void retype(EntityTable& entities, const EntityId& id, llvm::ArrayRef<clang::TemplateArgumentLoc> written) {
  for (const clang::TemplateArgumentLoc& argument : written)
    if (argument.getTypeSourceInfo()) entities.retype(id, argument.getTypeSourceInfo()->getTypeLoc());
}

bool serves_plain_field(const Unit& unit, const clang::Expr* cast) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *cast)) {
    const auto* parent = node.get<clang::Expr>();
    if (!parent) return false;
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) {
      const bool field = llvm::isa<clang::FieldDecl>(member->getMemberDecl());
      if (field) return !is_data_array(member->getType()) && !carried_by(member->getType(), unit.rules);
    } else if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent)) {
      if (op->getOperator() != clang::OO_Arrow && op->getOperator() != clang::OO_Star) return false;
    } else if (!is_implicit_wrapper(parent) && !llvm::isa<clang::UnaryOperator>(parent)) {
      return false;
    }
  }
  return false;
}

void CallEffects::escape(const EntityId& id, const std::string& receiver, clang::SourceLocation where) {
  const EntityRole role = entities_[id].role;
  if (role == EntityRole::filter) return;
  const std::string reason = "it is passed to '" + receiver + "', which is not part of the package";
  entities_.add_obstacle(id, role == EntityRole::publisher ? codes::TZC1010 : codes::TZC1002, reason, where);
}

void CallEffects::use_rule(const EntityId& id, const clang::CallExpr* call, const LibraryCall& rule) {
  const clang::SourceRange name = callee_name(call);
  entities_.add_data_use(id, name.getBegin());
  if (const std::optional<Place> where = unit_.source.place(name))
    entities_.add_use(id, {*where, rule.to, rule.rule, {rule.header}});
  else
    entities_.add_obstacle(id, codes::TZC1006, "the call comes from a macro", name.getBegin());
}

/// img.toImageMsg(message) -> to_image_msg(img, message)
void CallEffects::use_rule(const EntityId& id, const clang::CXXMemberCallExpr* call, const MethodCall& rule) {
  entities_.add_data_use(id, call->getBeginLoc());
  const std::vector<Change> changes = receiver_first(unit_, call, {rule.to, rule.rule, rule.header});
  for (const Change& change : changes) entities_.add_use(id, change);
  if (changes.empty())
    entities_.add_obstacle(id, codes::TZC1006, macro_reason(unit_, call, "the call"), call->getBeginLoc());
}

/// tzc::publish(publisher, message) -> publisher.publish(message), when the publisher becomes one of TZC's.
void CallEffects::publish_by_method(const EntityId& id, const clang::CallExpr* call) {
  const std::vector<Change> changes = receiver_back(unit_, call, {"publish", "attached-publish", nullptr});
  for (const Change& change : changes) entities_.add_use(id, change);
  if (changes.empty())
    entities_.add_obstacle(id, codes::TZC1006, "the call comes from a macro", call->getBeginLoc());
}

CallEffect CallEffects::into_package(const EntityId& id, const Passed& passed) {
  const std::string name = passed.function->getNameAsString();
  if (passed.argument >= passed.function->getNumParams()) {
    entities_.add_obstacle(id, codes::TZC1001, "it is a variable argument of '" + name + "'", passed.where);
    return CallEffect::done;
  }
  const clang::ParmVarDecl* parameter = passed.function->getParamDecl(passed.argument);
  if (asks_for_type(unit_, passed.function, passed.argument))
    entities_.add_obstacle(id, entities_.is_message(id) ? codes::TZC1001 : codes::TZC1010,
                           "'" + name + "' asks for its type", passed.where);
  const EntityId received = entities_.declare(parameter);
  if (!received.empty())
    entities_.add_flow(id, received, {passed.where, "passed to '" + name + "'"});
  else if (!parameter->getType()->isScalarType())
    entities_.add_obstacle(id, codes::TZC1001, "it is converted when passed to '" + name + "'", passed.where);
  return CallEffect::done;
}

/// ImagePtr(new Image, release): the pointer gives it to the deleter in the end. A library's may name its type: boost::checked_delete<Image>.
void CallEffects::into_deleter(const EntityId& id, const Deleter& deleter) {
  if (!deleter.given) return;
  const clang::SourceLocation where = deleter.given->getBeginLoc();
  const clang::CXXRecordDecl* object = deleter.given->getType().getNonReferenceType()->getAsCXXRecordDecl();
  const bool is_own_object = object && unit_.source.in_package(object->getLocation());
  if (!deleter.function && !is_own_object) {
    const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(deleter.given->IgnoreParenImpCasts());
    if (name && qualified_name_of(name->getDecl()) == "boost::checked_delete")
      retype(entities_, id, name->template_arguments());
  } else if (!only_deletes(deleter)) {
    entities_.add_obstacle(id, codes::TZC1001, "its deleter does more than delete it, or is not seen", where);
  } else if (!deleter.is_generic) {
    into_package(id, {deleter.function, 0, where});
  }
}

CallEffect CallEffects::into_method(const EntityId& id, const clang::CXXMemberCallExpr* call,
                                    const Passed& passed) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  const std::string object = qualified_name_of(method->getParent());
  const std::string name = method->getNameAsString();
  if (is_publish(call)) return CallEffect::done;
  const std::optional<FillingCall> filling = filling_call(unit_, call);
  if (filling && filling->message == call->getArg(passed.argument)) {
    use_rule(id, call, *filling->rule);
    return CallEffect::done;
  }
  const MethodCall* rule = unit_.rules.find_method(object, name, written_arguments(call));
  if (rule && rule->role != MethodCall::Role::fills_message) return CallEffect::done;
  const clang::Expr* container = call->getImplicitObjectArgument();
  if (carried_by(container->getType(), unit_.rules)) {
    const FlowSources sources = sources_.of(container);
    for (const EntityId& target : sources.entities)
      entities_.add_flow(id, target, {call->getBeginLoc(), "stored by '" + name + "'"});
    if (entities_.is_message(id)) into_deleter(id, deleter_of(unit_, call));
    if (!sources.foreign) return CallEffect::done;
  }
  escape(id, object + "::" + name, call->getBeginLoc());
  return CallEffect::done;
}

/// A publisher that is bound to a function of the package is an argument of it. None: it is bound to nothing.
std::optional<CallEffect> CallEffects::into_bound(const EntityId& id, const clang::Expr* call,
                                                  unsigned argument) {
  if (entities_[id].role != EntityRole::publisher) return {};
  const std::optional<BoundCall> bound = bound_call(unit_, call);
  if (!bound || argument < bound->first) return {};
  return into_package(id, {bound->function, argument - bound->first, call->getBeginLoc()});
}

CallEffect CallEffects::into_swap(const EntityId& id, const clang::CallExpr* call) {
  for (const clang::Expr* argument : call->arguments())
    for (const EntityId& other : sources_.of(argument).entities)
      entities_.add_flow(id, other, {call->getBeginLoc(), "swapped"});
  return CallEffect::done;
}

/// Another pointer to it, whose type the call names.
CallEffect CallEffects::into_pointer_cast(const EntityId& id, const clang::CallExpr* call) {
  if (removes_const(call) && !serves_plain_field(unit_, call))
    entities_.add_obstacle(id, codes::TZC2002, "const is cast away from it", call->getBeginLoc());
  retype(entities_, id, written_arguments_of(call));
  return CallEffect::result;
}

CallEffect CallEffects::into_function(const EntityId& id, const clang::CallExpr* call, const Passed& passed) {
  const std::string name = qualified_name_of(passed.function);
  if (swaps(name)) return into_swap(id, call);
  if (entities_.is_message(id) && reads_any_message(name, call)) return CallEffect::done;
  if (const LibraryCall* rule = unit_.rules.find_call(name, passed.argument)) {
    use_rule(id, call, *rule);
    return CallEffect::done;
  }
  if (is_attached_publish(call)) {
    if (!entities_.is_message(id)) publish_by_method(id, call);
    return CallEffect::done;
  }
  if (unit_.declares(passed.function)) return into_package(id, passed);
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (method && method->getMethodDecl())
    return into_method(id, method, passed);  // not through a pointer to member
  if (passed.function->isInStdNamespace() && carried_by(call->getType(), unit_.rules)) {
    if (may_fill(passed.function, passed.argument)) entities_.add_data_use(id, passed.where);
    return CallEffect::result;
  }
  escape(id, name, passed.where);
  return CallEffect::done;
}

/// make_shared<Image>(image), make_shared<ImagePtr>(image), make_shared<Viewer>(image)
void CallEffects::into_new_object(const EntityId& id, const clang::CallExpr* call, unsigned argument) {
  if (const EntityId made = entities_.declare_temporary(call); !made.empty())
    return entities_.add_flow(id, made,
                              {call->getBeginLoc(), "copied into a new object", copies_message(call)});
  const clang::CXXRecordDecl* record = pointee_of(call->getType())->getAsCXXRecordDecl();
  const clang::CXXConstructorDecl* constructor = only_constructor(record, call->getNumArgs());
  const bool is_package = record && unit_.source.in_package(record->getLocation());
  if (unit_.declares(constructor))
    into_package(id, {constructor, argument, call->getBeginLoc()});
  else if (entities_[id].role == EntityRole::filter && !is_package)
    return;  // make_shared<Synchronizer>(left_, right_, 10): a library takes filters of any type, as a constructor that is called does
  else
    entities_.add_obstacle(id, entities_.is_message(id) ? codes::TZC1001 : codes::TZC1010,
                           "nothing shows which constructor takes it", call->getBeginLoc());
}

CallEffect CallEffects::of_call(const EntityId& id, const clang::CallExpr* call, unsigned argument) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) {
    const clang::FunctionDecl* candidate = only_candidate(call);
    if (entities_[id].role == EntityRole::publisher && unit_.declares(candidate))
      return into_package(id, {candidate, argument, call->getBeginLoc()});
    if (!call->isTypeDependent())
      entities_.add_obstacle(id, codes::TZC1001, "it is passed to a function that is not known here",
                             call->getBeginLoc());
    return CallEffect::done;
  }
  if (makes_object(call)) {
    into_new_object(id, call, argument);
    return CallEffect::done;
  }
  if (passes_through(function)) return CallEffect::result;
  if (recasts_pointer(unit_, call)) return into_pointer_cast(id, call);
  if (const auto effect = into_bound(id, call, argument)) return *effect;
  const bool is_member_operator =
      llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(function);
  if (is_member_operator && argument > 0) --argument;
  return into_function(id, call, {function, argument, call->getBeginLoc()});
}

CallEffect CallEffects::of_constructor(const EntityId& id, const clang::CXXConstructExpr* construct,
                                       unsigned argument) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  if (unit_.declares(constructor)) return into_package(id, {constructor, argument, construct->getBeginLoc()});
  if (entities_.is_message(id) && shows_its_end(construct))
    entities_.add_obstacle(id, codes::TZC1001, "the destructor of its owner shows when it is no longer held",
                           construct->getBeginLoc());
  if (entities_.is_message(id) && argument == 0) into_deleter(id, deleter_of(unit_, construct));
  if (carried_by(construct->getType(), unit_.rules)) return CallEffect::result;
  if (const auto effect = into_bound(id, construct, argument)) return *effect;
  escape(id, qualified_name_of(constructor->getParent()), construct->getBeginLoc());
  return CallEffect::done;
}

}  // namespace tzc::rewriter
