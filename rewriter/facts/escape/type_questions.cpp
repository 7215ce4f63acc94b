// SPDX-License-Identifier: BSD-3-Clause
// In the port, an array of a message is no std::vector, and its iterators are pointers. A name whose type is deduced from one has another type
// then, and so has what is made of it: auto it = scan.ranges.begin(); std::is_pointer<decltype(it)>::value.
//
// Why no question is missed: a program learns a type from an expression only where it does not evaluate it (decltype, typeof, requires, local
// classes, static_assert), where it asks for more than its value (typeid, sizeof, noexcept, throw), or where a template deduces it.
//   - What is not evaluated is not part of the FunctionView, whatever kind of node it stands in: each such expression is looked at, and is a
//     question unless it has a form that is known to have the same type or none that changes.
//   - The others are four kinds of nodes.
//   - Templates of the package are asked whether they are blind for types: functions where they are called (escape_calls.cpp), classes here,
//     where an object is made by deduction. Of libraries, classes that keep an object's type (std::any) are recognised by what they tell.
#include "facts/escape/type_questions.h"

#include <clang/AST/DeclTemplate.h>

#include <set>

#include "facts/escape/written_types.h"
#include "facts/syntax/message_type.h"
#include "facts/syntax/type_blind.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned max_depth = 12;

bool has_array(clang::QualType type, unsigned depth = 0);

bool has_array(const clang::TemplateArgument& argument, unsigned depth) {
  if (argument.getKind() == clang::TemplateArgument::Type) return has_array(argument.getAsType(), depth);
  return argument.getKind() == clang::TemplateArgument::Pack &&
         llvm::any_of(argument.pack_elements(),
                      [&](const clang::TemplateArgument& element) { return has_array(element, depth); });
}

bool is_iterator_class(clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return record && record->getIdentifier() && record->getName().ends_with_insensitive("iterator");
}

/// sensor_msgs::PointCloud2Iterator<float>. What else is called so goes through what its arguments say.
bool is_iterator_of_numbers(clang::QualType type) {
  const clang::QualType element = is_iterator_class(type) ? first_argument(type) : clang::QualType();
  return !element.isNull() && (element->isArithmeticType() ||
                               (element->isPointerType() && element->getPointeeType()->isArithmeticType()));
}

bool record_has_array(const clang::CXXRecordDecl* record, clang::QualType type, unsigned depth) {
  if (is_data_array(type) || is_iterator_of_numbers(type)) return true;
  if (record->isLambda())
    return llvm::any_of(record->fields(), [&](const clang::FieldDecl* captured) {
      return has_array(captured->getType(), depth + 1);
    });
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && llvm::any_of(
                     made->getTemplateArgs().asArray(),
                     [&](const clang::TemplateArgument& argument) { return has_array(argument, depth + 1); });
}

/// Whether a type is made of a data array or an iterator, as std::pair<It, It> is. What is too deep to tell may be.
bool has_array(clang::QualType type, unsigned depth) {
  if (type.isNull() || type->isDependentType()) return false;  // instances tell
  if (depth > max_depth) return true;
  type = type.getCanonicalType().getUnqualifiedType();
  if (const clang::QualType pointee = type->getPointeeType(); !pointee.isNull())
    return has_array(pointee, depth + 1);
  if (const auto* array = type->getAsArrayTypeUnsafe()) return has_array(array->getElementType(), depth + 1);
  if (const auto* function = type->getAs<clang::FunctionProtoType>())
    return has_array(function->getReturnType(), depth + 1) ||
           llvm::any_of(function->param_types(),
                        [&](clang::QualType parameter) { return has_array(parameter, depth + 1); });
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record && record_has_array(record, type, depth);
}

/// Whether an expression is made of names whose types stay as the source writes them: members, parameters, objects that are vectors
/// themselves. Local references, pointers and iterators follow the array where the source writes their types, too (stock_vectors.h).
class FixedTypes {
 public:
  explicit FixedTypes(const Unit& unit) : unit_(unit) {}

