// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content_events.h"

#include <clang/Analysis/CFG.h>

#include <set>

#include "facts/calls.h"
#include "facts/decided_branches.h"
#include "facts/message_parts.h"
#include "facts/message_type.h"
#include "facts/overwrites.h"

namespace tzc::rewriter {
namespace {

using Kind = ContentEvent::Kind;

/// array = std::move(vector), array = function()
bool takes_elements(const clang::CXXOperatorCallExpr* assignment) {
  const clang::FunctionDecl* function = assignment->getDirectCallee();
  return function && function->getNumParams() == 1 &&
         function->getParamDecl(0)->getType()->isRValueReferenceType();
}

/// std::vector<T>(), {}
bool is_made_empty(const clang::Expr* source) {
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(source->IgnoreUnlessSpelledInSource());
  return made && made->getNumArgs() == 0;
}

const clang::Stmt* use_of(const FunctionView& view, const clang::Stmt* expr) {
  const clang::Stmt* around = view.parent(expr);
  while (llvm::isa_and_nonnull<clang::ParenExpr, clang::ImplicitCastExpr>(around))
    around = view.parent(around);
  return around;
}

/// Reads the events of one function's statements.
class EventReader {
 public:
  EventReader(const Unit& unit, const FunctionView& view) : unit_(unit), view_(view), parts_(unit, view) {}

  std::vector<ContentEvent> events_of(const clang::Stmt* stmt) {
    events_.clear();
    look_at(stmt);
    return std::move(events_);
  }

 private:
  void look_at(const clang::Stmt* stmt);
  void array(const clang::Expr* expr);
  void array_of_messages(const clang::Expr* expr);
  void replaced(const clang::Expr* array, const clang::Expr* source);
  void array_method(const clang::Expr* array, const clang::CXXMemberCallExpr* call, const std::string& name);
  void declaration(const clang::DeclStmt* stmt);
  void assignment(const clang::CXXOperatorCallExpr* call);
  void member_call(const clang::CXXMemberCallExpr* call);
  void iterator(const clang::CXXConstructExpr* construct);
  void made(const clang::CXXRecordDecl* record, clang::SourceLocation where);
  void publish(const clang::CXXMemberCallExpr* call);
  bool rule_call(const clang::CallExpr* call, const std::string& name);
  void package_call(const clang::FunctionDecl* function, llvm::ArrayRef<const clang::Expr*> arguments,
                    const clang::Stmt* at);
  void closure(const clang::LambdaExpr* lambda);
  void add(Kind kind, MessagePart part, clang::SourceLocation where) {
    if (part.empty()) return;
    ContentEvent event;
    event.kind = kind;
    event.part = std::move(part);
    event.where = unit_.location(where);
    events_.push_back(std::move(event));
  }

