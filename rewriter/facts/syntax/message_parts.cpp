// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/message_parts.h"

#include <llvm/ADT/StringExtras.h>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/element_names.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned max_depth = 12;

/// The part of an expression that denotes the same object; null: it is no such expression.
const clang::Expr* same_object(const clang::Expr* expr) {
  if (const clang::Expr* operand = converted(expr)) return operand;
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr))
    return op->getOpcode() == clang::UO_Deref || op->getOpcode() == clang::UO_AddrOf ||
                   op->isIncrementDecrementOp()  // *at++: one of the messages that it leads to
               ? op->getSubExpr()
               : nullptr;
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
  if (!made || pointee_of(made->getType()).isNull()) return nullptr;
  const unsigned count = written_arguments(made);
  if (count == 2 && is_message_or_pointer(made->getArg(1)->getType()))
    return made->getArg(1);  // ImagePtr(owner, &owner->image)
  return count == 1 ? made->getArg(0) : nullptr;
}

/// `second` of what a map has.
bool is_part_of_pair(const clang::ValueDecl* member) {
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(member->getDeclContext());
  return record && qualified_name_of(record) == "std::pair";
}

/// Whether the class, or what it derives from, has an operator*.
bool has_dereference(const clang::CXXRecordDecl* record) {
  if (!record || !record->hasDefinition()) return false;
  const clang::DeclarationName star =
      record->getASTContext().DeclarationNames.getCXXOperatorName(clang::OO_Star);
  return !record->lookup(star).empty() ||
         llvm::any_of(record->bases(), [](const clang::CXXBaseSpecifier& base) {
           return has_dereference(base.getType()->getAsCXXRecordDecl());
         });
}

/// Also by pointer.reset(...) or swap.
bool may_be_set(const FunctionView& view, const clang::DeclRefExpr* use) {
  const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(view.parent(use));
  return is_assigned(view.parent(use), use) ||
         (member && !member->isArrow() && member->getMemberDecl()->getDeclName().isIdentifier() &&
          (member->getMemberDecl()->getName() == "reset" || member->getMemberDecl()->getName() == "swap"));
}

}  // namespace

bool is_stock_or_twin(clang::QualType type) {
  return message_of(type.getNonReferenceType()).has_value() ||
         twin_message_of(type.getNonReferenceType()).has_value();
}

bool is_stock_or_twin_array(clang::QualType type) {
  if (is_data_array(type.getNonReferenceType())) return true;
  const clang::CXXRecordDecl* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return record && qualified_name_of(record) == "tzc::Array";
}

bool is_pointer_to_array(clang::QualType type) {
  const clang::QualType pointee = pointee_of(type);
  return !pointee.isNull() && is_stock_or_twin_array(pointee);
}

bool is_name_of_array(clang::QualType type) {
  return is_pointer_to_array(type) || (type->isReferenceType() && is_stock_or_twin_array(type));
}

bool is_message_or_pointer(clang::QualType type) {
  const clang::QualType pointee = pointee_of(type);
  return is_stock_or_twin(pointee.isNull() ? type : pointee);
}

bool is_iterator(clang::QualType type) {
  return has_dereference(type.getNonReferenceType()->getAsCXXRecordDecl()) && !is_message_or_pointer(type) &&
         !leads_to_messages(type) && message_reached(type);
}

bool names_messages(clang::QualType type) {
  return !is_message_or_pointer(type) && !is_iterator(type) && message_reached(type) && !holds_messages(type);
}

bool is_list_of_messages(const clang::Expr* expr) {
  const auto* list = llvm::dyn_cast<clang::InitListExpr>(expr);
  return list && list->getNumInits() > 0 && is_message_or_pointer(list->getInit(0)->getType());
}

bool is_name_of_message(clang::QualType type) {
  const bool leads_elsewhere =
      type->isReferenceType() || !pointee_of(type).isNull() || is_iterator(type) || names_messages(type);
  return leads_elsewhere && message_reached(type);
}

std::vector<const clang::Expr*> message_sources(const clang::CallExpr* call) {
  std::vector<const clang::Expr*> sources;
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call))
    sources.push_back(method->getImplicitObjectArgument());
  sources.insert(sources.end(), call->arg_begin(), call->arg_end());
  llvm::erase_if(sources, [](const clang::Expr* source) { return !message_reached(source->getType()); });
  return sources;
}

bool returns_message(const clang::FunctionDecl* function) {
  return is_name_of_array(function->getReturnType()) || is_message_or_pointer(function->getReturnType());
}

