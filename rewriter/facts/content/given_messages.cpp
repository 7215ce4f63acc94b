// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/given_messages.h"

#include "facts/content/copy_homes.h"
#include "facts/content/message_holders.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

bool is_root(const MessagePart& part) {
  return part.find_first_of("/[") == MessagePart::npos;
}

bool is_library_container(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXRecordDecl* record = call->getRecordDecl();
  if (!record || unit.declares(call->getMethodDecl())) return false;
  const std::string name = qualified_name_of(record);
  return name.rfind("std::", 0) == 0 || name.rfind("boost::", 0) == 0;
}

/// cloud.channels: its elements are parts of one message.
bool is_in_message(const clang::Expr* container) {
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(container->IgnoreParenImpCasts());
  if (!member) return false;
  const clang::QualType base = member->getBase()->getType();
  return is_stock_or_twin(member->isArrow() ? base->getPointeeType() : base);
}

bool is_map(clang::QualType type) {
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record && (record->getName() == "map" || record->getName() == "unordered_map");
}

/// What an object is made from, directly or through another new object; none: from nothing that is an expression here.
std::vector<const clang::Expr*> origins_of(const clang::Expr* expr) {
  if (const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(expr))
    return made->hasInitializer() ? std::vector<const clang::Expr*>{made->getInitializer()}
                                  : std::vector<const clang::Expr*>{};
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expr))
    return {choice->getTrueExpr(), choice->getFalseExpr()};
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(expr))
    return {construct->arg_begin(), construct->arg_end()};
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expr))
    return {list->inits().begin(), list->inits().end()};
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  if (call && makes_object(call)) return {call->arg_begin(), call->arg_end()};
  return {};
}

/// new Image, make_shared<Image>(), cv_image.toImageMsg()
bool is_new(const Unit& unit, const clang::Expr* expr) {
  expr = expr->IgnoreUnlessSpelledInSource();
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  return llvm::isa<clang::CXXNewExpr>(expr) || (call && (makes_object(call) || builds_message(unit, call)));
}

class GivenMessages {
 public:
  GivenMessages(const Unit& unit, const FunctionView& view, EscapeFacts& facts)
      : unit_(unit),
        view_(view),
        parts_(unit, view),
        holders_(unit, view),
        homes_(unit, view),
        function_(usr_of(pattern_of(view.function()))),
        facts_(facts) {}

  void look_at(const clang::Stmt* stmt);

 private:
  void give(const clang::Expr* message, const std::string& holder, const std::string& how);
  bool is_fresh_local(const clang::Expr* message) const;
  bool is_copy_of_fresh_local(const clang::Expr* published) const;
  bool may_be_published_before(const clang::VarDecl* variable, const clang::Expr* at) const;
  bool hand_on(const clang::Expr* from, const std::string& holder, const std::string& how = "");
  void container_call(const clang::CXXMemberCallExpr* call);
  void make_in(const std::string& container, const std::string& how, const clang::Expr* at);
  void declaration(const clang::DeclStmt* statement);
  void result(const clang::ReturnStmt* statement);
  void publish(const clang::CallExpr* call);
  void call(const clang::CallExpr* call);
  void member_call(const clang::CXXMemberCallExpr* call);
  void assignment(const clang::CXXOperatorCallExpr* call);
  void construction(const clang::CXXConstructExpr* construct);
  void copies(const clang::CXXConstructExpr* construct);

  const Unit& unit_;
  const FunctionView& view_;
  const MessageParts parts_;
  const MessageHolders holders_;
  const CopyHomes homes_;
  const std::string function_;
  EscapeFacts& facts_;
};

