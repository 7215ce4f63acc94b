// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "tool/commands.h"
#include "tool/inputs.h"

namespace tzc::msggen {
namespace {

std::string bytes(std::uint64_t count) {
  return fmt::format("{} byte{}", count, count == 1 ? "" : "s");
}

// One line of the tree; the columns are aligned when all are known.
struct Row {
  std::string role, declaration, size;
};

class Tree {
 public:
  explicit Tree(Analysis& analysis) : analysis_(analysis) {}

  std::string draw(const Message& message) {
    rows_.clear();
    add_fields(message, 1);
    std::size_t width = 0;
    for (const Row& row : rows_) width = std::max(width, row.declaration.size());
    std::string text;
    for (const Row& row : rows_)
      text += fmt::format("  {:<7}  {:<{}}  {}\n", row.role, row.declaration, width, row.size);
    return text;
  }

 private:
  void add_fields(const Message& message, int depth) {
    for (const Field& field : message.fields) {
      const Part part = analysis_.part(field);
      const bool data = part == Part::data || in_data_;
      rows_.push_back({data ? "data" : "control",
                       std::string(2 * (depth - 1), ' ') + field.type + " " + field.name, size(field, part)});
      if (!field.message) continue;
      const bool outer = in_data_;
      in_data_ = data;
      add_fields(*field.message, depth + 1);
      in_data_ = outer;
    }
  }

  std::string size(const Field& field, Part part) {
    const std::uint64_t wire = analysis_.element_wire_size(field);
    const bool fixed = analysis_.fixed_length(field);
    if (field.array == ArrayKind::fixed) {
      return (fixed ? "" : "at least ") + bytes(saturating_multiply(wire, field.length));
    }
    if (field.array == ArrayKind::none) return fixed ? bytes(wire) : "at least " + bytes(wire);
    if (part != Part::data) return fmt::format("4 bytes, at least {} per element", bytes(wire));
    const std::uint64_t memory = analysis_.element_layout(field).size;
    return bytes(memory) + " per element" +
           (memory == wire ? "" : fmt::format(", {} on the wire", bytes(wire)));
  }

  Analysis& analysis_;
  std::vector<Row> rows_;
  bool in_data_ = false;
};

std::string summary(const Facts& facts) {
  if (facts.fixed_length) {
    return fmt::format("fixed-length: {} on the wire, {} in memory", bytes(facts.wire_size),
                       bytes(facts.memory.size));
  }
  const char* kind = facts.has_data_part() ? "has a data part"
                     : facts.has_variable_array
                         ? "data-heavy, but no array is of a fixed-length type: all is control"
                         : "no variable-length array: all is control";
  if (!facts.has_data_part()) return kind;
  return fmt::format("{}: {}", kind, fmt::join(facts.data_fields, ", "));
}

void describe(const Message& message, Analysis& analysis, std::ostream& out) {
  const Facts& facts = analysis.facts(message);
  out << fmt::format("{}  (md5 {})\n  {}\n", message.full_name(), facts.md5, summary(facts));
  out << Tree(analysis).draw(message);
}

void describe_service(const std::string& name, const Message& request, const Message& response,
                      Analysis& analysis, std::ostream& out) {
  out << fmt::format("{}  (service, md5 {})\n", name, service_md5(analysis, request, response));
  describe(request, analysis, out);
  describe(response, analysis, out);
}

}  // namespace

int explain(const ExplainOptions& options, Console console) {
  Diagnostics diagnostics;
  SearchPath path = parse_includes(options.includes, diagnostics);
  if (!diagnostics.empty()) {
    finish(diagnostics, console);
    return exit_usage;
  }
  Library library({std::move(path), installed_packages, true}, diagnostics);
  if (const Message* message = library.find(options.type)) {
    describe(*message, library.analysis(), console.out);
    return finish(diagnostics, console);
  }
  const Message* request = diagnostics.empty() ? library.find(options.type + "Request") : nullptr;
  const Message* response = request ? library.find(options.type + "Response") : nullptr;
  if (!response) {
    if (diagnostics.empty()) library.report_missing(options.type);
    return finish(diagnostics, console);
  }
  describe_service(options.type, *request, *response, library.analysis(), console.out);
  return finish(diagnostics, console);
}

}  // namespace tzc::msggen