bool is_array_of_data_parts(clang::QualType type) {
  const auto* templated = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(
      type.getNonReferenceType()->getAsCXXRecordDecl());
  if (!templated || qualified_name_of(templated) != "std::vector") return false;
  const clang::QualType element = templated->getTemplateArgs().get(0).getAsType();
  const std::optional<MessageType> stock = message_of(element);
  return stock ? stock->has_data_part : twin_message_of(element).has_value();
}

const clang::Expr* copied_message(const clang::Expr* made) {
  const auto is_original = [](const clang::Expr* argument) {
    return argument->isLValue() && is_stock_or_twin(argument->getType());
  };
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(made)) {
    const bool copies = written_arguments(construct) == 1 && is_stock_or_twin(construct->getType()) &&
                        is_original(construct->getArg(0));
    return copies ? construct->getArg(0) : nullptr;
  }
  const auto* call = llvm::dyn_cast<clang::CallExpr>(made);
  if (!call || !makes_object(call) || !is_message_or_pointer(call->getType())) return nullptr;
  const auto original = llvm::find_if(call->arguments(), is_original);
  return original == call->arguments().end() ? nullptr : *original;
}

const clang::Stmt* use_of(const FunctionView& view, const clang::Stmt* mention) {
  const clang::Stmt* around = view.parent(mention);
  while (llvm::isa_and_nonnull<clang::ParenExpr, clang::ImplicitCastExpr>(around))
    around = view.parent(around);
  return around;
}

bool is_only_read(const FunctionView& view, const clang::Expr* array) {
  if (array->getType().isConstQualified()) return true;
  const auto cast_around = [&](const clang::Stmt* inner) {
    return llvm::dyn_cast_or_null<clang::ImplicitCastExpr>(view.parent(inner));
  };
  for (const clang::ImplicitCastExpr* cast = cast_around(array); cast; cast = cast_around(cast))
    if (cast->getType().isConstQualified()) return true;
  return false;
}

MessagePart MessageParts::root_of(const clang::ValueDecl* decl) const {
  if (const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(decl)) {
    const auto* function = llvm::dyn_cast_or_null<clang::FunctionDecl>(parameter->getDeclContext());
    if (function == view_.function())
      return parameter_root(usr_of(pattern_of(function)), parameter->getFunctionScopeIndex());
  }
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  if (llvm::isa<clang::FieldDecl>(decl) || (variable && variable->hasGlobalStorage())) return usr_of(decl);
  return "local " + std::to_string(unit_.offset(decl->getLocation())) + decl->getNameAsString();
}

/// A reference, or a pointer that is never given another value.
bool MessageParts::is_another_name(const clang::VarDecl* variable) const {
  if (!variable->getInit() || !variable->isLocalVarDecl() || variable->isStaticLocal()) return false;
  if (variable->getType()->isReferenceType()) return true;
  if (pointee_of(variable->getType()).isNull()) return false;
  return llvm::none_of(view_.uses(variable),
                       [&](const clang::DeclRefExpr* use) { return may_be_set(view_, use); });
}

/// auto& [image, count] = part_; of a copy, each part is an object of its own.
MessagePart MessageParts::of_binding(const clang::BindingDecl* binding, unsigned depth) const {
  const auto* whole = llvm::dyn_cast<clang::VarDecl>(binding->getDecomposedDecl());
  if (!whole || !whole->getType()->isReferenceType()) return root_of(binding);
  if (const clang::VarDecl* held = binding->getHoldingVar())
    return held->getInit() ? part_of(held->getInit(), depth + 1) : MessagePart();
  return binding->getBinding() ? part_of(binding->getBinding(), depth + 1) : MessagePart();
}

/// for (auto& image : images_); null: it is no such variable.
const clang::Expr* MessageParts::range_of(const clang::VarDecl* variable) const {
  const bool is_name = variable->getType()->isReferenceType() || variable->getType()->isPointerType();
  if (!variable->isCXXForRangeDecl() || !is_name) return nullptr;
  for (const clang::Stmt* stmt : view_.statements())
    if (const auto* loop = llvm::dyn_cast<clang::CXXForRangeStmt>(stmt))
      if (loop->getLoopVariable() == variable) return loop->getRangeInit();
  return nullptr;
}

MessagePart MessageParts::of_name(const clang::DeclRefExpr* name, unsigned depth) const {
  if (const auto* binding = llvm::dyn_cast<clang::BindingDecl>(name->getDecl()))
    return of_binding(binding, depth);
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
  return variable ? name_of(variable, depth) : MessagePart();
}

