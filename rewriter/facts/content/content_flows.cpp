// SPDX-License-Identifier: BSD-3-Clause
#include <clang/Analysis/CFG.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "facts/content/content_events.h"
#include "facts/content/content_reader.h"
#include "facts/content/decided_branches.h"
#include "facts/content/handlers.h"

namespace tzc::rewriter {
namespace {

constexpr std::size_t many_blocks = 4096;  // of a function's graph, or of what one call may run

using Given = std::vector<std::pair<MessagePart, MessagePart>>;

/// What lies in a part lies in another instead.
void rename(const Given& given, MessagePart& part) {
  for (const auto& [from, to] : given) {
    const bool is_inside =
        part.compare(0, from.size(), from) == 0 &&
        (part.size() == from.size() || part[from.size()] == '/' || part[from.size()] == '[');
    if (is_inside) return void(part.replace(0, from.size(), to));
  }
}

void rename(const Given& given, ContentEvent& event) {
  rename(given, event.part);
  rename(given, event.other);
  for (auto& [parameter, part] : event.passed) rename(given, part);
}

std::unique_ptr<clang::CFG> cfg_of(const Unit& unit, const clang::FunctionDecl* function) {
  clang::CFG::BuildOptions options;
  options.setAllAlwaysAdd();
  options.AddInitializers = true;
  options.AddImplicitDtors = true;
  return clang::CFG::buildCFG(function, function->getBody(), &unit.ast(), options);
}

/// Puts one function's graph together, and those of its closures where their bodies run.
class FlowBuilder {
 public:
  FlowBuilder(EscapeContext& context, const SeenFunction& function, const DecidedValues& values)
      : context_(context),
        values_(values),
        own_view_(function.view),
        own_reader_(context, function.view, UnknownCalls(function.events)),
        reader_(&own_reader_),
        parts_(context.unit, function.view),
        run_elsewhere_(bodies_run_elsewhere(function.view)) {}
  FlowBuilder(const FlowBuilder&) = delete;
  FlowBuilder& operator=(const FlowBuilder&) = delete;

  ContentFlow build(const clang::CFG& cfg, const clang::FunctionDecl* function) {
    open_.insert(function);
    flow_.exit = add(cfg, function).exit;
    return std::move(flow_);
  }
  /// When it calls what it does not know; none: never.
  const std::optional<IfShown>& calls_unknown() const { return unknown_.any; }

 private:
  /// The blocks at which a part of the graph begins and ends.
  struct Part {
    unsigned entry = 0, exit = 0;
  };
  /// What calls may run: one graph for each, until they have too many blocks together.
  struct AnyCode {
    std::size_t blocks = 0;
    std::optional<Part> shared;
  };
  /// Calls that are not followed.
  struct UnknownCode {
    AnyCode always, hidden;          ///< hidden code that nobody shows takes no room from the rest
    std::optional<Part> open;        ///< what is being added, and what calls in it run
    std::vector<MessagePart> roots;  ///< of the closure that is being added then
    std::optional<unsigned> behind;  ///< where the graph goes on behind the last call
    IfShown last;                    ///< when that one happens
    std::optional<IfShown> any;      ///< when one of them happens; none: never
  };

  unsigned new_block() {
    flow_.blocks.emplace_back();
    return static_cast<unsigned>(flow_.blocks.size() - 1);
  }
  void connect(unsigned from, unsigned to) { flow_.blocks[from].next.push_back(to); }

  Part add(const clang::CFG& cfg, const clang::FunctionDecl* function);
  unsigned add(std::vector<ContentStep> steps, unsigned at);
  unsigned add(const clang::CFGElement& element, const clang::FunctionDecl* function, unsigned at);
  unsigned perhaps(Part part, unsigned at);
  unsigned may_leave(unsigned at, unsigned handlers);
  unsigned run(const ClosureRun& closure, unsigned at);
  Part graph_of(const clang::FunctionDecl* closure);
  unsigned call(const PerhapsCall& perhaps_called, unsigned at);
  unsigned call_unknown(const IfShown& if_shown, unsigned at);
  Part anything(AnyCode& calls);
  void add_closures(Part any);
  unsigned back_in_closure(unsigned behind);
  void append(ContentEvent event, unsigned at);
  Part body_of(const clang::FunctionDecl* closure);
  Part add_instance(const clang::CFG& cfg, const clang::FunctionDecl* closure);

