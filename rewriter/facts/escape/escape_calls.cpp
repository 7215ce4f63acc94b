// SPDX-License-Identifier: BSD-3-Clause
// The steps of a reference to data through calls: the table of known functions, functions of the package whose
// bodies are followed, and everything else, which is an escape.
#include <clang/AST/DeclTemplate.h>

#include "facts/escape/array_pointers.h"
#include "facts/escape/escape_climb.h"
#include "facts/escape/function_objects.h"
#include "facts/escape/range_types.h"
#include "facts/escape/type_questions.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/known_functions.h"
#include "facts/syntax/type_blind.h"

namespace tzc::rewriter {
namespace {

unsigned argument_index(llvm::ArrayRef<const clang::Expr*> arguments, const clang::Expr* argument) {
  for (unsigned i = 0; i < arguments.size(); ++i)
    if (arguments[i] == argument) return i;
  return static_cast<unsigned>(arguments.size());
}

const clang::LambdaExpr* lambda_in(const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  if (const auto* temporary = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr))
    expr = temporary->getSubExpr()->IgnoreParenImpCasts();
  if (const auto* copy = llvm::dyn_cast<clang::CXXConstructExpr>(expr); copy && copy->getNumArgs() == 1)
    return lambda_in(copy->getArg(0));
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(expr))
    return lambda_in(bound->getSubExpr());
  return llvm::dyn_cast<clang::LambdaExpr>(expr);
}

bool is_moved(const clang::Expr* expr) {
  return !expr->isLValue();
}

/// What a function of the array does: gives access to elements, leaves none behind, or is not known.
enum class ArrayMethod { access, nothing, exchange, unknown };
ArrayMethod array_method(const std::string& name) {
  static const std::set<std::string> access = {
      "data",  "begin", "end",    "cbegin", "cend",    "rbegin",       "rend",    "at",
      "front", "back",  "insert", "erase",  "emplace", "emplace_back", "crbegin", "crend"};
  static const std::set<std::string> nothing = {"size",     "empty",     "resize",        "reserve",
                                                "clear",    "push_back", "shrink_to_fit", "assign",
                                                "pop_back", "max_size"};
  if (access.count(name)) return ArrayMethod::access;
  if (nothing.count(name)) return ArrayMethod::nothing;
  return name == "swap" ? ArrayMethod::exchange : ArrayMethod::unknown;
}

/// stream << static_cast<const void*>(pointer), snprintf(text, size, "%p", pointer): the text can be made a pointer again.
bool writes_address(const std::string& function, clang::QualType type) {
  static const std::set<std::string> to_text = {"sprintf", "snprintf", "std::sprintf", "std::snprintf"};
  if (!type->isPointerType()) return false;
  if (function == "std::basic_ostream::operator<<") return type->isVoidPointerType();
  const clang::QualType pointee = type->getPointeeType().getCanonicalType().getUnqualifiedType();
  return to_text.count(function) != 0 && !pointee->isSpecificBuiltinType(clang::BuiltinType::Char_S) &&
         !pointee->isSpecificBuiltinType(clang::BuiltinType::Char_U);
}

}  // namespace

bool CallSteps::into_member(const clang::MemberExpr* member) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
  if (!method) {
    if (at_.how == Reference::array) return escape("is used in a way that is not understood");
    if (!member->getMemberDecl()->getType()->isReferenceType() && at_.how == Reference::view &&
        !may_hold_pointer(member->getType()))
      return done();
    const bool is_array = points_to_array(member->getMemberDecl()->getType());
    return go_on(member, is_array ? Reference::array : Reference::elements);
  }
  const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(view_.parent(member));
  if (!call) return escape("is used in a way that is not understood");
  return at_.how == Reference::array ? into_array_method(member, call) : into_element_method(call);
}

bool CallSteps::into_array_method(const clang::MemberExpr* member, const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  const std::string name = method->getNameAsString();
  switch (array_method(name)) {
    case ArrayMethod::access:
      at_.read_only = method->isConst();
      return call->getType()->isVoidType() ? done() : go_on(call, Reference::elements);
    case ArrayMethod::nothing:
      return done();
    case ArrayMethod::exchange:
      check_taken(call->getArg(0), true);
      return done();
    case ArrayMethod::unknown:
      analysis_.escape(at_.messages, "is not needed: '" + name + "' of the array depends on its type",
                       member->getMemberLoc(), false);
      return done();
  }
  return done();
}