void GivenMessages::give(const clang::Expr* message, const std::string& holder, const std::string& how) {
  if (holder.empty() || !is_stock_or_twin(message->getType())) return;
  if (message->isLValue() && is_fresh_local(message))
    return facts_.given.messages.push_back({{}, holder, how, unit_.location(message->getBeginLoc()), true});
  const MessagePart given = parts_.part_of(message);
  const MessagePart part = given.substr(0, given.find('['));  // an element stands for its container
  if (!outlives_functions(part) || !is_root(part) || part == holder) return;
  facts_.given.messages.push_back({part, holder, how, unit_.location(message->getBeginLoc())});
}

/// A message that this function makes and that it has not published yet: a copy of it has elements of its own.
bool GivenMessages::is_fresh_local(const clang::Expr* message) const {
  message = message->IgnoreParenImpCasts();
  const clang::Expr* const pointer = pointer_followed(message);
  if (pointer && is_new(unit_, pointer)) return true;
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(pointer ? pointer : message);
  const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  if (!variable || !variable->hasLocalStorage() || llvm::isa<clang::ParmVarDecl>(variable) ||
      variable->getType()->isReferenceType() || !view_.declaration(variable))
    return false;
  if (pointer && !(variable->getInit() && is_new(unit_, variable->getInit()))) return false;
  return !may_be_published_before(variable, message);
}

/// publish(Image(image)), [image] { publish(image); }
bool GivenMessages::is_copy_of_fresh_local(const clang::Expr* published) const {
  published = published->IgnoreParens()->IgnoreImplicit();
  if (const auto* cast = llvm::dyn_cast<clang::CXXFunctionalCastExpr>(published))
    published = cast->getSubExpr()->IgnoreImplicit();
  if (!is_stock_or_twin(published->getType())) return false;
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(published))
    return made->getConstructor()->isCopyConstructor() && made->getArg(0)->isLValue() &&
           is_fresh_local(made->getArg(0));
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(published);
  const clang::LambdaExpr* lambda = name ? view_.lambda_around(name) : nullptr;
  return lambda && llvm::any_of(lambda->captures(), [&](const clang::LambdaCapture& capture) {
           return capture.capturesVariable() && capture.getCapturedVar() == name->getDecl() &&
                  capture.getCaptureKind() == clang::LCK_ByCopy && is_fresh_local(name);
         });
}

/// By a call of the package, too.
bool GivenMessages::may_be_published_before(const clang::VarDecl* variable, const clang::Expr* at) const {
  return llvm::any_of(view_.uses(variable), [&](const clang::DeclRefExpr* use) {
    if (view_.span(use).enter >= view_.span(at).enter) return false;
    const clang::Stmt* around = view_.parent(use);
    while (is_wrapping(around) ||
           llvm::isa_and_nonnull<clang::CastExpr, clang::UnaryOperator, clang::CXXOperatorCallExpr,
                                 clang::CXXConstructExpr>(around))
      around = view_.parent(around);
    const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
    return call && (!published_by(call).empty() || unit_.declares(call->getDirectCallee()));
  });
}

/// What is made from a message, or from what leads to one; `how` it is given away that is moved, where nothing else says so.
/// False: it is made from none that has a name.
bool GivenMessages::hand_on(const clang::Expr* from, const std::string& holder, const std::string& how) {
  if (!from || holder.empty()) return false;
  bool has_source = false;
  std::vector<const clang::Expr*> open{from};
  while (!open.empty()) {
    const clang::Expr* expr = open.back()->IgnoreParens()->IgnoreImplicit();
    open.pop_back();
    if (const auto* full = llvm::dyn_cast<clang::ExprWithCleanups>(expr)) expr = full->getSubExpr();
    const auto origins = origins_of(expr);
    open.insert(open.end(), origins.begin(), origins.end());
    if (!origins.empty() || !leads_to_messages(expr->getType())) continue;
    if (!how.empty() && expr->isXValue()) give(expr, holder, how);
    std::string source = holders_.of(expr);
    has_source |= !source.empty();
    if (!source.empty() && source != holder) facts_.given.handed_on[std::move(source)].insert(holder);
  }
  return has_source;
}

