// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/array_casts.h"

#include "facts/flow/foreign_casts.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned deepest = 12;
constexpr const char* loses_its_const = "const is cast away from an array that may be one of this message's";

/// What lies behind all pointers and references, smart ones, too.
clang::QualType behind_pointers(clang::QualType type) {
  type = type.getNonReferenceType();
  for (clang::QualType next = pointee_of(type); !next.isNull(); next = pointee_of(type)) type = next;
  return type;
}

bool is_array(clang::QualType type) {
  return !type->isDependentType() && is_data_array(type);
}

/// Refers to an array, and is none itself.
bool refers_to_array(clang::QualType type) {
  return (type->isReferenceType() || !pointee_of(type).isNull()) && is_array(behind_pointers(type));
}

/// The body is the one that runs, so the search for escapes goes on in it.
bool is_followed_into(const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return function->isDefined() && !function->getTemplateInstantiationPattern() &&
         !(method && method->isVirtual());
}

std::string parameter_name(const clang::FunctionDecl* function, unsigned index) {
  return usr_of(pattern_of(function)) + "#" + std::to_string(index);
}

/// In a function, where the search for escapes begins; not in a global's initializer.
bool is_in_function(const Unit& unit, const clang::Stmt* stmt) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *stmt))
    if (const auto* function = node.get<clang::FunctionDecl>(); function && !is_lambda(function)) return true;
  return false;
}

/// rows_[i], rows_.front(): the containers that have their elements themselves, so that an array in them is no message's.
bool is_element(const clang::CallExpr* call) {
  static const std::set<std::string> containers = {"std::vector", "std::deque", "std::list",
                                                   "std::array",  "std::map",   "std::unordered_map"};
  static const std::set<std::string> names = {"at", "front", "back"};
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call->getDirectCallee());
  if (!method || containers.count(qualified_name_of(method->getParent())) == 0) return false;
  return method->getOverloadedOperator() == clang::OO_Subscript ||
         (method->getIdentifier() && names.count(method->getName().str()) != 0);
}

/// A name that always means what it is made of.
bool is_alias(const clang::VarDecl* variable) {
  const bool stays = variable->getType()->isReferenceType() || variable->getType().isConstQualified();
  return stays && variable->isLocalVarDecl() && !variable->isStaticLocal() && !variable->isInitCapture() &&
         !variable->isCXXForRangeDecl() && !llvm::isa<clang::DecompositionDecl>(variable) &&
         variable->getInit();
}

}  // namespace

std::string ArrayCastCollector::origin(const clang::Expr* array, unsigned depth) {
  array = array->IgnoreImplicit()->IgnoreParenImpCasts();
  if (depth > deepest) return unknown_array;
  const bool is_new = array->isPRValue() && is_array(array->getType());
  if (is_new || llvm::isa<clang::CXXNewExpr>(array)) return own_array;
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(array)) return origin_of_name(name, depth);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(array)) return origin_of_member(member);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(array))
    return is_array(call->getType()) && is_element(call) ? own_array : unknown_array;
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(array))
    return op->getOpcode() == clang::UO_Deref || op->getOpcode() == clang::UO_AddrOf
               ? origin(op->getSubExpr(), depth + 1)
               : unknown_array;
  const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(array);
  const bool is_known =
      cast && refers_to_array(cast->getTypeAsWritten()) &&
      unit_.ast().hasSameUnqualifiedType(behind_pointers(cast->getTypeAsWritten()),
                                         behind_pointers(cast->getSubExprAsWritten()->getType()));
  return is_known ? origin(cast->getSubExprAsWritten(), depth + 1) : unknown_array;
}

/// What a closure captured is not followed into it everywhere.
std::string ArrayCastCollector::origin_of_name(const clang::DeclRefExpr* name, unsigned depth) {
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
  if (!variable) return unknown_array;
  if (is_array(variable->getType()) && !variable->getType()->isReferenceType()) return own_array;
  std::string from = unknown_array;
  if (const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(variable))
    from = origin_of_parameter(parameter);
  else if (is_alias(variable))
    from = origin(variable->getInit(), depth + 1);
  return from != own_array && name->refersToEnclosingVariableOrCapture() ? unknown_array : from;
}

/// All that calls the function is seen, unless its address is taken (ThreadFacts::addressed): libraries' templates may call public methods,
/// operators and constructors by their names, and what other packages may include is theirs to call, too.
std::string ArrayCastCollector::origin_of_parameter(const clang::ParmVarDecl* parameter) const {
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(parameter->getDeclContext());
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(function);
  const bool stays = parameter->getType()->isReferenceType() || parameter->getType().isConstQualified();
  if (!function || !stays || !unit_.declares(function) || unit_.exports(function)) return unknown_array;
  if (function->isOverloadedOperator() || llvm::isa<clang::CXXConstructorDecl>(function) ||
      is_lambda(function))
    return unknown_array;
  if (method && (method->isVirtual() || method->getAccess() == clang::AS_public)) return unknown_array;
  return parameter_name(function, parameter->getFunctionScopeIndex());
}

