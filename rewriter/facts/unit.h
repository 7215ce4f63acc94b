// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>
#include <clang/AST/ExprCXX.h>

#include <optional>
#include <string>
#include <vector>

#include "facts/facts.h"
#include "facts/message_type.h"
#include "facts/source.h"
#include "rules/rule.h"

namespace tzc::rewriter {

/// A place that names a publisher, while its AST is still there: a publish call, or an argument.
struct SeenPublisher {
  const clang::Expr* object;  ///< the expression that names it
  bool pointer;
  Key key;
  std::vector<Key> messages;  ///< that are published there
  const clang::FunctionDecl* function;
  unsigned begin;
};

/// A birth while its AST is still there.
struct SeenBirth {
  Birth birth;
  const clang::FunctionDecl* function;
};

/// A member or global message that is published or handed on as a whole.
struct SeenMember {
  Key key;
  const clang::Expr* expr;
  const clang::FunctionDecl* function;
};

/// What the collectors of one translation unit share.
struct Unit {
  Source source;
  const RuleSet& rules;
  Facts& facts;
  std::set<std::string> exported_dirs;    ///< of headers that other packages may include
  std::vector<std::string> include_dirs;  ///< where headers are looked for
  std::vector<SeenPublisher> publishers;
  std::vector<SeenBirth> births;
  std::vector<SeenMember> members;