/// Not what the function's next call, or the container's next mention, has instead; and a copy has a name of its own.
MessagePart MessageParts::name_of(const clang::VarDecl* variable, unsigned depth) const {
  if (const clang::Expr* range = range_of(variable))
    if (const MessagePart whole = part_of(range, depth + 1); !whole.empty())
      return whole + "[each" + index_token(unit_, variable) + "]";
  if (is_another_name(variable))
    if (MessagePart same = part_of(variable->getInit(), depth + 1);
        !same.empty() && !is_result(same) && !is_copy(same) && !is_fleeting(same))
      return same;
  return root_of(variable);
}

MessagePart MessageParts::of_member(const clang::MemberExpr* member, unsigned depth) const {
  if (!llvm::isa<clang::FieldDecl, clang::VarDecl>(member->getMemberDecl())) return {};
  const clang::QualType base = member->getBase()->getType();
  const bool of_message = is_stock_or_twin(member->isArrow() ? base->getPointeeType() : base);
  if (is_part_of_pair(member->getMemberDecl())) return of_pair(member, depth);
  if (!of_message) return root_of(member->getMemberDecl());
  const MessagePart whole = part_of(member->getBase(), depth + 1);
  return whole.empty() ? whole : whole + "/" + member->getMemberDecl()->getNameAsString();
}

/// `second` of what a map has is its only message; of two messages each has a name.
MessagePart MessageParts::of_pair(const clang::MemberExpr* member, unsigned depth) const {
  MessagePart whole = part_of(member->getBase(), depth + 1);
  const auto* record = llvm::cast<clang::CXXRecordDecl>(member->getMemberDecl()->getDeclContext());
  const bool has_two = llvm::all_of(
      record->fields(), [](const clang::FieldDecl* field) { return message_reached(field->getType()); });
  if (whole.empty() || !has_two) return whole;
  return whole + (member->getMemberDecl()->getName() == "first" ? "[0]" : "[1]");
}

MessagePart MessageParts::element_of(const clang::Expr* container, const clang::Expr* index,
                                     unsigned depth) const {
  const MessagePart whole = part_of(container, depth + 1);
  return whole.empty() ? whole : whole + "[" + element_name(unit_, view_, index) + "]";
}

/// A function that returns one object of its own class.
MessagePart MessageParts::of_result(const clang::FunctionDecl* function, unsigned depth) const {
  const clang::FunctionDecl* definition = shown_body(function);
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if ((method && method->isVirtual()) || !definition) return {};
  const auto* body = llvm::dyn_cast_or_null<clang::CompoundStmt>(definition->getBody());
  const auto* returned =
      body && body->size() == 1 ? llvm::dyn_cast<clang::ReturnStmt>(body->body_front()) : nullptr;
  if (!returned || !returned->getRetValue() || is_stock_or_twin(function->getReturnType().getCanonicalType()))
    return function->getReturnType()->isReferenceType() && returned && returned->getRetValue()
               ? part_of(returned->getRetValue(), depth + 1)
               : MessagePart();
  const MessagePart part = part_of(returned->getRetValue(), depth + 1);
  return part.rfind("c:", 0) == 0 ? part : MessagePart();
}

MessagePart MessageParts::of_call(const clang::CallExpr* call, unsigned depth) const {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return {};
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call)) return of_operator(op, depth);
  if (call->getNumArgs() > 0 && (passes_through(function) || casts_pointer(function)))
    return part_of(call->getArg(0), depth + 1);
  return unit_.declares(function) ? of_package_call(function, depth) : of_library_call(call, depth);
}

MessagePart MessageParts::of_package_call(const clang::FunctionDecl* function, unsigned depth) const {
  MessagePart part = of_result(function, depth);
  return part.empty() && returns_message(function) ? result_root(usr_of(pattern_of(function))) : part;
}

MessagePart MessageParts::of_operator(const clang::CXXOperatorCallExpr* call, unsigned depth) const {
  switch (call->getOperator()) {
    case clang::OO_Arrow:
    case clang::OO_Star:
    case clang::OO_PlusPlus:  // *it++: one of the messages that it leads to
    case clang::OO_MinusMinus:
      return part_of(call->getArg(0), depth + 1);
    case clang::OO_Call:
      return unit_.declares(call->getDirectCallee()) ? of_package_call(call->getDirectCallee(), depth)
                                                     : MessagePart();
    case clang::OO_Subscript:
    case clang::OO_Plus:
    case clang::OO_Minus:
    case clang::OO_PlusEqual:
    case clang::OO_MinusEqual:
      return call->getNumArgs() == 2 ? element_of(call->getArg(0), call->getArg(1), depth) : MessagePart();
    default:
      return {};
  }
}

