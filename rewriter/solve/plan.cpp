// SPDX-License-Identifier: BSD-3-Clause
#include "solve/plan.h"

#include <algorithm>

#include "solve/sites.h"

namespace tzc::rewriter {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

class Planner {
 public:
  Planner(const Facts& facts, const Components& components, const Solution& solution,
          const EngineOptions& options, const ReadFile& read)
      : facts_(facts), components_(components), solution_(solution), options_(options), read_(read) {}

  EditPlan run() {
    for (const Component& component : components_.all())
      if (is_ported(component.id))
        for (const Entity* entity : component.entities)
          for (const Change& change : entity->changes) add(change, component.id);
    for (const Use& use : facts_.uses)
      if (const Component* component = components_.of(use.entity))
        if (is_ported(component->id)) add(use.change, component->id);
    for (const Solution::Bound& bound : solution_.births) add_birth(bound);
    for (const Solution::GivenPublisher& given : solution_.helpers) add_parameter(given);
    for (const auto& item : facts_.advertises) add_advertise(item.second);
    for (const std::string& id : solution_.subscribes)
      for (const Change& change : facts_.subscribes.at(id).changes)
        add(change, subscribe_component(facts_, components_, id));
    for (const auto& item : facts_.publishes) {
      add_condition(item.second);
      add_cloud_adapter(item.second);
    }
    add_includes();
    keep_line_endings();
    return std::move(plan_);
  }

 private:
  template <class Decisions>
  static bool ported(const Decisions& decisions, int id) {
    const auto found = decisions.find(id);
    return found != decisions.end() && found->second.ported;
  }
  bool is_ported(int id) const {
    return ported(solution_.publishers, id) || ported(solution_.messages, id) ||
           (ported(solution_.filters, id) && filter_is_used(id));
  }
  bool filter_is_used(int id) const {
    return std::any_of(solution_.subscribes.begin(), solution_.subscribes.end(),
                       [&](const std::string& site) {
                         const Component* filter = components_.of(facts_.subscribes.at(site).filter);
                         return filter && filter->id == id;
                       });
  }
  void add(const Change& change, int component);
  void add_birth(const Solution::Bound& bound);
  void add_parameter(const Solution::GivenPublisher& given);
  void add_advertise(const Advertise& site);
  void add_condition(const Publish& site);
  void add_cloud_adapter(const Publish& site);
  void add_includes();
  void keep_line_endings();
  const std::string& content(const std::string& file);

  const Facts& facts_;
  const Components& components_;
  const Solution& solution_;
  const EngineOptions& options_;
  const ReadFile& read_;
  EditPlan plan_;
  std::map<std::string, std::map<std::string, int>> headers_;  // file -> header -> a component that needs it
  std::map<std::string, std::string> contents_;
};

const std::string& Planner::content(const std::string& file) {
  auto known = contents_.find(file);
  if (known == contents_.end()) known = contents_.emplace(file, read_(file).value_or("")).first;
  return known->second;
}

void Planner::add(const Change& change, int component) {
  const Place& where = change.where;
  plan_.edits.push_back(
      {where.file, where.begin, where.end - where.begin, change.text, component, change.rule});
  for (const std::string& header : change.headers) headers_[where.file].emplace(header, component);
}

void Planner::add_birth(const Solution::Bound& bound) {
  const Birth& birth = *bound.birth;
  const int component = components_.of(birth.entity)->id;
  for (Change change : birth.changes) {
    replace_all(change.text, "$PUB", bound.publisher);
    add(change, component);
  }
  if (birth.adapter || !birth.at) return;
  const std::string call = bound.call + "(" + birth.object + ");";
  const std::string space = birth.own_line ? "\n" + birth.indent : " ";
  const std::string text = birth.before ? call + space : space + call;
  add({*birth.at, text, "allocate", {}}, component);
}

void Planner::add_parameter(const Solution::GivenPublisher& given) {
  const Helper& helper = facts_.helpers.at(given.helper);
  const std::string text =
      "const " + given.type + "& " + helper.parameter + (helper.has_parameters ? ", " : "");
  for (const Place& at : helper.declarations)
    add({at, text, "helper", {given.header}}, components_.of(given.message)->id);
}

void Planner::add_advertise(const Advertise& site) {
  const Component* publisher = components_.of(site.publisher);
  if (!publisher || !ported(solution_.publishers, publisher->id)) return;
  for (Change change : site.changes) {
    replace_all(change.text, "$MEM", memory_size(site, options_).text);
    add(change, publisher->id);
  }
}

/// What happens when the segment is full: by default publish() delivers the message anyway.
void Planner::add_condition(const Publish& site) {
  if (options_.on_exhausted == OnExhausted::deliver || site.statement.file.empty() || site.object.empty())
    return;
  const Component* message = site.messages.empty() ? nullptr : components_.of(site.messages[0]);
  const Component* publisher = components_.of(site.publisher);
  if (!message || !publisher || !ported(solution_.messages, message->id) ||
      !ported(solution_.publishers, publisher->id))
    return;
  const std::string allocate = site.publisher_text + "allocate(" + site.object + ")";
  const bool leave = options_.on_exhausted == OnExhausted::return_from_function && site.in_void_function;
  const std::string indent(site.statement.column > 0 ? site.statement.column - 1 : 0, ' ');
  const std::string condition = site.in_block ? "if (" + allocate + ") " : "{ if (" + allocate + ") ";
  const std::string text = leave && site.in_block ? "if (!" + allocate + ") return;\n" + indent : condition;
  add({site.statement, text, "on-exhausted", {}}, message->id);
  // In braces, so that an else that follows keeps its if.
  if (!site.in_block) add({site.statement_end, " }", "on-exhausted", {}}, message->id);
}

/// Without the adapter a cloud would go out in wire format.
void Planner::add_cloud_adapter(const Publish& site) {
  const Component* publisher = components_.of(site.publisher);
  if (site.pcl && site.type == "sensor_msgs/PointCloud2" && publisher &&
      ported(solution_.publishers, publisher->id))
    headers_[site.where.file].emplace("tzc/pcl.h", publisher->id);
}

void Planner::add_includes() {
  for (const auto& [file, headers] : headers_)
    for (const auto& [header, component] : headers) {
      plan_.headers.insert(header);
      if (std::optional<Edit> edit = include_edit(file, content(file), header)) {
        edit->component = -1;
        plan_.edits.push_back(*edit);
      }
    }
}

void Planner::keep_line_endings() {
  for (Edit& edit : plan_.edits)
    if (edit.text.find('\n') != std::string::npos && content(edit.file).find("\r\n") != std::string::npos)
      replace_all(edit.text, "\n", "\r\n");
}

}  // namespace

EditPlan edits_of(const Facts& facts, const Components& components, const Solution& solution,
                  const EngineOptions& options, const ReadFile& read) {
  return Planner(facts, components, solution, options, read).run();
}

int subscribe_component(const Facts& facts, const Components& components, const std::string& id) {
  const auto position = facts.subscribes.find(id);
  return static_cast<int>(components.all().size() + std::distance(facts.subscribes.begin(), position));
}

}  // namespace tzc::rewriter
