// SPDX-License-Identifier: BSD-3-Clause
#include "solve/port_edits.h"

#include <algorithm>
#include <cctype>

#include "solve/memory_size.h"

namespace tzc::rewriter {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

bool is_part_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':';
}

/// tzc::Publisher -> ::tzc::Publisher
std::string from_global_namespace(std::string text) {
  const std::string name = "tzc::";
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + name.size()))
    if (at == 0 || !is_part_of_name(text[at - 1])) {
      text.insert(at, "::");
      at += 2;
    }
  return text;
}

class PortEditor {
 public:
  PortEditor(const Facts& facts, const Components& components, const Solution& solution,
             const SolveOptions& options)
      : facts_(facts),
        components_(components),
        solution_(solution),
        options_(options),
        separable_(separable(facts)) {
    for (const Use& use : facts.uses)
      if (use.change.rule == zero_fill_rule)
        needed_fills_.insert({use.change.where.file, use.change.where.begin});
  }

  PortEdits run() {
    for (const Component& component : components_.all())
      if (is_ported(component))
        for (const Entity* entity : component.entities) add_declaration(*entity, component.id);
    for (const EntityId& id : separable_) add_cut(id, facts_.cuts.at(id));
    for (const Use& use : facts_.uses)
      if (const Component* component = components_.of(use.entity))
        if (is_ported(*component) && !is_kept_out(use.change)) add(use.change, component->id);
    for (const BoundAllocation& allocation : solution_.allocations) add_allocation(allocation);
    for (const GivenPublisher& given : solution_.factories) add_parameter(given);
    for (const auto& item : facts_.advertises) add_advertise(item.second);
    for (const Component& component : components_.all())
      if (component.subscription && is_ported(component)) add_subscription(component);
    for (const Component& component : components_.all())
      if (component.publish_call && is_ported(component))
        for (const Change& change : component.publish_call->attaching.changes) add(change, component.id);
    for (const Component& component : components_.all())
      if (component.advertise_call && is_ported(component))
        for (const Change& change : component.advertise_call->attaching.changes) add(change, component.id);
    for (const Flow& flow : facts_.flows) add_conversion(flow);
    for (const auto& item : facts_.publishes) {
      add_condition(item.second);
      add_cloud_adapter(item.second);
    }
    if (facts_.shadows_tzc)
      for (auto& edit : edits_.edits) edit.text = from_global_namespace(std::move(edit.text));
    return std::move(edits_);
  }

 private:
  bool is_ported(const Component& component) const {
    return solution_.ports(component.id) &&
           (component.kind != ComponentKind::filter || is_subscribed_through(component));
  }
  /// Another instance of the template, or unit, may need the fill that this one could leave out.
  bool is_kept_out(const Change& change) const {
    return change.rule == zero_fill_rule ||
           (change.rule == uninitialized_rule &&
            needed_fills_.count({change.where.file, change.where.begin}) != 0);
  }
  /// A filter is ported for the sake of its subscriptions.
  bool is_subscribed_through(const Component& filter) const {
    return std::any_of(components_.all().begin(), components_.all().end(), [&](const Component& component) {
      return component.subscription && solution_.ports(component.id) &&
             components_.of(component.subscription->filter) == &filter;
    });
  }
  /// The component of an entity, when it is ported.
  const Component* ported(const EntityId& entity) const {
    const Component* component = components_.of(entity);
    return component && solution_.ports(component->id) ? component : nullptr;
  }
  void add(const Change& change, ComponentId component);
  void add_declaration(const Entity& entity, ComponentId component);
  void add_subscription(const Component& component);
  void add_cut(const EntityId& id, const Cut& cut);
  void add_conversion(const Flow& copy);
  void add_allocation(const BoundAllocation& allocation);
  void add_call(const BoundAllocation& allocation, const InsertedAllocation& how);
  void add_parameter(const GivenPublisher& given);
  void add_advertise(const Advertise& site);
  bool publishes_twin(const Advertise& site, const Component& publisher) const;
  void add_condition(const Publish& site);
  void add_cloud_adapter(const Publish& site);

  const Facts& facts_;
  const Components& components_;
  const Solution& solution_;
  const SolveOptions& options_;
  std::set<EntityId> separable_;
  std::set<std::pair<std::string, unsigned>> needed_fills_;  ///< file and offset
  PortEdits edits_;
};

void PortEditor::add(const Change& change, ComponentId component) {
  const Place& where = change.where;
  edits_.edits.push_back(
      {where.file, where.begin, where.end - where.begin, change.text, component, change.rule});
  edits_.headers[where.file].insert(change.headers.begin(), change.headers.end());
}

void PortEditor::add_declaration(const Entity& entity, ComponentId component) {
  if (separable_.count(entity.id) != 0) return;
  for (const Change& change : entity.changes) add(change, component);
}

void PortEditor::add_subscription(const Component& component) {
  const Subscribe& site = *component.subscription;
  for (const Change& change : site.changes) add(change, component.id);
  if (ported(site.filter)) return;
  for (const Change& change : site.changes_if_kept) add(change, component.id);
}

/// Begins a declaration of its own for a variable whose left neighbour has another fate.
void PortEditor::add_cut(const EntityId& id, const Cut& cut) {
  const Component* left = components_.of(cut.left);
  const Component* right = components_.of(id);
  if (!left || !right || is_ported(*left) == is_ported(*right)) return;
  const bool ports_right = is_ported(*right);
  Change change{cut.at, ports_right ? cut.ported : cut.stock, "declaration", {}};
  if (ports_right)
    for (const Change& spelled : facts_.entities.at(id).changes)
      change.headers.insert(change.headers.end(), spelled.headers.begin(), spelled.headers.end());
  add(change, (ports_right ? right : left)->id);
}