void GivenMessages::declaration(const clang::DeclStmt* statement) {
  for (const clang::Decl* decl : statement->decls())
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl))
      hand_on(variable->getInit(), holders_.of_name(variable),
              "moved to '" + variable->getNameAsString() + "'");
}

void GivenMessages::result(const clang::ReturnStmt* statement) {
  if (!view_.lambda_around(statement)) hand_on(statement->getRetValue(), result_root(function_));
}

void GivenMessages::publish(const clang::CallExpr* call) {
  const Place place = unit_.source.where(call->getExprLoc());
  for (const clang::Expr* argument : published_by(call)) {
    std::set<std::string>& holders = facts_.given.published_from[{place.file, place.begin}];
    if (std::string holder = holders_.of(argument); !holder.empty()) holders.insert(std::move(holder));
    if (!is_copy_of_fresh_local(argument)) continue;
    const std::string copy = "copy at " + place.file + ":" + std::to_string(place.begin);
    holders.insert(copy);
    facts_.given.messages.push_back(
        {{}, copy, "made to be published", unit_.location(argument->getBeginLoc()), true});
  }
}

void GivenMessages::call(const clang::CallExpr* call) {
  if (is_attached_publish(call)) return publish(call);
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (!unit_.declares(callee) || llvm::isa<clang::CXXOperatorCallExpr>(call)) return;
  for (unsigned i = 0; i < call->getNumArgs(); ++i)
    hand_on(call->getArg(i), parameter_root(usr_of(pattern_of(callee)), i));
}

void GivenMessages::member_call(const clang::CXXMemberCallExpr* call) {
  if (is_publish(call))
    publish(call);
  else if (is_library_container(unit_, call))
    container_call(call);
}

/// A new element is bound to no memory. What a constructor puts in stays.
void GivenMessages::make_in(const std::string& container, const std::string& how, const clang::Expr* at) {
  static const std::set<std::string> where_taken_out = {"resize", "assign", "[]"};
  if (container.empty() || llvm::isa<clang::CXXConstructorDecl>(view_.function())) return;
  auto& made = where_taken_out.count(how) != 0 ? facts_.given.refills : facts_.given.messages;
  made.push_back({{}, container, "'" + how + "'", unit_.location(at->getBeginLoc())});
}

void GivenMessages::container_call(const clang::CXXMemberCallExpr* call) {
  static const std::set<std::string> makes = {"emplace_back", "emplace_front", "emplace", "emplace_hint",
                                              "push_back",    "push_front",    "push",    "insert",
                                              "try_emplace",  "resize",        "assign"};
  static const std::set<std::string> takes_out = {"clear", "erase",  "pop_back", "pop_front",
                                                  "pop",   "assign", "reset",    "extract"};
  const clang::Expr* const object = call->getImplicitObjectArgument();
  const clang::CXXMethodDecl* method =
      call->getMethodDecl();  // null: what a pointer leads to, which may be any
  const std::string holder = holders_.of(object),
                    name = method ? method->getNameAsString() : "a pointer to member";
  bool has_source = false;
  for (const clang::Expr* argument : call->arguments()) {
    if (!is_in_message(object) || !is_fresh_local(argument))
      give(argument, holder, "stored by '" + name + "'");
    has_source |= hand_on(argument, holder);
  }
  if (!holds_messages(object->getType()) || is_in_message(object)) return;
  if ((!method || makes.count(name) != 0) && !has_source) make_in(holder, name, call);
  if (!method || takes_out.count(name) != 0) facts_.given.emptied.insert(holder);
}