  const Unit& unit_;
  const FunctionView& view_;
  MessageParts parts_;
  std::vector<ContentEvent> events_;
  std::set<const clang::LambdaExpr*> open_;
};

void EventReader::array_method(const clang::Expr* array, const clang::CXXMemberCallExpr* call,
                               const std::string& name) {
  static const std::set<std::string> replaces = {"clear", "assign"};
  static const std::set<std::string> keeps = {"resize", "reserve", "shrink_to_fit", "bind"};
  const bool is_const = call->getMethodDecl()->isConst();
  if (is_const) return;
  if (name == "swap") return replaced(array, call->getArg(0));
  bool resets = replaces.count(name) != 0;
  if (name == "resize") {
    const auto* size = llvm::dyn_cast<clang::IntegerLiteral>(call->getArg(0)->IgnoreParenImpCasts());
    resets =
        (size && size->getValue() == 0) || written_arguments(call) == 2 || without_zero_fill(unit_, call);
    if (written_arguments(call) == 2) {
      const clang::CXXRecordDecl* tag = call->getArg(1)->getType()->getAsCXXRecordDecl();
      resets = tag && tag->getName() == "uninitialized_t";
    }
  }
  if (resets) return add(Kind::reset, parts_.part_of(array), call->getExprLoc());
  if (keeps.count(name) == 0) add(Kind::write, parts_.part_of(array), call->getExprLoc());
}

/// The array is given another one's elements: they lie in shared memory where that is a message's.
void EventReader::replaced(const clang::Expr* array, const clang::Expr* source) {
  const bool of_message = parts_.part_of(source).find('/') != MessagePart::npos;
  add(of_message || is_made_empty(source) ? Kind::reset : Kind::take, parts_.part_of(array),
      array->getExprLoc());
}

/// A mention of an array: replaced as a whole, or its elements are reached for writing.
void EventReader::array(const clang::Expr* expr) {
  if (is_only_read(view_, expr)) return;
  const clang::Stmt* use = use_of(view_, expr);
  if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(use)) {
    const auto* call = llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(view_.parent(member));
    if (call) array_method(expr, call, member->getMemberDecl()->getNameAsString());
    return;
  }
  if (const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(use)) {
    if (op->isComparisonOp()) return;
    const bool is_source = op->isAssignmentOp() && op->getArg(0)->IgnoreParenImpCasts() != expr;
    if (is_source) return;
    if (op->isAssignmentOp() && takes_elements(op)) return replaced(expr, op->getArg(1));
    return add(op->isAssignmentOp() ? Kind::reset : Kind::write, parts_.part_of(expr), expr->getExprLoc());
  }
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(use);
  if (call && (unit_.declares(call->getDirectCallee()) || passes_through(call->getDirectCallee()))) return;
  if (llvm::isa_and_nonnull<clang::DeclStmt, clang::CXXConstructExpr>(use))
    return;  // another name, or a copy
  add(Kind::write, parts_.part_of(expr), expr->getExprLoc());
}

/// Elements that it gets have arrays of their own, which allocate has not seen: they lie outside shared memory.
void EventReader::array_of_messages(const clang::Expr* expr) {
  static const std::set<std::string> adds_none = {"reserve", "begin", "end",  "rbegin", "rend",    "front",
                                                  "back",    "at",    "data", "erase",  "pop_back"};
  if (is_only_read(view_, expr)) return;
  const clang::Stmt* use = use_of(view_, expr);
  if (llvm::isa_and_nonnull<clang::DeclStmt, clang::CXXConstructExpr>(use))
    return;  // another name, or a copy
  if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(use)) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
    const std::string name = member->getMemberDecl()->getNameAsString();
    if (name == "clear") return add(Kind::reset, parts_.part_of(expr), expr->getExprLoc());
    if (!method || method->isConst() || adds_none.count(name) != 0) return;
  }
  const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(use);
  if (op && (!op->isAssignmentOp() || op->getArg(0)->IgnoreParenImpCasts() != expr)) return;
  add(Kind::take, parts_.part_of(expr), expr->getExprLoc());
}

void EventReader::declaration(const clang::DeclStmt* stmt) {
  for (const clang::Decl* decl : stmt->decls()) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
    if (!variable || variable->isStaticLocal() || variable->getType()->isReferenceType()) continue;
    add(Kind::reset, parts_.root_of(variable), variable->getLocation());
  }
}

bool is_message_or_pointer(clang::QualType type) {
  const clang::QualType pointee = pointee_of(type);
  return is_stock_or_twin(pointee.isNull() ? type : pointee);
}

void EventReader::assignment(const clang::CXXOperatorCallExpr* call) {
  if (call->getOperator() != clang::OO_Equal || !is_message_or_pointer(call->getArg(0)->getType())) return;
  const MessagePart part = parts_.part_of(call->getArg(0));
  add(Kind::reset, part, call->getExprLoc());
  if (!part.empty())
    events_.back().empties = is_stock_or_twin(call->getArg(0)->getType()) && is_made_empty(call->getArg(1));
}

void EventReader::publish(const clang::CXXMemberCallExpr* call) {
  for (const clang::Expr* argument : call->arguments()) {
    if (!is_message_or_pointer(argument->getType())) continue;
    add(Kind::publish, parts_.part_of(argument), call->getExprLoc());
    const Place place = unit_.source.where(call->getExprLoc());
    if (!events_.empty()) events_.back().site = {place.file, place.begin};
  }
}

