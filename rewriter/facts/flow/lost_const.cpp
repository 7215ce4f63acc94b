// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/lost_const.h"

#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned deepest_type = 6;

bool is_event(const clang::CXXRecordDecl* record) {
  return record && qualified_name_of(record) == "ros::MessageEvent";
}

/// M of a ros::MessageEvent<M>, however deep in pointers and containers; null: there is none.
clang::QualType message_of_event(clang::QualType type, unsigned depth = 0) {
  if (type.isNull() || depth > deepest_type) return {};
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isPointerType()) return message_of_event(type->getPointeeType(), depth + 1);
  if (const clang::ArrayType* array = type->getAsArrayTypeUnsafe())
    return message_of_event(array->getElementType(), depth + 1);
  const auto* made =
      llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
  if (!made) return {};
  if (is_event(made)) return first_argument(made);
  std::vector<clang::TemplateArgument> arguments;
  for (const clang::TemplateArgument& argument : made->getTemplateArgs().asArray()) {
    if (argument.getKind() != clang::TemplateArgument::Pack) arguments.push_back(argument);
    if (argument.getKind() == clang::TemplateArgument::Pack)
      arguments.insert(arguments.end(), argument.pack_begin(), argument.pack_end());
  }
  for (const clang::TemplateArgument& argument : arguments) {
    if (argument.getKind() != clang::TemplateArgument::Type) continue;
    if (const clang::QualType found = message_of_event(argument.getAsType(), depth + 1); !found.isNull())
      return found;
  }
  return {};
}

/// event.nonConstWillCopy()
bool asks_event(const clang::Expr* expr) {
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr);
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  return method && is_event(method->getParent()) && method->getNameAsString() == "nonConstWillCopy";
}

/// Whether the answer is yes for events that copy.
bool keeps_copying(const Unit& unit, const clang::Expr* answer) {
  answer = answer->IgnoreImplicit()->IgnoreParenImpCasts();
  bool value = false;
  if (answer->isValueDependent()) return true;  // the instances of the template tell
  if (asks_event(answer) || (answer->EvaluateAsBooleanCondition(value, unit.ast()) && value)) return true;
  const auto* op = llvm::dyn_cast<clang::BinaryOperator>(answer);
  if (!op || !op->isLogicalOp()) return false;
  const bool left = keeps_copying(unit, op->getLHS()), right = keeps_copying(unit, op->getRHS());
  return op->getOpcode() == clang::BO_LOr ? left || right : left && right;
}

template <class Call>
bool gives_out_itself(const Unit& unit, const Call* call, const clang::FunctionDecl* function) {
  for (unsigned i = 0; i < call->getNumArgs() && i < function->getNumParams(); ++i)
    if (function->getParamDecl(i)->getType()->isBooleanType() && !keeps_copying(unit, call->getArg(i)))
      return true;
  return false;
}

/// What a library's template passes on, behind an event or a pointer as the event's constructors have it. A number in a pair is no answer.
bool passes_on_no(const Unit& unit, const clang::CallExpr* call) {
  const llvm::StringRef name = call->getDirectCallee()->getName();
  const bool holds_values = name == "make_pair" || name == "make_tuple";
  bool has_message = false;
  for (const clang::Expr* argument : call->arguments()) {
    const clang::QualType type = argument->IgnoreImplicit()->IgnoreParenImpCasts()->getType();
    const bool answers = holds_values ? type->isBooleanType() : type->isIntegralOrEnumerationType();
    if (has_message && answers && !keeps_copying(unit, argument)) return true;
    has_message |= carried_by(argument->getType(), unit.rules).has_value();
  }
  return false;
}

template <class Call>
UncopiedEvent event_of(const Unit& unit, clang::QualType message, const Call* call) {
  for (const clang::Expr* argument : call->arguments())
    if (carried_by(argument->getType(), unit.rules)) return {message, argument};
  return {message, nullptr};
}

/// Of what a library's template makes or fills; null: of no event.
clang::QualType message_of_made_event(const clang::CallExpr* call) {
  if (const clang::QualType made = message_of_event(call->getType()); !made.isNull()) return made;
  const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  return member ? message_of_event(member->getImplicitObjectArgument()->getType()) : clang::QualType();
}

const clang::FunctionProtoType* function_in(clang::QualType type) {
  type = type.getNonReferenceType();
  if (const auto* member = type->getAs<clang::MemberPointerType>()) type = member->getPointeeType();
  if (type->isPointerType()) type = type->getPointeeType();
  return type->getAs<clang::FunctionProtoType>();
}

/// What it takes and returns; whose member it is, and what it throws, does not matter.
std::vector<clang::QualType> signature_of(const clang::FunctionProtoType* function) {
  std::vector<clang::QualType> types{function->getReturnType().getCanonicalType()};
  for (const clang::QualType parameter : function->param_types())
    types.push_back(parameter.getCanonicalType());
  return types;
}

bool is_writable(clang::QualType message) {
  return !message.isNull() && !message.isConstQualified() && message_of(message);
}

bool may_be_written_to(clang::QualType parameter) {
  const bool by_reference = parameter->isReferenceType() && is_writable(parameter.getNonReferenceType());
  return by_reference || is_writable(pointee_of(parameter)) || is_writable(message_of_event(parameter));
}

}  // namespace

std::optional<UncopiedEvent> uncopied_event(const Unit& unit, const clang::CXXConstructExpr* construct) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  // A class of the package that has taken over the constructors of its base.
  if (const clang::CXXConstructorDecl* inherited = constructor->getInheritedConstructor().getConstructor())
    constructor = inherited;
  if (!is_event(constructor->getParent()) || !gives_out_itself(unit, construct, constructor)) return {};
  return event_of(
      unit, first_argument(llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(constructor->getParent())),
      construct);
}

std::optional<UncopiedEvent> uncopied_event(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || call->isTypeDependent() || llvm::isa<clang::CXXOperatorCallExpr>(call)) return {};
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method && is_event(method->getParent())) {
    if (!gives_out_itself(unit, call, function)) return {};
    return event_of(
        unit, first_argument(llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(method->getParent())),
        call);
  }
  if (!function->getIdentifier() || !function->getPrimaryTemplate() || unit.declares(function)) return {};
  const clang::QualType message = message_of_made_event(call);
  if (message.isNull() || !passes_on_no(unit, call)) return {};
  return event_of(unit, message, call);
}

std::vector<clang::QualType> messages_of_cast_function(const Unit& unit,
                                                       const clang::ExplicitCastExpr* cast) {
  const clang::FunctionProtoType* before = function_in(cast->getSubExprAsWritten()->getType());
  const clang::FunctionProtoType* after = function_in(cast->getType());
  // boost::function<...>(callback) makes an object that calls the function as it is.
  if (!before || !(after || cast->getType()->isPointerType() || cast->getType()->isIntegerType())) return {};
  std::vector<clang::QualType> types = signature_of(before);
  if (after) {
    const std::vector<clang::QualType> others = signature_of(after);
    if (types == others) return {};
    types.insert(types.end(), others.begin(), others.end());
  } else {
    llvm::erase_if(types, [](clang::QualType type) { return !may_be_written_to(type); });
  }
  llvm::erase_if(types, [&](clang::QualType type) { return !carried_by(type, unit.rules); });
  return types;
}

}  // namespace tzc::rewriter