  bool of(const clang::Stmt* stmt) const {
    if (!stmt) return true;
    if (llvm::isa<clang::LambdaExpr, clang::StmtExpr>(stmt)) return false;
    if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(stmt)) return of_name(name->getDecl());
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt))
      return !is_of_message(member) && (of_member(member->getMemberDecl()) || of(member->getBase()));
    return llvm::all_of(stmt->children(), [&](const clang::Stmt* child) { return of(child); });
  }

 private:
  bool is_written(clang::QualType type) const { return is_written_out(unit_.ast(), type); }

  bool of_name(const clang::ValueDecl* decl) const {
    if (!has_array(decl->getType())) return true;
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(decl))
      return !unit_.declares(function) || is_written(function->getReturnType());
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
    if (!variable) return !llvm::isa<clang::BindingDecl>(decl);  // LaserScan::ranges names its class
    if (!is_written(variable->getType())) return false;
    const bool follows = variable->getType()->isReferenceType() || variable->getType()->isPointerType() ||
                         is_iterator_class(variable->getType());
    return llvm::isa<clang::ParmVarDecl>(variable) || !follows;
  }
  bool of_member(const clang::ValueDecl* decl) const {
    return llvm::isa<clang::FieldDecl>(decl) && unit_.source.in_package(decl->getLocation()) &&
           is_written(decl->getType());
  }
  static bool is_of_message(const clang::MemberExpr* member) {
    const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(member->getMemberDecl()->getDeclContext());
    return record && (message_of(record) || twin_message_of(record->getASTContext().getRecordType(record)));
  }

  const Unit& unit_;
};

/// An object that tells the type of what it keeps: std::any. Of a closure, that is the same type in the port.
bool tells_types(const clang::CXXRecordDecl* record) {
  return record && record->hasDefinition() &&
         llvm::any_of(record->methods(), [](const clang::CXXMethodDecl* method) {
           const clang::CXXRecordDecl* told =
               method->getReturnType().getNonReferenceType()->getAsCXXRecordDecl();
           return told && told->getIdentifier() && told->getName() == "type_info";
         });
}

class Questions : public AstVisitor {
 public:
  Questions(const Unit& unit, const FunctionView& view) : unit_(unit), view_(view), fixed_(unit) {}

  std::vector<const clang::Expr*> run() {
    for (const clang::Stmt* stmt : view_.statements()) look_at_evaluated(stmt);
    TraverseDecl(const_cast<clang::FunctionDecl*>(view_.function()));
    return std::move(found_);
  }

  /// decltype(it) next = it; declares a variable that is followed, as auto next = it; does.
  bool VisitVarDecl(clang::VarDecl* variable) override {
    const clang::Expr* operand = is_followed(variable) ? operand_of_type(variable) : nullptr;
    if (operand) cover(operand);
    return true;
  }
  /// Functions of local classes have views of their own. What their types ask about is part of neither.
  bool VisitFunctionDecl(clang::FunctionDecl* function) override {
    if (function != view_.function() && function->doesThisDeclarationHaveABody()) cover(function->getBody());
    return true;
  }
  bool VisitStmt(clang::Stmt* stmt) override {
    const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
    // A list as written is not part of a view either; its elements are.
    if (!expr || view_.holds(expr) || covered_.count(expr) != 0 ||
        llvm::isa<clang::InitListExpr, clang::DesignatedInitExpr>(expr))
      return true;
    cover(expr);
    ask(expr, has_array(expr->getType()) || !keeps_its_type(expr));
    return true;
  }

 private:
  void ask(const clang::Expr* about, bool question) {
    if (question && !fixed_.of(about)) found_.push_back(about);
  }

  void cover(const clang::Stmt* stmt) {
    if (!stmt || !covered_.insert(stmt).second) return;
    for (const clang::Stmt* child : stmt->children()) cover(child);
  }

  static bool mentions_array(const clang::Stmt* stmt) {
    const auto* expr = llvm::dyn_cast_or_null<clang::Expr>(stmt);
    return (expr && has_array(expr->getType())) ||
           (stmt &&
            llvm::any_of(stmt->children(), [](const clang::Stmt* child) { return mentions_array(child); }));
  }

  /// Of an expression whose own type is none that changes: decltype(*it), decltype(it - begin), decltype(copy.size()). What a function of the
  /// package gives for an iterator may be another thing.
  bool keeps_its_type(const clang::Stmt* stmt) const {
    if (!stmt || !mentions_array(stmt)) return true;
    const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
    const bool is_step = llvm::isa<clang::DeclRefExpr, clang::ParenExpr, clang::ImplicitCastExpr,
                                   clang::UnaryOperator, clang::BinaryOperator, clang::ArraySubscriptExpr,
                                   clang::MemberExpr, clang::MaterializeTemporaryExpr>(stmt);
    const bool is_function_of_it = llvm::isa<clang::CXXMemberCallExpr, clang::CXXOperatorCallExpr>(stmt) &&
                                   call->getDirectCallee() && !unit_.declares(call->getDirectCallee());
    return (is_step || is_function_of_it) &&
           llvm::all_of(stmt->children(), [&](const clang::Stmt* child) { return keeps_its_type(child); });
  }

