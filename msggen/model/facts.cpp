// SPDX-License-Identifier: BSD-3-Clause
#include "model/facts.h"

#include <algorithm>
#include <limits>

#include "model/md5.h"

namespace tzc::msggen {
namespace {

constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();

std::string without_trailing_newlines(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void add_once(std::vector<const Message*>& list, const Message* message) {
  if (std::find(list.begin(), list.end(), message) == list.end()) list.push_back(message);
}

std::uint64_t round_up(std::uint64_t size, std::uint64_t alignment) {
  return saturating_add(size, alignment - 1) / alignment * alignment;
}

std::string array_suffix(const Field& field) {
  switch (field.array) {
    case ArrayKind::none:
      return "";
    case ArrayKind::fixed:
      return "[" + std::to_string(field.length) + "]";
    case ArrayKind::variable:
      return "[]";
  }
  return "";
}

}  // namespace

std::uint64_t saturating_multiply(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > largest / b ? largest : a * b;
}

std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b) {
  return a > largest - b ? largest : a + b;
}

const Facts& Analysis::facts(const Message& message) {
  auto found = known_.find(&message);
  if (found == known_.end()) found = known_.emplace(&message, compute(message)).first;
  return found->second;
}

Facts Analysis::compute(const Message& message) {
  Facts facts;
  facts.fixed_length = true;
  facts.comparable = !message.fields.empty();
  for (const Field& field : message.fields) add_field(field, facts);
  facts.memory.size = std::max<std::uint64_t>(1, round_up(facts.memory.size, facts.memory.alignment));
  facts.md5 = md5_hex(md5_text(message));
  return facts;
}

void Analysis::add_field(const Field& field, Facts& facts) {
  const bool variable = field.array == ArrayKind::variable;
  facts.fixed_length &= !variable && fixed_length(field);
  facts.has_variable_array |= variable;
  if (field.message) {
    const Facts& inner = this->facts(*field.message);
    facts.has_variable_array |= inner.has_variable_array;
    facts.comparable &= inner.comparable;
    add_once(facts.nested, field.message);
    for (const Message* nested : inner.nested) add_once(facts.nested, nested);
  }
  add_data_fields(field, facts);
  const std::uint64_t count = field.array == ArrayKind::fixed ? field.length : 1;
  const std::uint64_t wire = variable ? 4 : saturating_multiply(element_wire_size(field), count);
  facts.wire_size = saturating_add(facts.wire_size, wire);
  Layout element = element_layout(field);
  facts.memory.alignment = std::max(facts.memory.alignment, element.alignment);
  facts.memory.size = saturating_add(round_up(facts.memory.size, element.alignment),
                                     saturating_multiply(element.size, count));
}

void Analysis::add_data_fields(const Field& field, Facts& facts) {
  switch (part(field)) {
    case Part::control:
      return;
    case Part::data:
      facts.data_fields.push_back(field.name);
      return;
    case Part::mixed:
      for (const std::string& inner : this->facts(*field.message).data_fields) {
        facts.data_fields.push_back(field.name + array_suffix(field) + "." + inner);
      }
  }
}

bool Analysis::fixed_length(const Field& field) {
  return field.builtin ? field.builtin->fixed_length() : facts(*field.message).fixed_length;
}

Part Analysis::part(const Field& field) {
  if (field.array == ArrayKind::variable && fixed_length(field)) return Part::data;
  if (field.message && facts(*field.message).has_data_part()) return Part::mixed;
  return Part::control;
}

std::uint64_t Analysis::element_wire_size(const Field& field) {
  return field.builtin ? field.builtin->size : facts(*field.message).wire_size;
}

Layout Analysis::element_layout(const Field& field) {
  if (field.builtin) return {field.builtin->size, field.builtin->alignment};
  return facts(*field.message).memory;
}

std::string Analysis::md5_text(const Message& message) {
  std::string text;
  for (const Constant& c : message.constants) text += c.type + " " + c.name + "=" + c.text + "\n";
  for (const Field& f : message.fields) {
    text += (f.builtin ? f.type : facts(*f.message).md5) + " " + f.name + "\n";
  }
  return without_trailing_newlines(text);
}

std::string Analysis::full_text(const Message& message) {
  static const std::string separator = std::string(80, '=') + "\n";
  std::string text = message.text + "\n";
  for (const Message* nested : facts(message).nested) {
    text += separator + "MSG: " + nested->full_name() + "\n" + nested->text + "\n";
  }
  text.pop_back();
  return text;
}

std::string service_md5(Analysis& analysis, const Message& request, const Message& response) {
  return md5_hex(analysis.md5_text(request) + analysis.md5_text(response));
}

}  // namespace tzc::msggen