  EscapeContext& context_;
  const DecidedValues& values_;
  const FunctionView& own_view_;
  ContentReader own_reader_;
  ContentReader* reader_;  ///< of the function, or of the instance of a generic closure that is being added
  const MessageParts parts_;
  ContentFlow flow_;
  std::vector<Given> given_;                   ///< of the closures around, the innermost last
  std::set<const clang::FunctionDecl*> open_;  ///< which are being added
  std::vector<const clang::FunctionDecl*>
      run_elsewhere_;  ///< bodies of closures that an unknown call may run
  UnknownCode unknown_;
  std::map<std::pair<const clang::FunctionDecl*, std::vector<Given>>, Part> shared_;
};

/// Blocks in Clang's order, the entry first.
FlowBuilder::Part FlowBuilder::add(const clang::CFG& cfg, const clang::FunctionDecl* function) {
  const auto first = static_cast<unsigned>(flow_.blocks.size());
  flow_.blocks.resize(flow_.blocks.size() + cfg.size());
  const auto index = [&](const clang::CFGBlock& block) {
    return first + cfg.size() - 1 - block.getBlockID();
  };
  const Handlers caught(cfg, function->getBody());
  for (const clang::CFGBlock* block : cfg) {
    unsigned at = index(*block);
    if (block == &cfg.getEntry()) at = add(reader_->steps_of(function), at);
    if (const auto* handler = llvm::dyn_cast_or_null<clang::CXXCatchStmt>(block->getLabel()))
      at = add(reader_->steps_of(handler), at);
    const clang::CFGBlock* tried = nullptr;
    for (const clang::CFGElement& element : *block) {
      const clang::CFGBlock* const handlers = caught.around(element);
      if (handlers && handlers != tried) at = may_leave(at, index(*handlers));
      const unsigned before = std::exchange(at, add(element, function, at));
      const bool happened = at != before || !flow_.blocks[at].events.empty();
      if (handlers && happened) at = may_leave(at, index(*handlers));
      tried = handlers;
    }
    unsigned successor = 0;
    for (const clang::CFGBlock::AdjacentBlock& next : block->succs()) {
      const clang::CFGBlock* const reached = next.getReachableBlock();
      if (reached && may_go(*block, successor, values_)) connect(at, index(*reached));
      ++successor;
    }
  }
  return {index(cfg.getEntry()), index(cfg.getExit())};
}

/// Adds what happens at the end of a block, and says where the graph goes on.
unsigned FlowBuilder::add(const clang::CFGElement& element, const clang::FunctionDecl* function,
                          unsigned at) {
  if (const auto stmt = element.getAs<clang::CFGStmt>()) return add(reader_->steps_of(stmt->getStmt()), at);
  if (const auto initializer = element.getAs<clang::CFGInitializer>())
    return add(reader_->steps_of(initializer->getInitializer()), at);
  if (const auto ended = element.getAs<clang::CFGAutomaticObjDtor>())
    return add(reader_->steps_at_end_of(ended->getVarDecl()), at);
  if (element.getAs<clang::CFGMemberDtor>() || element.getAs<clang::CFGBaseDtor>())
    return add(reader_->steps_at_end_of_parts(function), at);
  return at;
}

unsigned FlowBuilder::add(std::vector<ContentStep> steps, unsigned at) {
  for (ContentStep& step : steps) {
    if (auto* event = std::get_if<ContentEvent>(&step))
      append(std::move(*event), at);
    else if (const auto* closure = std::get_if<ClosureRun>(&step))
      at = run(*closure, at);
    else if (const auto* called = std::get_if<PerhapsCall>(&step))
      at = call(*called, at);
    else if (const auto* unknown = std::get_if<UnknownCall>(&step))
      at = call_unknown(unknown->if_shown, at);
    else if (!run_elsewhere_.empty())
      at = call_unknown({}, at);
  }
  return at;
}

void FlowBuilder::append(ContentEvent event, unsigned at) {
  for (auto given = given_.rbegin(); given != given_.rend(); ++given) rename(*given, event);
  flow_.blocks[at].events.push_back(std::move(event));
}

/// An exception may leave the block here.
unsigned FlowBuilder::may_leave(unsigned at, unsigned handlers) {
  const unsigned behind = new_block();
  connect(at, handlers);
  connect(at, behind);
  return behind;
}

/// The part runs any number of times.
unsigned FlowBuilder::perhaps(Part part, unsigned at) {
  const unsigned behind = new_block();
  connect(at, part.entry);
  connect(at, behind);
  connect(part.exit, part.entry);
  connect(part.exit, behind);
  return behind;
}

FlowBuilder::Part FlowBuilder::body_of(const clang::FunctionDecl* closure) {
  const std::unique_ptr<clang::CFG> cfg = closure->getBody() ? cfg_of(context_.unit, closure) : nullptr;
  if (!cfg) {
    const unsigned nothing = new_block();
    return {nothing, nothing};
  }
  open_.insert(closure);
  const Part part = own_view_.holds(closure->getBody()) ? add(*cfg, closure) : add_instance(*cfg, closure);
  open_.erase(closure);
  return part;
}

/// The view of the function around knows the pattern of an instance alone, and the closures of the pattern.
FlowBuilder::Part FlowBuilder::add_instance(const clang::CFG& cfg, const clang::FunctionDecl* closure) {
  const FunctionView view(closure);
  ContentReader reader(context_, view, UnknownCalls(publish_events(context_, view)));
  ContentReader* const around = std::exchange(reader_, &reader);
  const Part part = add(cfg, closure);
  reader_ = around;
  return part;
}

/// A closure calls itself by another name alone, a parameter or a function object, and so it is one that others may call.
unsigned FlowBuilder::run(const ClosureRun& closure, unsigned at) {
  if (open_.count(closure.body) != 0) return call_unknown({}, at);
  given_.push_back(closure.given);
  const Part part = graph_of(closure.body);
  given_.pop_back();
  if (!closure.once) return perhaps(part, at);
  connect(at, part.entry);
  return part.exit;
}

/// Each call has a graph of its own, since with one for all of them paths would lead from one to the next: that is what large
/// functions get. Closures that call closures twice would have 2^n otherwise.
FlowBuilder::Part FlowBuilder::graph_of(const clang::FunctionDecl* closure) {
  if (flow_.blocks.size() < many_blocks) return body_of(closure);
  std::vector<Given> given;
  std::copy_if(given_.begin(), given_.end(), std::back_inserter(given),
               [](const Given& one) { return !one.empty(); });
  const auto known = shared_.find({closure, given});
  if (known != shared_.end()) return known->second;
  const Part part = body_of(closure);
  shared_.emplace(std::pair(closure, std::move(given)), part);
  return part;
}

unsigned FlowBuilder::call(const PerhapsCall& perhaps_called, unsigned at) {
  const unsigned callee = new_block();
  append(perhaps_called.call, callee);
  if (perhaps_called.call.callee.empty()) unknown_.any = either(unknown_.any, perhaps_called.if_shown);
  flow_.blocks[callee].if_shown = perhaps_called.if_shown;
  return perhaps({callee, callee}, at);
}

/// Calls in a row are as good as one: it runs anything any number of times.
unsigned FlowBuilder::call_unknown(const IfShown& if_shown, unsigned at) {
  if (unknown_.behind == at && flow_.blocks[at].events.empty() && unknown_.last.covers(if_shown)) return at;
  const Part any =
      unknown_.open ? *unknown_.open : anything(if_shown.is_always() ? unknown_.always : unknown_.hidden);
  const unsigned begin = new_block(), behind = new_block();
  flow_.blocks[begin].if_shown = if_shown;
  connect(at, begin);
  connect(at, behind);
  connect(begin, any.entry);
  connect(any.exit, unknown_.open ? back_in_closure(behind) : behind);
  unknown_.behind = behind;
  unknown_.last = if_shown;
  unknown_.any = either(unknown_.any, if_shown);
  return behind;
}

/// Where unknown code goes on in the closure that has called it. It comes from any call of any closure, whose variables are not
/// those that this one goes on with.
unsigned FlowBuilder::back_in_closure(unsigned behind) {
  const unsigned back = new_block();
  for (const MessagePart& root : unknown_.roots) {
    ContentEvent reset;
    reset.kind = ContentEvent::Kind::reset;
    reset.part = root;
    append(std::move(reset), back);
  }
  connect(back, behind);
  return back;
}

/// Each call has a graph of its own, in which the closures call one another: with one for all of them, paths would lead from one
/// to the next. That is what large functions get, for want of a limit otherwise.
FlowBuilder::Part FlowBuilder::anything(AnyCode& calls) {
  if (calls.shared) return *calls.shared;
  const std::size_t before = flow_.blocks.size();
  const Part any{new_block(), new_block()};
  connect(any.entry, any.exit);
  const unsigned elsewhere = new_block();  // what the package gave away somewhere else
  flow_.blocks[elsewhere].events.push_back(call_of_others());
  connect(any.entry, elsewhere);
  connect(elsewhere, any.entry);
  unknown_.open = any;
  add_closures(any);
  unknown_.open.reset();
  calls.blocks += flow_.blocks.size() - before;
  if (calls.blocks >= many_blocks) calls.shared = any;
  return any;
}

void FlowBuilder::add_closures(Part any) {
  const std::vector<Given> around = given_;
  const std::set<const clang::FunctionDecl*> open = std::exchange(open_, {});
  for (const clang::FunctionDecl* closure : run_elsewhere_) {
    // Another call of it than that which is being added, if one is: with variables of its own.
    unknown_.roots = own_roots(parts_, closure);
    Given own;
    for (const MessagePart& root : unknown_.roots) own.emplace_back(root, root + "'");
    given_ = {std::move(own)};
    const Part part = body_of(closure);
    connect(any.entry, part.entry);
    connect(part.exit, any.entry);
  }
  given_ = around;
  open_ = open;
}

/// The flow of a function that only may call others, any number of times.
ContentFlow calls_of_others(const IfShown& if_shown) {
  ContentFlow flow;
  flow.blocks = {{{}, {1, 2}}, {{call_of_others()}, {1, 2}, if_shown}, {}};
  flow.exit = 2;
  return flow;
}

bool only_calls_others(const ContentFlow& flow) {
  return llvm::all_of(flow.blocks, [](const ContentBlock& block) {
    return llvm::all_of(block.events, [](const ContentEvent& event) { return event == call_of_others(); });
  });
}

/// The flow of a function of the view, or of a closure in it; none: it has no events.
std::optional<ContentFlow> flow_of(EscapeContext& context, const SeenFunction& seen,
                                   const clang::FunctionDecl* function) {
  const std::unique_ptr<clang::CFG> cfg = cfg_of(context.unit, function);
  if (!cfg) return {};
  const std::vector<DecidedValues> ways = decided_ways(context.unit, seen.view, *cfg);
  ContentFlow flow;
  std::optional<IfShown> calls_unknown;
  for (const DecidedValues& way : ways) {
    FlowBuilder builder(context, seen, way);
    ContentFlow next = builder.build(*cfg, function);
    calls_unknown = either(calls_unknown, builder.calls_unknown());
    if (&way == &ways.front())
      flow = std::move(next);
    else
      flow.add_alternative(std::move(next));
  }
  if (flow.is_empty()) return {};
  return calls_unknown && only_calls_others(flow) ? calls_of_others(*calls_unknown) : std::move(flow);
}

}  // namespace

std::optional<ContentFlow> content_flow(EscapeContext& context, const SeenFunction& function) {
  const FunctionView& view = function.view;
  std::optional<ContentFlow> flow = flow_of(context, function, view.function());
  const bool has_lambda = llvm::any_of(
      view.statements(), [](const clang::Stmt* stmt) { return llvm::isa<clang::LambdaExpr>(stmt); });
  if (flow) flow->makes_object = llvm::isa<clang::CXXConstructorDecl>(view.function()) && !has_lambda;
  return flow;
}

std::vector<ContentFlow> closure_flows(EscapeContext& context, const SeenFunction& function,
                                       const clang::LambdaExpr* closure) {
  std::vector<ContentFlow> flows;
  const auto add = [&](std::optional<ContentFlow> flow) {
    if (flow) flows.push_back(std::move(*flow));
  };
  for (const clang::FunctionDecl* body : bodies_of(closure)) {
    if (function.view.holds(body->getBody())) {
      add(flow_of(context, function, body));
      continue;
    }
    const FunctionView view(body);
    const std::vector<SeenEvent> events = publish_events(context, view);
    add(flow_of(context, {view, events}, body));
  }
  return flows;
}

}  // namespace tzc::rewriter