namespace {

/// Whether a member function of a view may pass on where it points to: it is given another object to write that to, as swap and
/// cv::Mat::assignTo are.
bool passes_on(const clang::CXXMethodDecl* method) {
  return llvm::any_of(method->parameters(), [](const clang::ParmVarDecl* parameter) {
    const clang::QualType target = parameter->getType()->getPointeeType();
    return !target.isNull() && !target.isConstQualified() && may_hold_pointer(target);
  });
}

/// points[0] = points[1]
bool copies_value(const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return method && (method->isCopyAssignmentOperator() || method->isMoveAssignmentOperator()) &&
         !method->isUserProvided() && !may_hold_pointer(method->getThisType()->getPointeeType());
}

/// std::swap(data[0], data[3])
bool exchanges_values(const std::string& function, const clang::Expr* argument) {
  return (function == "std::swap" || function == "boost::swap") && !may_hold_pointer(argument->getType());
}

/// x != x.end() of sensor_msgs::PointCloud2Iterator
bool is_of_view(const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return method && is_view(method->getThisType()->getPointeeType());
}

}  // namespace

/// A function of an element, an iterator or a view.
bool CallSteps::into_element_method(const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  const std::string name = qualified_name_of(method);
  if (context_.unit.declares(method)) return escape("is passed to '" + name + "'");
  const Keeping keeping = context_.keeping_of(method, at_.messages);
  if (keeping == Keeping::nothing_and_result_is_new) return done();
  const clang::QualType object = method->getThisType()->getPointeeType();
  if (is_view(object)) check_callables(call);
  const bool is_known =
      (is_view(object) && !passes_on(method)) || keeping == Keeping::nothing || !may_hold_pointer(object);
  return is_known ? into_result(call) : escape("is passed to '" + name + "'");
}

bool CallSteps::into_result(const clang::Expr* call) {
  const clang::QualType type = call->getType();
  if (call->isPRValue() && !may_hold_pointer(type)) return done();
  if (points_to_array(at_.expr->getType()) && names_array(type)) return go_on(call, Reference::array);
  if (call->isGLValue() && type.getCanonicalType()->isRecordType() && is_view(type))
    return go_on(call, Reference::view);
  if (call->isGLValue() || type->isAnyPointerType()) return go_on(call, Reference::elements);
  return is_view(type) ? go_on(call, Reference::view) : escape("is part of a '" + type.getAsString() + "'");
}

bool CallSteps::into_object_operator(const clang::CXXOperatorCallExpr* call) {
  const clang::OverloadedOperatorKind op = call->getOperator();
  if (at_.how == Reference::array) {
    if (op == clang::OO_Subscript) {
      at_.read_only = llvm::cast<clang::CXXMethodDecl>(call->getDirectCallee())->isConst();
      return go_on(call, Reference::elements);
    }
    if (op != clang::OO_Equal) return call->isComparisonOp() ? done() : escape("is given to an operator");
    check_taken(call->getArg(1), false);
    return go_on(call);
  }
  if (op == clang::OO_Equal) return go_on(call);
  if (op == clang::OO_Call && !is_view(call->getArg(0)->getType())) return escape("is called");
  return into_result(call);
}

bool CallSteps::into_operator(const clang::CXXOperatorCallExpr* call) {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  const llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
  const unsigned index = argument_index(arguments, at_.expr);
  const bool is_method = llvm::isa_and_nonnull<clang::CXXMethodDecl>(callee);
  if (!callee || context_.unit.declares(callee)) return into_call(call);
  if (index == 0 && is_method) return into_object_operator(call);
  if (call->getOperator() == clang::OO_Equal) {
    check_pair(call->getArg(0)->getType());
    if (copies_value(callee)) return done();
    if (at_.how != Reference::array) return into_assignment(call->getArg(0));
    if (is_moved(at_.expr)) return escape("moves with the array", false);
    // std::any takes what it gets.
    return callee->getPrimaryTemplate() ? escape_to_question("'" + qualified_name_of(callee) + "'") : done();
  }
  const bool is_value = at_.expr->isPRValue() && !may_hold_pointer(at_.expr->getType());
  if (is_value || (call->isComparisonOp() && (callee->isInStdNamespace() || is_of_view(callee))))
    return done();
  const bool of_iterator = at_.how == Reference::elements
                               ? is_view(at_.expr->getType())
                               : at_.how == Reference::view && is_known_iterator(at_.expr->getType());
  return of_iterator ? into_result(call) : into_call(call);
}

bool CallSteps::escape_to_question(const std::string& function) {
  return escape("goes to " + function + ", which asks for its type", false);
}

/// An array, an iterator, or what is made of either: what is a class becomes a pointer.
bool CallSteps::changes_type() const {
  const clang::CXXRecordDecl* record = at_.expr->getType()->getAsCXXRecordDecl();
  return at_.how == Reference::array || is_made_of_array(at_.expr->getType()) ||
         (record && record->getIdentifier() && record->getName().ends_with_insensitive("iterator"));
}

