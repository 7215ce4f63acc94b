// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "facts/escape/escape_context.h"
#include "facts/escape/publish_events.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// How an expression refers to a message's data.
enum class Reference {
  array,     ///< the array itself: stays right across a publish
  elements,  ///< pointer, reference or iterator to elements: does not
  view,      ///< an object of a library that points to elements
};

/// An expression that refers to data, on its way up through the expressions around it.
struct Referring {
  const clang::Expr* expr = nullptr;
  Reference how = Reference::array;
  bool read_only = false;  ///< got through const access: a later write to the array may leave it behind
  std::vector<EntityId> messages;
};

/// A variable that refers to data.
struct Holder {
  const clang::VarDecl* variable;  ///< null: a value without a name
  Reference how;
  bool read_only;
  std::vector<EntityId> messages;
};

/// Follows everything that refers to a message's data, from the array upwards, until it ends in something known
/// to be harmless. All else is an escape. See docs/rewriter.md for the property that this gives.
class EscapeAnalysis {
 public:
  explicit EscapeAnalysis(EscapeContext& context) : context_(context) {}

  /// A function with a body, not a lambda: those are looked at within the function around them.
  SeenFunction analyse(const clang::FunctionDecl* definition);
  /// Whether an array's mention was part of a function that was analysed.
  bool has_seen(const clang::MemberExpr* array) const { return seen_.count(array) != 0; }
  void escape(const std::vector<EntityId>& messages, const std::string& how, clang::SourceLocation where,
              bool ends_with_scope);

  /// A variable of a function now refers to data, too.
  void hold(const FunctionView& view, const Holder& holder);
  /// A local vector gives its elements to the array: what points to them points into the message.
  void take(const FunctionView& view, const clang::VarDecl* vector, const clang::Expr* at,
            const std::vector<EntityId>& messages);
  /// A cast makes what refers to const data writable.
  void cast_const_away(const Referring& what);
  /// The argument refers to data, and the function's body is there. False: it cannot be followed.
  bool follow(const clang::FunctionDecl* function, unsigned argument, const Referring& what);
  /// Once all functions are analysed: compares what const access gave with writes through other names of the array.
  void finish();

 private:
  struct Analysed {
    std::unique_ptr<FunctionView> view;
    std::vector<SeenEvent> events;
    std::vector<SeenEvent> writes;        ///< to arrays of messages
    std::vector<SeenEvent> named_writes;  ///< through variables that are, or refer to, such an array
    std::vector<Holder> readers;          ///< got through const access
    std::vector<Referring> read;          ///< likewise, without a name
  };
  Analysed& analysed(const clang::FunctionDecl* definition);
  void note_writes(const FunctionView& view, const Holder& array);
  void note_lasting(const clang::Stmt* stmt);
  void start(const FunctionView& view, const clang::Stmt* stmt);
  void check_types(const FunctionView& view);
  void climb(const FunctionView& view, const Referring& from);
  void check_expression(const FunctionView& view, const Referring& born);
  void check_expression(const FunctionView& view, const Referring& born,
                        const std::vector<SeenEvent>& events);
  void check_holder(const FunctionView& view, const Holder& holder);
  void check_events(const FunctionView& view, const Holder& holder, const std::vector<SeenEvent>& events);
  void add_hold(const Holder& holder, const PublishEvent& event, clang::SourceLocation where);

  EscapeContext& context_;
  std::map<const clang::FunctionDecl*, Analysed> functions_;
  std::set<const clang::Stmt*> seen_;
  std::set<std::string> held_;  // variable, message and kind of each holder: each is followed once
};

/// Whether objects of a type can point to elements that they do not own.
bool may_hold_pointer(clang::QualType type);
/// The class of a library that is known to point to elements.
bool is_view(clang::QualType type);

/// Climbs from `from` to where the value ends. What it meets on the way is reported to `analysis`. Returns the
/// first expression that refers to elements; its expression is null: all of them refer to the array.
Referring climb_reference(EscapeContext& context, const FunctionView& view, EscapeAnalysis& analysis,
                          const Referring& from);

/// Records what happens between an event and the end of the message's life, when that may write through a
/// pointer.
void note_tail(EscapeContext& context, const FunctionView& view, const std::vector<SeenEvent>& events,
               const SeenEvent& event);

}  // namespace tzc::rewriter