/// A function of a library that fills a message as a whole, or what an earlier run made of it.
bool EventReader::rule_call(const clang::CallExpr* call, const std::string& name) {
  for (const LibraryCall* rule : unit_.rules.calls) {
    if ((name != rule->function && name != rule->to) || rule->argument >= call->getNumArgs()) continue;
    const MessagePart part = parts_.part_of(call->getArg(rule->argument));
    if (rule->elements == LibraryCall::Elements::filled) add(Kind::reset, part, call->getExprLoc());
    if (rule->elements == LibraryCall::Elements::of_vector) add(Kind::take, part, call->getExprLoc());
    return true;
  }
  for (const MethodCall* rule : unit_.rules.methods) {
    const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
    const bool is_meant =
        rule->role == MethodCall::Role::fills_message &&
        (name == rule->to || (member && name == std::string(rule->object) + "::" + rule->method));
    if (!is_meant) continue;
    for (const clang::Expr* argument : call->arguments())
      if (is_message_or_pointer(argument->getType()))
        add(Kind::reset, parts_.part_of(argument), call->getExprLoc());
    return true;
  }
  return false;
}

void EventReader::package_call(const clang::FunctionDecl* function,
                               llvm::ArrayRef<const clang::Expr*> arguments, const clang::Stmt* at) {
  ContentEvent event;
  event.kind = Kind::call;
  event.callee = usr_of(pattern_of(function));
  event.where = unit_.location(at->getBeginLoc());
  for (unsigned i = 0; i < arguments.size() && i < function->getNumParams(); ++i) {
    const clang::QualType type = arguments[i]->getType();
    if (!is_message_or_pointer(type) && !is_stock_or_twin_array(type)) continue;
    if (MessagePart part = parts_.part_of(arguments[i]); !part.empty())
      event.passed.emplace(parameter_root(event.callee, i), std::move(part));
  }
  events_.push_back(std::move(event));
}

void EventReader::member_call(const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method) return;
  if (is_publish(call)) return publish(call);
  const clang::Expr* object = call->getImplicitObjectArgument();
  const std::string name = method->getNameAsString();
  if ((name == "reset" || name == "swap") && object && is_message_or_pointer(object->getType()))
    add(Kind::reset, parts_.part_of(object), call->getExprLoc());
}

/// sensor_msgs::PointCloud2Iterator it(cloud, "x")
void EventReader::iterator(const clang::CXXConstructExpr* construct) {
  const std::string name = construct->getConstructor()->getParent()->getNameAsString();
  if (name != "PointCloud2Iterator" || construct->getNumArgs() < 2) return;
  const MessagePart cloud = parts_.part_of(construct->getArg(0));
  if (!cloud.empty()) add(Kind::write, cloud + "/data", construct->getBeginLoc());
}

/// An object of the class comes into being, and the messages that it consists of with it.
void EventReader::made(const clang::CXXRecordDecl* record, clang::SourceLocation where) {
  if (!record || !record->hasDefinition() || !unit_.source.in_package(record->getLocation())) return;
  for (const clang::CXXBaseSpecifier& base : record->bases())
    made(base.getType()->getAsCXXRecordDecl(), where);
  for (const clang::FieldDecl* field : record->fields()) {
    if (is_stock_or_twin(field->getType()) && !field->getType()->isReferenceType())
      add(Kind::make, parts_.root_of(field), where);
    else
      made(field->getType()->getAsCXXRecordDecl(), where);
  }
}

/// A closure may be called where it is made, and again: its body's events, twice, in the order of the source.
void EventReader::closure(const clang::LambdaExpr* lambda) {
  if (!open_.insert(lambda).second) return;
  for (int time = 0; time < 2; ++time)
    for (const clang::Stmt* stmt : view_.statements())
      if (view_.lambda_around(stmt) == lambda) look_at(stmt);
  open_.erase(lambda);
}

