// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/array_writes.h"

#include "facts/escape/filled_message.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

/// Where a message's data is written, or may be: an array mentioned otherwise than by a const function.
bool may_write(const FunctionView& view, const clang::Expr* array) {
  if (is_only_read(view, array)) return false;
  const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(view.parent(array));
  const auto* method = member ? llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl()) : nullptr;
  return !method || !method->isConst();
}

/// (*pixels)[0], pixels->size(): the array that the name of a pointer to it stands for.
const clang::Expr* array_named_by(const FunctionView& view, const clang::Expr* name) {
  for (;;) {
    const clang::Stmt* around = view.parent(name);
    const auto* cast = llvm::dyn_cast_or_null<clang::ImplicitCastExpr>(around);
    const auto* op = llvm::dyn_cast_or_null<clang::UnaryOperator>(around);
    const bool leads_there = llvm::isa_and_nonnull<clang::ParenExpr>(around) ||
                             (cast && cast->getCastKind() == clang::CK_LValueToRValue) ||
                             (op && op->getOpcode() == clang::UO_Deref);
    if (!leads_there) return name;
    name = llvm::cast<clang::Expr>(around);
  }
}

/// The message whose elements a statement may write, or replace, other than through a mention of an array; null: none.
const clang::Expr* written_message(const Unit& unit, const clang::Stmt* stmt) {
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) {
    const clang::CXXRecordDecl* record = made->getConstructor()->getParent();
    const bool writes = is_cloud_iterator(record) && !record->getName().contains("Const");
    return writes && made->getNumArgs() > 1 ? made->getArg(0) : nullptr;
  }
  return filled_message(unit, stmt);
}

/// frame = other, frames.swap(others), std::swap(frame, other): what is replaced as a whole.
std::vector<const clang::Expr*> replaced_by(const clang::Stmt* stmt) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
  if (!function) return {};
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
  if (op && op->getOperator() == clang::OO_Equal) return {op->getArg(0)};
  if (op || !function->getIdentifier() || function->getName() != "swap") return {};
  std::vector<const clang::Expr*> objects(call->arg_begin(), call->arg_end());
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call))
    objects.push_back(method->getImplicitObjectArgument());
  return objects;
}

/// The messages that are parts of an object. A message itself is written where filled_message() says so.
std::vector<EntityId> messages_of_parts(EscapeContext& context, const clang::Expr* object) {
  const clang::QualType type = object->getType().getNonReferenceType();
  if (is_stock_or_twin(type)) return {};
  std::vector<EntityId> messages;
  if (holds_messages(type)) messages = context.sources_of(object);
  for (const clang::FieldDecl* field : messages_in(context.unit, type->getAsCXXRecordDecl()))
    messages.push_back(context.entities.declare(field));
  return messages;
}

SeenEvent write_at(const FunctionView& view, const clang::Expr* at, const std::vector<EntityId>& messages) {
  SeenEvent write{{}, at, view.span(at), view.lambda_around(at)};
  write.event.kind = PublishEvent::Kind::write;
  write.event.messages = {messages.begin(), messages.end()};
  return write;
}

}  // namespace

std::vector<SeenEvent> array_writes(EscapeContext& context, const FunctionView& view) {
  std::vector<SeenEvent> writes;
  for (const clang::Stmt* stmt : view.statements()) {
    const auto* array = llvm::dyn_cast<clang::MemberExpr>(stmt);
    const bool is_array = array && is_data_array(array->getType()) && may_write(view, array);
    const clang::Expr* message = is_array ? array->getBase() : written_message(context.unit, stmt);
    if (message) writes.push_back(write_at(view, llvm::cast<clang::Expr>(stmt), context.sources_of(message)));
    for (const clang::Expr* object : replaced_by(stmt))
      if (const auto parts = messages_of_parts(context, object); !parts.empty())
        writes.push_back(write_at(view, llvm::cast<clang::Expr>(stmt), parts));
  }
  return writes;
}

std::vector<SeenEvent> writes_through(const FunctionView& view, const clang::VarDecl* array,
                                      const std::vector<EntityId>& messages) {
  std::vector<SeenEvent> writes;
  for (const clang::DeclRefExpr* use : view.uses(array))
    if (may_write(view, array_named_by(view, use))) writes.push_back(write_at(view, use, messages));
  return writes;
}

}  // namespace tzc::rewriter