/// Of a ported message that is copied into one that stays a stock message.
void PortEditor::add_conversion(const Flow& copy) {
  const Component* original = copy.copies ? ported(copy.from) : nullptr;
  if (!original || ported(copy.to)) return;
  for (const Change& change : copy.as_stock) add(change, original->id);
}

void PortEditor::add_allocation(const BoundAllocation& allocation) {
  const AllocationSite& site = *allocation.site;
  if (const auto* inserted = std::get_if<InsertedAllocation>(&site.how))
    return add_call(allocation, *inserted);
  const auto* adapter = std::get_if<AdapterAllocation>(&site.how);
  for (Change change : adapter ? adapter->changes : std::get<FactoryAllocation>(site.how).changes) {
    replace_all(change.text, "$PUB", allocation.publisher);
    if (allocation.is_of_node) change.headers.push_back("tzc/ros.h");
    add(change, components_.of(site.entity)->id);
  }
}

void PortEditor::add_call(const BoundAllocation& allocation, const InsertedAllocation& how) {
  if (!how.is_needed && !how.copy) return;
  std::string call;
  for (const std::string& one : how.is_needed ? allocation.calls : std::vector<std::string>())
    call += (call.empty() ? "" : " else ") + one + "(" + how.object + ");";
  const std::string space = how.own_line ? "\n" + how.indent : " ";
  std::vector<std::string> headers;
  if (allocation.is_of_node) headers.push_back("tzc/ros.h");
  const ComponentId component = components_.of(allocation.site->entity)->id;
  if (how.copy) {
    for (const Change& change : how.copy->without) add(change, component);
    call += (call.empty() ? "" : space) + how.object + " = " + how.copy->source + ";";
  }
  if (how.opening) add({*how.opening, "{ ", "allocate", {}}, component);
  add({*how.at, space + call + (how.opening ? " }" : ""), "allocate", headers}, component);
}

void PortEditor::add_parameter(const GivenPublisher& given) {
  const Factory& factory = facts_.factories.at(given.factory);
  const std::string text =
      "const " + given.type.name + "& " + factory.parameter + (factory.has_parameters ? ", " : "");
  for (const Place& at : factory.declarations)
    add({at, text, "factory", {given.type.header}}, components_.of(given.message)->id);
}

void PortEditor::add_advertise(const Advertise& site) {
  const Component* publisher = ported(site.publisher);
  if (!publisher) return;
  const bool twin = publishes_twin(site, *publisher);
  const std::string memory = memory_size(site, options_).text;
  for (Change change : site.changes) {
    replace_all(change.text, "$TYPE", twin ? site.written.twin : site.written.stock);
    replace_all(change.text, "$MEM", memory != "0" || site.needs_memory ? ", " + memory : "");
    if (change.text.empty() && change.where.begin == change.where.end) continue;
    add(change, publisher->id);
  }
  if (twin && !site.written.no_twin && !site.written.twin.empty() && !site.changes.empty())
    edits_.headers[site.changes[0].where.file].insert("tzc/" + site.type + ".h");
}

/// The type of the messages that are published decides which one the call names.
bool PortEditor::publishes_twin(const Advertise& site, const Component& publisher) const {
  return std::any_of(facts_.publishes.begin(), facts_.publishes.end(), [&](const auto& item) {
    const Publish& fact = item.second;
    if (fact.type != site.type || components_.of(fact.publisher) != &publisher) return false;
    return fact.twin || std::any_of(fact.messages.begin(), fact.messages.end(),
                                    [&](const EntityId& message) { return ported(message) != nullptr; });
  });
}

/// What happens when the segment is full: by default publish() delivers the message anyway.
void PortEditor::add_condition(const Publish& site) {
  const CallStatement& statement = site.statement;
  if (options_.on_exhausted == OnExhausted::deliver || statement.begin.file.empty() || site.object.empty())
    return;
  const Component* message = site.messages.empty() ? nullptr : ported(site.messages[0]);
  // Other threads may be reading a message that lasts, so it is not allocated: the publisher's options decide.
  if (!message || message->has_lasting_message() || !ported(site.publisher)) return;
  const std::string allocate = site.publisher_text + "allocate(" + site.object + ")";
  const bool leave = options_.on_exhausted == OnExhausted::return_from_function && statement.in_void_function;
  const std::string indent(statement.begin.column > 0 ? statement.begin.column - 1 : 0, ' ');
  const std::string condition = statement.in_block ? "if (" + allocate + ") " : "{ if (" + allocate + ") ";
  const std::string text =
      leave && statement.in_block ? "if (!" + allocate + ") return;\n" + indent : condition;
  add({statement.begin, text, "on-exhausted", {}}, message->id);
  // In braces, so that an else that follows keeps its if.
  if (!statement.in_block) add({statement.end, " }", "on-exhausted", {}}, message->id);
}

/// Without the adapter a cloud would go out in wire format.
void PortEditor::add_cloud_adapter(const Publish& site) {
  const Component* call = components_.of(site.id());
  if (site.pcl && site.type == "sensor_msgs/PointCloud2" &&
      (ported(site.publisher) || (call && is_ported(*call))))
    edits_.headers[site.where.file].insert("tzc/pcl.h");
}

}  // namespace

PortEdits edits_of(const Facts& facts, const Components& components, const Solution& solution,
                   const SolveOptions& options) {
  return PortEditor(facts, components, solution, options).run();
}

}  // namespace tzc::rewriter