/// What a function of a library returns leads to what it was given: frames_.begin(), std::prev(it), map_.find(key).
MessagePart MessageParts::of_library_call(const clang::CallExpr* call, unsigned depth) const {
  const clang::FunctionDecl* function = call->getDirectCallee();
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (!function->getDeclName().isIdentifier()) return {};
  if (method && (function->getName() == "get" || function->getName() == "value"))
    return part_of(method->getImplicitObjectArgument(), depth + 1);
  if (method && function->getName() == "at" && call->getNumArgs() == 1)
    return element_of(method->getImplicitObjectArgument(), call->getArg(0), depth);
  const bool is_new = call->isPRValue() && holds_messages(call->getType());
  if (is_new || makes_object(call) || !message_reached(call->getType())) return {};
  const std::vector<const clang::Expr*> sources = message_sources(call);
  if (sources.size() > 1) return choice_root(unit_.offset(call->getBeginLoc()));
  const MessagePart whole = sources.empty() ? MessagePart() : part_of(sources.front(), depth + 1);
  return whole.empty() ? whole : whole + "[" + found_element(call) + "]";
}

/// std::get<1>(pair), frames_.find(key)
std::string MessageParts::found_element(const clang::CallExpr* call) const {
  const clang::FunctionDecl* function = call->getDirectCallee();
  std::string name = function->getNameAsString();
  const clang::TemplateArgumentList* given = function->getTemplateSpecializationArgs();
  if (name == "get" && given && given->get(0).getKind() == clang::TemplateArgument::Integral)
    return llvm::toString(given->get(0).getAsIntegral(), 10);
  for (const clang::Expr* argument : call->arguments()) {
    if (llvm::isa<clang::CXXDefaultArgExpr>(argument) || message_reached(argument->getType())) continue;
    const std::string element = element_name(unit_, view_, argument);
    if (element == any_element()) return element;
    name += " " + element;
  }
  return name;
}

MessagePart MessageParts::of_binary(const clang::BinaryOperator* op, unsigned depth) const {
  if (op->isAdditiveOp() && op->getLHS()->getType()->isPointerType())
    return element_of(op->getLHS(), op->getRHS(), depth);
  if (op->isAssignmentOp()) return part_of(op->getLHS(), depth + 1);
  return op->isCommaOp() ? part_of(op->getRHS(), depth + 1) : MessagePart();
}

MessagePart MessageParts::part_of(const clang::Expr* expr, unsigned depth) const {
  if (depth > max_depth) return {};
  expr = expr->IgnoreParens();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return of_name(name, depth);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return of_member(member, depth);
  if (copied_message(expr)) return copy_root(unit_.offset(expr->getBeginLoc()));
  if (const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(expr))
    return made->getInitializer() && copied_message(made->getInitializer())
               ? part_of(made->getInitializer(), depth + 1)
               : MessagePart();
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return of_call(call, depth);
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr))
    return element_of(element->getBase(), element->getIdx(), depth);
  if (llvm::isa<clang::ConditionalOperator>(expr) || is_list_of_messages(expr))
    return choice_root(unit_.offset(expr->getBeginLoc()));
  if (const auto* list = llvm::dyn_cast<clang::CXXStdInitializerListExpr>(expr))
    return part_of(list->getSubExpr(), depth + 1);
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(expr)) return of_binary(op, depth);
  const clang::Expr* same = same_object(expr);
  return same ? part_of(same, depth + 1) : MessagePart();
}

std::vector<const clang::FieldDecl*> messages_in(const Unit& unit, const clang::CXXRecordDecl* record) {
  std::vector<const clang::FieldDecl*> found;
  if (!record || !record->hasDefinition() || !unit.source.in_package(record->getLocation())) return found;
  const auto add = [&](clang::QualType type) {
    const auto more = messages_in(unit, type->getAsCXXRecordDecl());
    found.insert(found.end(), more.begin(), more.end());
  };
  for (const clang::CXXBaseSpecifier& base : record->bases()) add(base.getType());
  for (const clang::FieldDecl* field : record->fields()) {
    if (is_stock_or_twin(field->getType()) && !field->getType()->isReferenceType())
      found.push_back(field);
    else
      add(field->getType());
  }
  return found;
}

}  // namespace tzc::rewriter