  /// Its value comes from where the variable's initializer leads, and it has one: a pointer without one is none, an iterator is null.
  bool is_followed(const clang::VarDecl* variable) const {
    const clang::Expr* value = variable->getInit();
    const auto* made = value ? llvm::dyn_cast<clang::CXXConstructExpr>(value->IgnoreImplicit()) : nullptr;
    const bool is_default =
        made && made->getNumArgs() == 0 && variable->getInitStyle() != clang::VarDecl::ListInit;
    return value && !is_default && variable->isLocalVarDecl() && !variable->isStaticLocal() &&
           view_.declaration(variable);
  }

  /// Of const decltype(it)&, it; null: it asks for more than the type of a name.
  static const clang::Expr* operand_of_type(const clang::VarDecl* variable) {
    const clang::TypeSourceInfo* info = variable->getTypeSourceInfo();
    clang::TypeLoc type = info ? info->getTypeLoc().getUnqualifiedLoc() : clang::TypeLoc();
    if (type.isNull()) return nullptr;
    if (const auto reference = type.getAs<clang::ReferenceTypeLoc>())
      type = reference.getPointeeLoc().getUnqualifiedLoc();
    const auto asked = type.getAs<clang::DecltypeTypeLoc>();
    const clang::Expr* operand = asked ? asked.getUnderlyingExpr() : nullptr;
    return operand && llvm::isa<clang::DeclRefExpr>(operand->IgnoreParens()) ? operand : nullptr;
  }

  void look_at_evaluated(const clang::Stmt* stmt) {
    if (const auto* asked = llvm::dyn_cast<clang::CXXTypeidExpr>(stmt); asked && !asked->isTypeOperand())
      ask(asked->getExprOperand(), has_array(asked->getExprOperand()->getType()));
    if (const auto* asked = llvm::dyn_cast<clang::UnaryExprOrTypeTraitExpr>(stmt);
        asked && !asked->isArgumentType())
      ask(asked->getArgumentExpr(), has_array(asked->getArgumentExpr()->getType()));
    if (const auto* asked = llvm::dyn_cast<clang::CXXNoexceptExpr>(stmt))
      ask(asked->getOperand(), mentions_array(asked->getOperand()));
    if (const auto* thrown = llvm::dyn_cast<clang::CXXThrowExpr>(stmt); thrown && thrown->getSubExpr())
      ask(thrown->getSubExpr(), has_array(thrown->getSubExpr()->getType()));
    if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(stmt)) ask(list, may_ask_itself(list));
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
      ask(made, may_ask_itself(made) || is_kept_with_its_type(made));
    if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(stmt)) ask(op, is_kept_with_its_type(op));
  }

  /// std::any kept(it), kept = it
  static bool is_kept_with_its_type(const clang::CXXConstructExpr* made) {
    return made->getConstructor()->getPrimaryTemplate() && tells_types(made->getConstructor()->getParent()) &&
           llvm::any_of(made->arguments(), has_type_to_tell);
  }
  static bool is_kept_with_its_type(const clang::CXXOperatorCallExpr* op) {
    return op->getOperator() == clang::OO_Equal && op->getDirectCallee() &&
           op->getDirectCallee()->getPrimaryTemplate() &&
           tells_types(op->getArg(0)->getType()->getAsCXXRecordDecl()) && has_type_to_tell(op->getArg(1));
  }
  static bool has_type_to_tell(const clang::Expr* value) {
    const clang::CXXRecordDecl* record = value->getType()->getAsCXXRecordDecl();
    return !(record && record->isLambda()) && has_array(value->getType());
  }

  /// Box box{it}: of a class template of the package that asks what it is made with.
  bool may_ask_itself(const clang::Expr* made) const {
    const auto* instance =
        llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(made->getType()->getAsCXXRecordDecl());
    return instance && unit_.source.in_package(instance->getLocation()) && has_array(made->getType()) &&
           !is_type_blind(unit_, instance);
  }

  const Unit& unit_;
  const FunctionView& view_;
  const FixedTypes fixed_;
  std::set<const clang::Stmt*> covered_;  ///< parts of what has been looked at, or need not be
  std::vector<const clang::Expr*> found_;
};

}  // namespace

std::vector<const clang::Expr*> type_questions(const Unit& unit, const FunctionView& view) {
  return Questions(unit, view).run();
}

bool is_made_of_array(clang::QualType type) {
  return has_array(type);
}

std::vector<EntityId> messages_named(EscapeContext& context, const FunctionView& view) {
  std::set<EntityId> found;
  for (const clang::Stmt* stmt : view.statements()) {
    const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
    if (!llvm::isa<clang::DeclRefExpr, clang::MemberExpr, clang::CallExpr>(stmt) ||
        !leads_to_messages(expr->getType()))
      continue;
    for (const EntityId& id : context.sources_of(expr))
      if (context.entities.is_message(id)) found.insert(id);
  }
  return {found.begin(), found.end()};
}

}  // namespace tzc::rewriter