bool CallSteps::into_call(const clang::CallExpr* call) {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (call->getCallee() == at_.expr) return escape("is called");
  if (!callee) return escape("is passed to a function that is not known here");
  const llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
  unsigned index = argument_index(arguments, at_.expr);
  const bool shifted = llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(callee);
  if (shifted && index > 0) --index;
  const std::string name = qualified_name_of(callee);
  if (at_.how == Reference::array && index >= callee->getNumParams())
    return escape("is a variable argument of '" + name + "'");
  if (at_.how == Reference::array && (name == "std::move" || name == "std::forward"))
    return call->isXValue() && !call->getType().isConstQualified() ? escape("moves with the array", false)
                                                                   : go_on(call);
  if (passes_through(callee) && name != "std::ref" && name != "std::cref" && name != "boost::ref" &&
      name != "boost::cref")
    return go_on(call);
  if (context_.unit.declares(callee) && changes_type() && !is_type_blind(context_.unit, callee, index))
    return escape_to_question(is_lambda(callee) ? "a closure" : "'" + name + "'");
  if (context_.unit.declares(callee) && analysis_.follow(callee, index, at_)) return done();
  if (at_.how == Reference::elements && exchanges_values(name, at_.expr)) return done();
  const Keeping keeping = context_.keeping_of(callee, at_.messages);
  if (keeping != Keeping::unknown) return into_known_call(call, keeping != Keeping::nothing);
  // What takes a std::vector does not take the ported array: the compiler refuses it. void* takes both.
  const bool own = context_.unit.declares(callee);
  if (!own && at_.how == Reference::array && !callee->getPrimaryTemplate() &&
      names_array(callee->getParamDecl(index)->getType()))
    return done();
  return escape_into_call("is passed to '" + name + "'");
}

/// A pointer to an array may be made a void* within a template, as std::map<int, void*>::insert does with a pair.
bool CallSteps::escape_into_call(const std::string& how) {
  return escape(how, at_.how != Reference::array && !points_to_array(at_.expr->getType()));
}

/// std::pair<void*, int>: the conversion is in its constructor, so no step of the climb shows it.
void CallSteps::check_pair(clang::QualType made) {
  const clang::QualType from = at_.expr->getType();
  if (is_pair(made) && points_to_array(from) && !points_to_array(made)) escape_as(made);
}

namespace {

/// An object of a class, before it is passed as its base.
clang::QualType class_given(const clang::Expr* argument) {
  const clang::QualType given = argument->IgnoreParenImpCasts()->getType();
  return given->isRecordType() ? given : argument->getType();
}

/// What these do with elements, the function object that they are given does; its result is a new value, or it returned an element,
/// which is an escape. So it does not matter of what class the elements of other ranges are.
bool calls_operation_only(const clang::FunctionDecl* function) {
  static const std::set<std::string> known = {"std::transform", "std::for_each", "std::for_each_n"};
  return known.count(qualified_name_of(function)) != 0;
}

bool walks_elements(clang::QualType type) {
  return type->isObjectPointerType() || is_known_iterator(type);
}

}  // namespace

/// A known function keeps nothing itself, but it may copy a pointer to where another argument points.
bool CallSteps::may_store_pointer(const clang::CallExpr* call) {
  const clang::QualType type = at_.expr->IgnoreParenCasts()->getType().getCanonicalType();
  if (type->isPointerType() && may_hold_pointer(type->getPointeeType()) && !type->isVoidPointerType())
    return true;
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::CXXRecordDecl* owner = method ? method->getRecordDecl() : nullptr;
  if (owner && is_owner_class(qualified_name_of(owner)) &&
      may_hold_pointer(owner->getASTContext().getRecordType(owner)))
    return true;
  return llvm::any_of(call->arguments(), [&](const clang::Expr* argument) {
    return argument != at_.expr && reaches_pointers(argument->IgnoreParenCasts()->getType());
  });
}

/// messages.emplace_back(image.data): the type of the container's elements, and not the function, says what is made of the array.
bool CallSteps::makes_element(const clang::CallExpr* call) const {
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (!method || !method->getMethodDecl() || !method->getMethodDecl()->getPrimaryTemplate()) return false;
  const clang::QualType element = named_in(method->getRecordDecl(), "value_type");
  return element.isNull() || !is_data_array(element);
}

bool CallSteps::into_known_call(const clang::CallExpr* call, bool result_is_new) {
  if (at_.how != Reference::array && may_store_pointer(call))
    return escape_into_call("may be stored by a call");
  if (at_.how == Reference::array && makes_element(call))
    return escape_to_question("'" + qualified_name_of(call->getDirectCallee()) + "'");
  if (writes_address(qualified_name_of(call->getDirectCallee()), at_.expr->getType()))
    return escape("is written down as a text");
  check_callables(call);
  if (result_is_new) return done();
  if (at_.how == Reference::array && call->isGLValue() && is_data_array(call->getType())) return go_on(call);
  if (at_.how == Reference::array) at_.read_only = at_.read_only || at_.expr->getType().isConstQualified();
  return into_result(call);
}