std::string ArrayCastCollector::origin_of_member(const clang::MemberExpr* member) {
  const clang::ValueDecl* decl = member->getMemberDecl();
  if (!llvm::isa<clang::FieldDecl, clang::VarDecl>(decl) || decl->getType()->isReferenceType() ||
      !is_array(member->getType()))
    return unknown_array;
  const clang::QualType base = member->getBase()->getType();
  if (!message_of(member->isArrow() ? base->getPointeeType() : base)) return own_array;
  const FlowSources sources = sources_.of(member->getBase());
  return sources.entities.empty() || sources.foreign || !is_in_function(unit_, member) ? unknown_array
                                                                                       : followed_array;
}

void ArrayCastCollector::cast(const clang::CastExpr* cast) {
  if (!unit_.source.in_package(cast->getBeginLoc()) || cast->isTypeDependent()) return;
  const clang::Expr* operand = cast->getSubExprAsWritten();
  if (operand->isTypeDependent() || is_null(unit_, operand)) return;
  const auto* written = llvm::dyn_cast<clang::ExplicitCastExpr>(cast);
  const bool loses_const = written && removes_const(written);
  if (!loses_const && !keeps_bits(cast) && cast->getCastKind() != clang::CK_PointerToIntegral) return;
  const clang::QualType to = written ? written->getTypeAsWritten() : cast->getType();
  convert({operand->getType(), to, operand}, loses_const, cast->getBeginLoc());
}

/// A void* that is not const can lead to a const array only where one lost its type: there its const was lost, or is kept by nothing but the
/// pointer's own type. User data in a program in which none does, as what libcurl appends to, is no message's.
void ArrayCastCollector::convert(const Conversion& conversion, bool removes_const,
                                 clang::SourceLocation where) {
  const clang::QualType from = behind_pointers(conversion.from), to = behind_pointers(conversion.to);
  const bool was_array = is_array(from), becomes_array = refers_to_array(conversion.to);
  const bool is_pointer = !pointee_of(conversion.to).isNull() || conversion.to->isIntegerType() ||
                          conversion.to->isReferenceType();
  if (was_array && !becomes_array && is_pointer && !is_array(to)) {
    if (origin(conversion.operand) != own_array) found_.untyped_arrays.push_back(unit_.location(where));
    return;
  }
  if (!becomes_array) return;
  const bool changes = was_array && !unit_.ast().hasSameUnqualifiedType(from, to);
  if (!changes && !(removes_const && !to.isConstQualified()) && (was_array || to.isConstQualified())) return;
  ArrayCast cast;
  cast.from = was_array ? origin(conversion.operand) : unknown_array;
  if (changes && cast.from != own_array) cast.from = unknown_array;  // the search for escapes need not go on
  cast.elements = {element_name(first_argument(to))};
  if (was_array) cast.elements.insert(element_name(first_argument(from)));
  cast.untyped = !was_array;
  const std::string untyped = "an array that may be one of this message's is " + cast_from(conversion.from);
  cast.obstacle.reason = was_array ? loses_its_const : untyped;
  add(std::move(cast), where);
}

void ArrayCastCollector::add(ArrayCast cast, clang::SourceLocation where) {
  if (cast.from == own_array || cast.from == followed_array || !unit_.source.in_package(where)) return;
  cast.obstacle.code = codes::TZC2002;
  cast.obstacle.where = unit_.location(where);
  found_.array_casts.push_back(std::move(cast));
}

/// Of a union: another member may have been given a pointer to a const one.
void ArrayCastCollector::member(const clang::MemberExpr* member) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl());
  if (!field || !field->getParent()->isUnion() || !refers_to_array(field->getType())) return;
  const clang::QualType array = behind_pointers(field->getType());
  if (!array.isConstQualified())
    add({{element_name(first_argument(array))}, unknown_array, false, {{}, loses_its_const, {}}},
        member->getMemberLoc());
}

/// va_arg(list, std::vector<float>*)
void ArrayCastCollector::variable_argument(const clang::VAArgExpr* argument) {
  if (!refers_to_array(argument->getType())) return;
  const clang::QualType array = behind_pointers(argument->getType());
  if (!array.isConstQualified())
    add({{element_name(first_argument(array))}, unknown_array, false, {{}, loses_its_const, {}}},
        argument->getBeginLoc());
}

void ArrayCastCollector::call(const clang::CallExpr* call) {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (!callee || call->isTypeDependent() || !unit_.source.in_package(call->getBeginLoc())) return;
  if (casts_pointer(callee) && call->getNumArgs() == 1)
    return convert({call->getArg(0)->getType(), call->getType(), call->getArg(0)}, removes_const(call),
                   call->getBeginLoc());
  if (!unit_.declares(callee) || llvm::isa<clang::CXXOperatorCallExpr>(call)) return;
  for (unsigned i = 0; i < callee->getNumParams() && i < call->getNumArgs(); ++i) {
    if (!refers_to_array(callee->getParamDecl(i)->getType())) continue;
    const std::string from = origin(call->getArg(i));
    found_.given_arrays[parameter_name(callee, i)].insert(
        from == own_array || is_followed_into(callee) ? from : unknown_array);
  }
}

}  // namespace tzc::rewriter
