// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

#include "rules/rule.h"

namespace tzc::rewriter {
namespace {

const ClassRename* const classes[] = {
    &rules::publisher,
    &rules::image_publisher,
    &rules::camera_publisher,
    &rules::filter_subscriber,
    &rules::subscriber_filter,
    &rules::point_cloud2_modifier,
    &rules::point_cloud2_iterator,
    &rules::point_cloud2_const_iterator,
};

const LibraryCall* const calls[] = {
    &rules::pcl_to_ros_msg, &rules::pcl_from_pcl,    &rules::pcl_move_from_pcl, &rules::fill_image,
    &rules::clear_image,    &rules::add_point_field, &rules::pcl_from_ros_msg,  &rules::cv_copy_of_message,
};

const MethodCall* const methods[] = {
    &rules::advertise,           &rules::image_advertise,        &rules::camera_advertise,
    &rules::attached_publish,    &rules::attached_image_publish, &rules::attached_camera_publish,
    &rules::subscribe,           &rules::image_subscribe,        &rules::camera_subscribe,
    &rules::cv_image_to_message, &rules::cv_image_into_message,  &rules::laser_projection,
};

const LibraryAdvertise* const advertisers[] = {
    &rules::library_advertise,
    &rules::library_image_advertise,
    &rules::library_camera_advertise,
};

const AttachedAdvertise* const attached[] = {
    &rules::attached_advertise,
    &rules::attached_image_advertise,
    &rules::attached_camera_advertise,
};

const LibraryTransport* const transports[] = {&rules::attached_laser_advertise};

const MethodCall* const filters[] = {&rules::kept_filter, &rules::kept_image_filter};

template <class Rule, std::size_t count>
std::vector<const Rule*> select(const Rule* const (&all)[count], const std::set<std::string>& without) {
  std::vector<const Rule*> selected;
  for (const Rule* rule : all)
    if (without.count(rule->rule) == 0) selected.push_back(rule);
  return selected;
}

}  // namespace

const ClassRename* RuleSet::find_class(const std::string& name) const {
  for (const ClassRename* rule : classes)
    if (name == rule->from) return rule;
  return nullptr;
}

const ClassRename* RuleSet::find_ported_class(const std::string& name) const {
  for (const ClassRename* rule : classes)
    if (name == rule->to && rule->role != ClassRename::Role::accessor) return rule;
  return nullptr;
}

const ClassRename* RuleSet::find_class_or_ported(const std::string& name) const {
  const ClassRename* rule = find_class(name);
  return rule ? rule : find_ported_class(name);
}

const LibraryCall* RuleSet::find_call(const std::string& function, unsigned argument) const {
  for (const LibraryCall* rule : calls)
    if (function == rule->function && argument == rule->argument) return rule;
  return nullptr;
}

const MethodCall* RuleSet::find_method(const std::string& object, const std::string& method,
                                       unsigned arguments) const {
  for (const MethodCall* rule : methods)
    if (object == rule->object && method == rule->method &&
        (rule->arguments < 0 || static_cast<unsigned>(rule->arguments) == arguments))
      return rule;
  return nullptr;
}

std::set<std::string> RuleSet::replacing(const std::string& function) const {
  std::set<std::string> names;
  for (const LibraryCall* rule : calls)
    if (function == rule->function) names.insert(rule->rule);
  for (const std::vector<const MethodCall*>* some : {&methods, &filters})
    for (const MethodCall* rule : *some)
      if (function == std::string(rule->object) + "::" + rule->method) names.insert(rule->rule);
  return names;
}

const LibraryAdvertise* RuleSet::find_advertiser(const std::string& result) const {
  for (const LibraryAdvertise* rule : advertisers)
    if (result == rule->result) return rule;
  return nullptr;
}

const AttachedAdvertise* RuleSet::find_attached(const std::string& publisher) const {
  for (const AttachedAdvertise* rule : attached)
    if (publisher == rule->publisher) return rule;
  return nullptr;
}

const LibraryTransport* RuleSet::find_transport(const std::string& publisher) const {
  for (const LibraryTransport* rule : transports)
    if (publisher == rule->publisher) return rule;
  return nullptr;
}

const MethodCall* RuleSet::find_ported_function(const std::string& function) const {
  for (const MethodCall* rule : methods)
    if (function == rule->to && rule->role != MethodCall::Role::builds_message &&
        rule->role != MethodCall::Role::fills_message)
      return rule;
  return nullptr;
}

const MethodCall* RuleSet::find_filter_call(const std::string& filter) const {
  for (const MethodCall* rule : filters)
    if (filter == rule->object) return rule;
  return nullptr;
}

bool RuleSet::is_filter_call(const std::string& function) const {
  for (const MethodCall* rule : filters)
    if (function == rule->to) return true;
  return false;
}

RuleSet all_rules(const std::set<std::string>& without) {
  return {select(classes, without),     select(calls, without),    select(methods, without),
          select(advertisers, without), select(attached, without), select(transports, without),
          select(filters, without)};
}

}  // namespace tzc::rewriter
