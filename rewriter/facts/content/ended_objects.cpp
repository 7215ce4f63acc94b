// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/ended_objects.h"

#include <set>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"

namespace tzc::rewriter {
namespace {

/// The object that a call may change.
const clang::Expr* changed_object(const clang::CallExpr* call) {
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call->getDirectCallee());
  if (!method || method->isConst()) return nullptr;
  if (const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call))
    return member->getImplicitObjectArgument();
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
  return op && op->isAssignmentOp() ? op->getArg(0) : nullptr;
}

}  // namespace

/// In the order in which they run. Each class once: objects may hold one another by shared pointers, round and round.
class EndedObjects::Search {
 public:
  explicit Search(const Unit& unit) : unit_(unit) {}

  void object(clang::QualType type, bool perhaps) {
    const clang::CXXRecordDecl* record =
        type->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();  // also of an array
    if (!record || !record->hasDefinition() || !seen_.insert(record->getDefinition()).second) return;
    record = record->getDefinition();
    if (unit_.source.in_package(record->getLocation())) return own(record, perhaps);
    if (const auto* held = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record))
      for (const clang::TemplateArgument& argument : held->getTemplateArgs().asArray())
        if (argument.getKind() == clang::TemplateArgument::Type) object(argument.getAsType(), true);
  }

  std::vector<Ended> found() && { return std::move(found_); }

 private:
  void own(const clang::CXXRecordDecl* record, bool perhaps) {
    const clang::CXXDestructorDecl* const destructor = record->getDestructor();
    if (destructor && destructor->isUserProvided()) found_.push_back({destructor, perhaps});
    for (const clang::FieldDecl* field : record->fields())
      if (!field->getType()->isReferenceType()) object(field->getType(), perhaps);
    for (const clang::CXXBaseSpecifier& base : record->bases()) object(base.getType(), perhaps);
  }

  const Unit& unit_;
  std::set<const clang::CXXRecordDecl*> seen_;
  std::vector<Ended> found_;
};

std::vector<EndedObjects::Ended> EndedObjects::ended_with(clang::QualType type, bool perhaps) const {
  Search search(unit_);
  search.object(type, perhaps);
  return std::move(search).found();
}

void EndedObjects::add(const Ended& ended, bool perhaps, clang::SourceLocation where) {
  ContentEvent event;
  event.kind = ContentEvent::Kind::call;
  if (!may_have_another_body(ended.destructor)) event.callee = usr_of(pattern_of(ended.destructor));
  event.where = unit_.location(where);
  if (perhaps)
    log_.step(PerhapsCall{std::move(event)});
  else
    log_.step(std::move(event));
}

void EndedObjects::object(clang::QualType type, clang::SourceLocation where) {
  if (type->isReferenceType() || type->isPointerType()) return;
  for (const Ended& ended : ended_with(type, false)) add(ended, ended.perhaps, where);
}

/// The object stays, and something that it holds may end: reset, clear, an assignment.
void EndedObjects::parts_of(clang::QualType object, clang::SourceLocation where) {
  const clang::CXXRecordDecl* const record = object->getAsCXXRecordDecl();
  if (!record || unit_.source.in_package(record->getLocation())) return;
  for (const Ended& ended : ended_with(object, true)) add(ended, true, where);
}

void EndedObjects::look_at(const clang::Stmt* stmt) {
  if (const auto* deleted = llvm::dyn_cast<clang::CXXDeleteExpr>(stmt)) {
    const clang::QualType type = deleted->getDestroyedType();
    if (!type.isNull()) object(type, deleted->getBeginLoc());
  } else if (const auto* temporary = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(stmt)) {
    // Its expression ends soon; a variable that it makes, or that makes it live on, later.
    for (const Ended& ended : ended_with(temporary->getType(), true))
      add(ended, true, temporary->getEndLoc());
  } else if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) {
    if (const clang::Expr* changed = changed_object(call)) parts_of(changed->getType(), call->getExprLoc());
  }
}

}  // namespace tzc::rewriter