/// A message that is assigned keeps its memory; what is moved, or a pointer, brings its own.
void GivenMessages::assignment(const clang::CXXOperatorCallExpr* call) {
  const clang::QualType target = call->getArg(0)->getType();
  const bool is_container =
      holds_messages(target) && !is_stock_or_twin(target) && !is_in_message(call->getArg(0));
  if (call->getOperator() == clang::OO_Subscript && is_container && is_map(target))
    make_in(holders_.of(call->getArg(0)), "[]", call);
  if (call->getOperator() != clang::OO_Equal || call->getNumArgs() != 2) return;
  const clang::Expr* from = call->getArg(1);
  const std::string holder = holders_.of(call->getArg(0));
  if (from->isLValue() && is_stock_or_twin(from->getType()))
    return is_container || homes_.is_new_entry(call->getArg(0))
               ? give(from, holder, "assigned to '" + unit_.text(call->getArg(0)) + "'")
               : void();
  if (!from->isLValue()) give(from, holder, "moved to '" + unit_.text(call->getArg(0)) + "'");
  if (!hand_on(from, holder) && is_container) make_in(holder, "=", call);
}

/// A copy for a parameter, or for the caller.
void GivenMessages::construction(const clang::CXXConstructExpr* construct) {
  if (!construct->getConstructor()->isCopyOrMoveConstructor()) return;
  const clang::Stmt* inner = construct;
  const clang::Stmt* around = view_.parent(inner);
  while (llvm::isa_and_nonnull<clang::CastExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                               clang::CXXBindTemporaryExpr, clang::CXXConstructExpr>(around)) {
    inner = around;
    around = view_.parent(around);
  }
  if (llvm::isa_and_nonnull<clang::ReturnStmt>(around) && !view_.lambda_around(around))
    return give(construct->getArg(0), result_root(function_),
                "returned from '" + view_.function()->getNameAsString() + "'");
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
  const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
  if (!unit_.declares(callee) || llvm::isa<clang::CXXOperatorCallExpr>(call)) return;
  for (unsigned i = 0; i < call->getNumArgs(); ++i)
    if (call->getArg(i) == inner)
      give(construct->getArg(0), parameter_root(usr_of(pattern_of(callee)), i),
           "passed to '" + callee->getNameAsString() + "'");
}

/// std::optional<Image> latest = image, std::vector<Image> frames(3, image), F{image, 1}: a copy becomes part of a new object, by the message's
/// own constructor or by one of a library that is given the message. Of what callers give, nothing tells here whether it was published: a copy
/// of it that is returned in such an object counts as one that was not.
void GivenMessages::copies(const clang::CXXConstructExpr* construct) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  const bool is_message = is_stock_or_twin(construct->getType());
  const bool is_copy = is_message ? constructor->isCopyConstructor()
                                  : !unit_.declares(constructor) && holds_messages(construct->getType());
  if (!is_copy) return;
  for (const clang::Expr* argument : construct->arguments()) {
    if (!argument->isLValue() || !is_stock_or_twin(argument->getType())) continue;
    const CopyHome home = homes_.of(construct);
    if (home.holder == result_root(function_) && is_parameter(parts_.part_of(argument)))
      facts_.given.messages.push_back(
          {{}, home.holder, home.how, unit_.location(argument->getBeginLoc()), true});
    else
      give(argument, home.holder, home.how);
  }
}

void GivenMessages::look_at(const clang::Stmt* stmt) {
  if (const auto* statement = llvm::dyn_cast<clang::DeclStmt>(stmt)) return declaration(statement);
  if (const auto* statement = llvm::dyn_cast<clang::ReturnStmt>(stmt)) return result(statement);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) {
    copies(construct);
    return construction(construct);
  }
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(stmt)) return assignment(op);
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(stmt)) member_call(method);
  if (const auto* function = llvm::dyn_cast<clang::CallExpr>(stmt)) call(function);
}

}  // namespace

void note_given_messages(const Unit& unit, const FunctionView& view, EscapeFacts& facts) {
  GivenMessages finder(unit, view, facts);
  for (const clang::Stmt* stmt : view.statements()) finder.look_at(stmt);
}

}  // namespace tzc::rewriter
