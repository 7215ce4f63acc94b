// SPDX-License-Identifier: BSD-3-Clause
#include "emit/twin_traits.h"

#include <fmt/format.h>

#include <algorithm>

#include "emit/types.h"

namespace tzc::msggen {
namespace {

std::string visit_inside(const Field& field, const char* function, Analysis& analysis) {
  const std::string inner = twin_element(field, analysis);
  return field.array == ArrayKind::none
             ? fmt::format("    Traits<{}>::{}(message.{}, visit);\n", inner, function, field.name)
             : fmt::format("    for (auto& element : message.{}) Traits<{}>::{}(element, visit);\n",
                           field.name, inner, function);
}

std::string visits_of_data(const Message& message, Analysis& analysis) {
  std::string text;
  for (const Field& f : message.fields) {
    const Part part = analysis.part(f);
    if (part == Part::data) text += fmt::format("    visit(message.{});\n", f.name);
    if (part == Part::mixed) text += visit_inside(f, "visit_data", analysis);
  }
  return text;
}

bool has_message_arrays(const Message& message, Analysis& analysis) {
  return std::any_of(message.fields.begin(), message.fields.end(), [&](const Field& field) {
    return analysis.part(field) == Part::mixed &&
           (field.array == ArrayKind::variable || has_message_arrays(*field.message, analysis));
  });
}

std::string visits_of_message_arrays(const Message& message, Analysis& analysis) {
  std::string text;
  for (const Field& f : message.fields) {
    if (analysis.part(f) != Part::mixed) continue;
    if (f.array == ArrayKind::variable) text += fmt::format("    visit(message.{});\n", f.name);
    if (has_message_arrays(*f.message, analysis)) text += visit_inside(f, "visit_message_arrays", analysis);
  }
  return text;
}

std::string visitor(const std::string& name, const std::string& visits) {
  return fmt::format(
      "  template <class Message, class Visitor>\n"
      "  static void {}({}) {{{}}}\n",
      name, visits.empty() ? "Message&, Visitor&&" : "Message& message, Visitor&& visit",
      visits.empty() ? "" : "\n" + visits + "  ");
}

std::string tzc_traits(const std::string& twin, const Message& message, Analysis& analysis) {
  return fmt::format(
      "namespace tzc {{\n"
      "namespace message {{\n"
      "\n"
      "template <>\n"
      "struct Traits<{twin}> {{\n"
      "  typedef {stock} Stock;\n"
      "  typedef ::std::true_type Generated;\n"
      "\n"
      "  /// Visits every data array, in wire order. Message is the twin, const or not.\n"
      "{visit_data}"
      "  /// Visits every array of messages that have data arrays.\n"
      "{visit_message_arrays}"
      "}};\n"
      "\n"
      "}}  // namespace message\n"
      "}}  // namespace tzc\n",
      fmt::arg("twin", twin), fmt::arg("stock", stock_type(message)),
      fmt::arg("visit_data", visitor("visit_data", visits_of_data(message, analysis))),
      fmt::arg("visit_message_arrays",
               visitor("visit_message_arrays", visits_of_message_arrays(message, analysis))));
}

// A message package that is upgraded, or hidden by an overlay, keeps the twin that was generated from its old definition.
std::string same_definition(const std::string& stock, const Message& message, Analysis& analysis) {
  const std::string& md5 = analysis.facts(message).md5;
  return fmt::format(
      "static_assert(ros::message_traits::MD5Sum<{0}>::static_value1 == 0x{1}ULL &&\n"
      "                  ros::message_traits::MD5Sum<{0}>::static_value2 == 0x{2}ULL,\n"
      "              \"tzc/{3}.h was generated from another definition than {3}.h: generate it again\");\n"
      "\n",
      stock, md5.substr(0, 16), md5.substr(16), message.full_name());
}

std::string boolean_traits(const std::string& twin, const std::string& stock) {
  std::string text;
  for (const char* trait : {"IsMessage", "IsFixedSize", "HasHeader"}) {
    text += fmt::format(
        "template <>\n"
        "struct {0}<{1}> : {0}<{2}> {{}};\n"
        "template <>\n"
        "struct {0}<{1} const> : {0}<{2} const> {{}};\n"
        "\n",
        trait, twin, stock);
  }
  return text;
}

std::string string_traits(const std::string& twin, const std::string& stock) {
  std::string text;
  for (const char* trait : {"MD5Sum", "DataType", "Definition"}) {
    text += fmt::format(
        "template <>\n"
        "struct {0}<{1}> : {0}<{2}> {{\n"
        "  static const char* value() {{ return {0}<{2}>::value(); }}\n"
        "  static const char* value(const {1}&) {{ return value(); }}\n"
        "}};\n"
        "\n",
        trait, twin, stock);
  }
  return text;
}

std::string serializer(const std::string& twin, const Message& message) {
  std::string body;
  for (const Field& f : message.fields) body += fmt::format("    stream.next(message.{});\n", f.name);
  return fmt::format(
      "namespace serialization {{\n"
      "\n"
      "template <>\n"
      "struct Serializer<{}> {{\n"
      "  template <typename Stream, typename T>\n"
      "  inline static void allInOne(Stream& stream, T message) {{\n"
      "{}"
      "  }}\n"
      "\n"
      "  ROS_DECLARE_ALLINONE_SERIALIZER\n"
      "}};\n"
      "\n"
      "}}  // namespace serialization\n",
      twin, body);
}

// Printing copies, which is negligible beside writing megabytes of numbers, and the text stays roscpp's.
std::string printer(const std::string& twin, const std::string& stock) {
  return fmt::format(
      "namespace message_operations {{\n"
      "\n"
      "template <>\n"
      "struct Printer<{0}> {{\n"
      "  template <typename Stream>\n"
      "  static void stream(Stream& stream, const ::std::string& indent, const {0}& message) {{\n"
      "    Printer<{1}>::stream(stream, indent, *::tzc::message::make_stock(message));\n"
      "  }}\n"
      "}};\n"
      "\n"
      "}}  // namespace message_operations\n",
      twin, stock);
}

}  // namespace

std::string twin_traits(const Message& message, Analysis& analysis) {
  const std::string twin = twin_type(message, analysis), stock = stock_type(message);
  return same_definition(stock, message, analysis) + tzc_traits(twin, message, analysis) +
         fmt::format(
             "\n// To ROS it is the stock type: same traits, same wire format, same text when printed.\n"
             "namespace ros {{\n"
             "namespace message_traits {{\n"
             "\n"
             "{}{}"
             "}}  // namespace message_traits\n"
             "\n"
             "{}\n"
             "{}"
             "}}  // namespace ros\n",
             boolean_traits(twin, stock), string_traits(twin, stock), serializer(twin, message),
             printer(twin, stock));
}

}  // namespace tzc::msggen