  clang::ASTContext& ast() const { return source.ast(); }
};

// Names
// ------------------------------------------------------------------------------------------------------------

std::string qualified_name_of(const clang::NamedDecl* decl);
std::string usr_of(const clang::Decl* decl);
/// The function that a template instance was made from, else itself.
const clang::FunctionDecl* pattern_of(const clang::FunctionDecl* function);
/// The innermost function or lambda around a node; null outside of functions.
const clang::FunctionDecl* function_around(Unit& unit, const clang::Stmt& stmt);
std::string record_usr_of(const clang::FunctionDecl* function);

/// Whether the TZC header of a message can be included: "sensor_msgs/Image".
bool has_twin(const Unit& unit, const std::string& message);

// Entities
// ---------------------------------------------------------------------------------------------------------

/// The entity of a variable, member or parameter of the package, made known to the facts. Empty: it carries
/// nothing.
Key declare(Unit& unit, const clang::ValueDecl* decl);
/// The entity of a function's result. Empty: it carries nothing.
Key declare_result(Unit& unit, const clang::FunctionDecl* function);
/// The entity of an expression that names its type: new M, M(), make_shared<M>(), a cast.
Key declare_temporary(Unit& unit, const clang::Expr* expr);
bool is_package_function(Unit& unit, const clang::FunctionDecl* function);

/// Adds to `entity` the edits that give `type` its ported spelling, or the obstacles.
void retype(Unit& unit, clang::TypeLoc type, Entity& entity);

// Values
// -----------------------------------------------------------------------------------------------------------

/// Which entities an expression's value comes from.
struct Sources {
  std::vector<Key> keys;
  bool foreign = false;  ///< also from something outside the package
};
Sources sources_of(Unit& unit, const clang::Expr* expr);

void add_flow(Unit& unit, const Key& from, const Key& to, clang::SourceLocation where,
              const std::string& what);
void add_obstacle(Unit& unit, const Key& key, const char* code, const std::string& reason,
                  clang::SourceLocation where);

/// Without default arguments.
unsigned written_arguments(const clang::CallExpr* call);
/// make_shared, make_unique and their likes.
bool makes_object(const clang::CallExpr* call);
/// std::move and its likes: the result is the argument.
bool passes_through(const clang::FunctionDecl* function);

// Calls
// ------------------------------------------------------------------------------------------------------------

/// The object of a member call as it is written, without the arrow's dereference.
struct Receiver {
  const clang::Expr* expr = nullptr;
  bool pointer = false;
};
Receiver receiver_of(const clang::CXXMemberCallExpr* call);
/// The edits that turn `object.method<T>(a)` into `to<T>(object, a)`; empty: they can not be made.
std::vector<Change> receiver_first(Unit& unit, const clang::CXXMemberCallExpr* call, const std::string& to,
                                   const char* rule, const char* header, const std::string& last = "");
/// As written between < and >; empty: none written.
std::string written_template_arguments(Unit& unit, const clang::CXXMemberCallExpr* call);
std::optional<std::string> constant_string(const clang::Expr* expr);
/// The message that ros::AdvertiseOptions or SubscribeOptions were made for; none: not to be seen in this
/// function.
std::optional<clang::QualType> options_message(Unit& unit, const clang::Expr* options);
std::string function_name_around(Unit& unit, const clang::Stmt& stmt);

// Collectors
// -------------------------------------------------------------------------------------------------------

/// Whether a cast away from const only serves a field beside the arrays: that part of a view is private
/// memory.
bool serves_plain_field(Unit& unit, const clang::Expr* cast);

/// const_cast of a message: who receives it may write to it.
void check_const_cast(Unit& unit, const clang::ExplicitCastExpr* cast);

/// Where a followed value ended up.
struct Sink {
  const clang::VarDecl* variable = nullptr;  ///< initialised by it
  const clang::Expr* target = nullptr;       ///< assigned or reset to it
  const clang::Expr* statement = nullptr;    ///< the assignment
  const clang::CXXMemberCallExpr* publish = nullptr;
};

/// Follows the value of `leaf`, which is `key`, to where it ends up: flows, uses, obstacles.
Sink follow_use(Unit& unit, const clang::Expr* leaf, const Key& key);

/// What becomes of a value handed to a function: a flow, an edit, an obstacle.
enum class Handed { done, result };  ///< result: the call's value is the argument's
Handed hand_to_call(Unit& unit, const Key& key, const clang::CallExpr* call, unsigned argument);
Handed hand_to_constructor(Unit& unit, const Key& key, const clang::CXXConstructExpr* construct,
                           unsigned argument);

bool is_publisher_class(const std::string& name);
/// A new object: new M, make_shared<M>(), M(), toImageMsg(), and where it went.
void collect_object_birth(Unit& unit, const clang::Expr* expr, const Key& key, const Sink& sink);
void collect_publish(Unit& unit, const clang::CXXMemberCallExpr* call);
void collect_advertise(Unit& unit, const clang::CXXMemberCallExpr* call, const MethodCall& rule);
void collect_subscribe(Unit& unit, const clang::CXXMemberCallExpr* call, const MethodCall& rule);
/// What `rule` wrote in an earlier run: tzc::advertise<M>(nh, ...), tzc::subscribe(nh, ...).
void collect_ported_advertise(Unit& unit, const clang::CallExpr* call, const MethodCall& rule);
void collect_ported_subscribe(Unit& unit, const clang::CallExpr* call, const MethodCall& rule);
/// subscribe() of a filter object.
void collect_filter(Unit& unit, const clang::CXXMemberCallExpr* call);
void collect_filter(Unit& unit, const clang::CXXConstructExpr* construct, const Key& filter);
/// The entity that a constructed filter becomes.
Key filter_of(Unit& unit, const clang::CXXConstructExpr* construct);
/// make_shared<message_filters::Subscriber<M>>(nh, "topic", 1)
void collect_made_filter(Unit& unit, const clang::CallExpr* call, const clang::CXXRecordDecl* record,
                         const Key& filter);
/// registerCallback() of a filter: whether the callback may write.
void collect_registered_callback(Unit& unit, const clang::CXXMemberCallExpr* call);
void note_writing_callback(Unit& unit, const clang::Stmt* stmt, const std::string& scope);
/// Functions that build messages for others, and their calls.
void collect_helper(Unit& unit, const clang::FunctionDecl* function);
void collect_helper_call(Unit& unit, const clang::CallExpr* call);
/// Classes and functions of libraries that publish or subscribe by themselves: named in the report.
void collect_library_construction(Unit& unit, const clang::CXXConstructExpr* construct);
void collect_library_member_call(Unit& unit, const clang::CXXMemberCallExpr* call);
void collect_wait_for_message(Unit& unit, const clang::CallExpr* call);
void collect_declaration_birth(Unit& unit, const clang::VarDecl* variable);
/// Pointers into data that live longer than the data stays where it is.
void collect_aliases(Unit& unit, const clang::FunctionDecl* function);
/// The zero-fill of a resize that is not needed, because what follows writes every element.
void collect_overwrite(Unit& unit, const clang::CXXMemberCallExpr* resize, const std::vector<Key>& keys);
/// Whether a publisher can be named earlier in its function, at an offset.
enum class Naming { none, guarded, safe };  ///< guarded: by a smart pointer that may be null there
Naming naming_at(Unit& unit, const SeenPublisher& publisher, unsigned at);
/// How it is named there.
std::string name_text(Unit& unit, const SeenPublisher& publisher);
/// At the end: which publishers can be named where messages are born.
void connect_births(Unit& unit);

/// Everything of one translation unit.
void collect(Unit& unit);

}  // namespace tzc::rewriter