void EventReader::look_at(const clang::Stmt* stmt) {
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt)) return this->declaration(declaration);
  if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt)) return closure(lambda);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) {
    iterator(construct);
    if (!construct->getConstructor()->isCopyOrMoveConstructor())
      made(construct->getConstructor()->getParent(), construct->getBeginLoc());
    if (unit_.declares(construct->getConstructor()))
      package_call(construct->getConstructor(), {construct->getArgs(), construct->getNumArgs()}, construct);
    return;
  }
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) {
    const clang::FunctionDecl* function = call->getDirectCallee();
    if (makes_object(call)) made(pointee_of(call->getType())->getAsCXXRecordDecl(), call->getBeginLoc());
    if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call)) assignment(op);
    if (const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) member_call(member);
    if (!function || rule_call(call, qualified_name_of(function)) || !unit_.declares(function)) return;
    const bool shifted =
        llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(function);
    llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
    return package_call(function, shifted ? arguments.drop_front() : arguments, call);
  }
  const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
  if (!expr || !llvm::isa<clang::MemberExpr, clang::DeclRefExpr>(expr)) return;
  if (is_stock_or_twin_array(expr->getType())) array(expr);
  if (is_array_of_data_parts(expr->getType())) array_of_messages(expr);
}

/// Blocks in Clang's order, the entry first.
ContentFlow flow_of(const clang::CFG& cfg, EventReader& reader, const DecidedValues& values) {
  ContentFlow flow;
  flow.blocks.resize(cfg.size());
  const auto index = [&](const clang::CFGBlock& block) { return cfg.size() - 1 - block.getBlockID(); };
  for (const clang::CFGBlock* block : cfg) {
    ContentBlock& mine = flow.blocks[index(*block)];
    for (const clang::CFGElement& element : *block)
      if (const auto stmt = element.getAs<clang::CFGStmt>())
        for (ContentEvent& event : reader.events_of(stmt->getStmt())) mine.events.push_back(std::move(event));
    unsigned successor = 0;
    for (const clang::CFGBlock::AdjacentBlock& next : block->succs()) {
      const clang::CFGBlock* const reached = next.getReachableBlock();
      if (reached && may_go(*block, successor, values)) mine.next.push_back(index(*reached));
      ++successor;
    }
  }
  flow.exit = index(cfg.getExit());
  return flow;
}

/// The flow of a function of the view, or of a closure in it; none: it has no events.
std::optional<ContentFlow> flow_of(const Unit& unit, const FunctionView& view,
                                   const clang::FunctionDecl* function) {
  clang::CFG::BuildOptions options;
  options.setAllAlwaysAdd();
  options.AddInitializers = true;
  const std::unique_ptr<clang::CFG> cfg =
      clang::CFG::buildCFG(function, function->getBody(), &unit.ast(), options);
  if (!cfg) return {};
  EventReader reader(unit, view);
  const std::vector<DecidedValues> ways = decided_ways(view, *cfg);
  ContentFlow flow = flow_of(*cfg, reader, ways.front());
  for (auto way = std::next(ways.begin()); way != ways.end(); ++way)
    flow.add_alternative(flow_of(*cfg, reader, *way));
  const bool is_empty =
      llvm::all_of(flow.blocks, [](const ContentBlock& block) { return block.events.empty(); });
  return is_empty ? std::nullopt : std::optional(std::move(flow));
}

}  // namespace

std::optional<ContentFlow> content_flow(const Unit& unit, const FunctionView& view) {
  std::optional<ContentFlow> flow = flow_of(unit, view, view.function());
  const bool has_lambda = llvm::any_of(
      view.statements(), [](const clang::Stmt* stmt) { return llvm::isa<clang::LambdaExpr>(stmt); });
  if (flow) flow->makes_object = llvm::isa<clang::CXXConstructorDecl>(view.function()) && !has_lambda;
  return flow;
}

std::optional<ContentFlow> content_flow(const Unit& unit, const FunctionView& view,
                                        const clang::LambdaExpr* closure) {
  return flow_of(unit, view, closure->getCallOperator());
}

}  // namespace tzc::rewriter