/// What a library is given beside the elements may lead them to code of the package (function_objects.h).
void CallSteps::check_callables(const clang::CallExpr* call) {
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::Expr* object = method ? method->getImplicitObjectArgument() : nullptr;
  if (object && check_passed(object->getType())) return;
  const bool has_operation = calls_operation_only(call->getDirectCallee());
  for (const clang::Expr* argument : call->arguments()) {
    if (const clang::LambdaExpr* lambda = lambda_in(argument))
      hold_parameters(lambda);
    else if (argument != at_.expr && !(has_operation && walks_elements(argument->getType())) &&
             !check_passed(argument->getType()))
      check_passed(class_given(argument));
  }
}

/// Whether a library that is given an object of the type may pass elements to code of the package, which is an escape.
bool CallSteps::check_passed(clang::QualType type) {
  const std::string taker = passes_elements_to(context_.unit, type, element_type(at_.expr->getType()));
  if (!taker.empty()) escape("is passed to " + taker);
  return !taker.empty();
}

void CallSteps::hold_parameters(const clang::LambdaExpr* lambda) {
  if (lambda->isGenericLambda()) {
    escape("is passed to a generic lambda");
    return;
  }
  for (const clang::ParmVarDecl* parameter : lambda->getCallOperator()->parameters())
    if (parameter->getType()->isReferenceType() || may_hold_pointer(parameter->getType()))
      analysis_.hold(view_, {parameter, Reference::elements, at_.read_only, at_.messages});
}

/// std::vector<uint8_t> pixels = image.data; is one in the port, too. auto pixels = image.data; is not.
bool CallSteps::into_copy(const clang::CXXConstructExpr* construct) {
  if (construct->getConstructor()->isMoveConstructor() && !is_copy())
    return escape("moves with the array", false);
  const bool is_named = llvm::isa<clang::CXXTemporaryObjectExpr>(construct);
  return is_named && !gives_type(construct->getType()) ? done() : go_on(construct);
}

bool CallSteps::into_construction(const clang::CXXConstructExpr* construct) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  const clang::CXXRecordDecl* record = constructor->getParent();
  const clang::QualType type = construct->getType();
  const llvm::ArrayRef<const clang::Expr*> arguments(construct->getArgs(), construct->getNumArgs());
  if (is_data_array(type) && at_.how == Reference::array) return into_copy(construct);
  if (constructor->isCopyOrMoveConstructor() && !context_.unit.declares(constructor))
    return may_hold_pointer(type) ? go_on(construct) : done();
  check_pair(type);
  if (is_view(type)) return go_on(construct, Reference::view);
  if (context_.unit.declares(constructor)) {
    const unsigned index = argument_index(arguments, at_.expr);
    if (changes_type() && !is_type_blind(context_.unit, constructor, index))
      return escape_to_question("'" + record->getNameAsString() + "'");
    const bool followed = analysis_.follow(constructor, index, at_);
    return followed ? done() : escape("is passed to '" + record->getNameAsString() + "'");
  }
  if (is_owner_class(qualified_name_of(record)) && !may_hold_pointer(type)) {
    check_passed(type);
    return done();
  }
  return escape("is kept in a '" + qualified_name_of(record) + "'");
}

/// Elements of a vector that become the array's stay in place with a vector; with shared memory they do not.
void CallSteps::check_taken(const clang::Expr* value, bool swapped) {
  if (!swapped && !is_moved(value->IgnoreImpCasts())) return;  // copied
  const clang::Expr* written = value->IgnoreParenImpCasts();
  while (const auto* call = llvm::dyn_cast<clang::CallExpr>(written)) {
    if (!passes_through(call->getDirectCallee())) break;
    written = call->getArg(0)->IgnoreParenImpCasts();
  }
  if (written->isPRValue() || llvm::isa<clang::MaterializeTemporaryExpr>(written)) return;  // a new vector
  if (const auto* array = llvm::dyn_cast<clang::MemberExpr>(written);
      array && is_data_array(array->getType())) {
    const std::vector<EntityId> other = context_.sources_of(array->getBase());
    for (const EntityId& mine : at_.messages)
      for (const EntityId& key : other)
        context_.entities.add_flow(mine, key, {value->getBeginLoc(), "array exchanged"});
    if (!other.empty()) return;
  }
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(written);
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  if (variable && variable->isLocalVarDeclOrParm() && !variable->isStaticLocal() &&
      !variable->getType()->isReferenceType())
    return analysis_.take(view_, variable, value, at_.messages);
  analysis_.escape(at_.messages,
                   "may exist: '" + context_.unit.source.text(written->getSourceRange()) +
                       "' gives the array its elements",
                   value->getBeginLoc(), false);
}

}  // namespace tzc::rewriter
