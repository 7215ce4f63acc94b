// SPDX-License-Identifier: BSD-3-Clause
#include "emit/types.h"

#include <fmt/format.h>

#include <map>

namespace tzc::msggen {

std::string stock_type(const Message& message) {
  return fmt::format("::{}::{}", message.package, message.name);
}

std::string twin_type(const Message& message, Analysis& analysis) {
  return analysis.facts(message).has_data_part() ? "::tzc" + stock_type(message) : stock_type(message);
}

std::string twin_element(const Field& field, Analysis& analysis) {
  return field.builtin ? std::string(field.builtin->cpp) : twin_type(*field.message, analysis);
}

std::string field_type(const Field& field, Analysis& analysis) {
  const std::string element = twin_element(field, analysis);
  switch (field.array) {
    case ArrayKind::none:
      return element;
    case ArrayKind::fixed:
      return fmt::format("::boost::array<{}, {}>", element, field.length);
    case ArrayKind::variable:
      break;
  }
  static const std::map<Part, const char*> arrays{
      {Part::control, "::std::vector"}, {Part::data, "::tzc::Array"}, {Part::mixed, "::tzc::MessageArray"}};
  return fmt::format("{}<{}>", arrays.at(analysis.part(field)), element);
}

std::string include_guard(const std::string& package, const std::string& name) {
  return fmt::format("TZC_{}_MESSAGE_{}_H", package, name);
}

}  // namespace tzc::msggen
