// SPDX-License-Identifier: BSD-3-Clause
#include "emit/twin_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "emit/constants.h"
#include "emit/types.h"

namespace tzc::msggen {
namespace {

class ClassEmitter {
 public:
  ClassEmitter(const Message& message, Analysis& analysis)
      : message_(message), analysis_(analysis), name_(free_name()), stock_(stock_type(message)) {}

  std::string emit() {
    const OutOfLineConstants constants = out_of_line_constants(message_);
    return fmt::format(
        "namespace tzc {{\n"
        "namespace {package} {{\n"
        "\n"
        "{constants}"
        "struct {name}{base} {{\n"
        "{typedefs}"
        "\n"
        "  {name}() = default;\n"
        "\n"
        "  /// Copies everything, the data part too: explicit, like the reverse conversion.\n"
        "{from_stock}"
        "\n"
        "{assignment}"
        "\n"
        "{to_stock}"
        "{enumerators}"
        "\n"
        "{fields}"
        "}};\n"
        "\n"
        "{aliases}"
        "\n"
        "{operators}"
        "\n"
        "}}  // namespace {package}\n"
        "}}  // namespace tzc\n",
        fmt::arg("package", message_.package), fmt::arg("constants", constants.definitions),
        fmt::arg("name", name_), fmt::arg("base", constants.base.empty() ? "" : " : " + constants.base),
        fmt::arg("typedefs", typedefs()), fmt::arg("from_stock", from_stock()),
        fmt::arg("assignment", assignment()), fmt::arg("to_stock", to_stock()),
        fmt::arg("enumerators", integer_constants(message_)), fmt::arg("fields", fields()),
        fmt::arg("aliases", aliases()), fmt::arg("operators", operators()));
  }

 private:
  bool is_member(const std::string& name) const {
    auto is = [&](const auto& member) { return member.name == name; };
    return std::any_of(message_.fields.begin(), message_.fields.end(), is) ||
           std::any_of(message_.constants.begin(), message_.constants.end(), is);
  }

  // A class cannot have a member of its own name; roscpp's class is called NAME_, so its message may, and may be called as one of
  // the class's typedefs is.
  std::string free_name() const {
    static const std::set<std::string> typedefs{"Type", "Stock", "Ptr", "ConstPtr"};
    const bool is_taken = is_member(message_.name) || typedefs.count(message_.name) != 0;
    return is_taken ? message_.name + "_" : message_.name;
  }

  // As in roscpp's class, but a field or constant of such a name comes first.
  std::string typedefs() const {
    const std::pair<const char*, std::string> all[] = {
        {"Type", name_},
        {"Stock", stock_},
        {"Ptr", fmt::format("::boost::shared_ptr<{}>", name_)},
        {"ConstPtr", fmt::format("::boost::shared_ptr<{} const>", name_)}};
    std::string text;
    for (const auto& [name, type] : all) {
      if (!is_member(name)) text += fmt::format("  typedef {} {};\n", type, name);
    }
    return text;
  }

  std::string fields() {
    std::string text;
    for (const Field& field : message_.fields) {
      const bool zero =
          field.builtin && field.array != ArrayKind::variable && field.builtin->kind != BuiltinKind::string;
      text +=
          fmt::format("  typedef {0} _{1}_type;\n  _{1}_type {1}{2};{3}\n", field_type(field, analysis_),
                      field.name, zero ? "{}" : "", analysis_.part(field) == Part::data ? "  // data" : "");
    }
    return text;
  }

  // Locals begin with an underscore, as no field can. Control fields have the same type on both sides.
  std::string from_stock() {
    std::vector<std::string> initializers;
    std::string body;
    for (const Field& f : message_.fields) {
      const bool control = analysis_.part(f) == Part::control;
      if (!control && f.array == ArrayKind::fixed) {
        body +=
            element_loop(fmt::format("{0}[_i] = {1}(_stock.{0}[_i])", f.name, twin_element(f, analysis_)));
      } else if (!control && f.array == ArrayKind::variable) {
        initializers.push_back(fmt::format("{0}(_stock.{0}.begin(), _stock.{0}.end())", f.name));
      } else {
        initializers.push_back(fmt::format("{0}(_stock.{0})", f.name));
      }
    }
    return fmt::format("  explicit {}(const {}& _stock){}{} {{{}}}\n", name_, stock_,
                       initializers.empty() ? "" : "\n      : ", fmt::join(initializers, ",\n        "),
                       body.empty() ? "" : "\n" + body + "  ");
  }

  // A template, so that `message = {}` still means an empty twin.
  std::string assignment() {
    std::string body;
    for (const Field& f : message_.fields) body += field_from_stock(f);
    return fmt::format(
        "  /// The same, into an object that is there: a bound array copies into its publisher's memory.\n"
        "  template <class _source>\n"
        "  typename ::std::enable_if< ::std::is_same<_source, {stock}>::value, {name}&>::type operator=(\n"
        "      const _source& _stock) {{\n"
        "{body}"
        "    return *this;\n"
        "  }}\n",
        fmt::arg("stock", stock_), fmt::arg("name", name_), fmt::arg("body", body));
  }

  std::string field_from_stock(const Field& f) {
    const Part part = analysis_.part(f);
    if (part == Part::mixed && f.array != ArrayKind::none) {
      const std::string sized =
          f.array == ArrayKind::variable ? fmt::format("    {0}.resize(_stock.{0}.size());\n", f.name) : "";
      return sized + element_loop(fmt::format("{0}[_i] = _stock.{0}[_i]", f.name));
    }
    return fmt::format("    {0} = _stock.{0};\n", f.name);
  }

  // Into an object that is there: a message with large arrays of fixed length does not fit a stack.
  std::string to_stock() {
    std::string body;
    for (const Field& f : message_.fields) body += field_to_stock(f);
    return fmt::format(
        "  explicit operator {0}() const {{\n"
        "    {0} _stock;\n"
        "    _copy_to(_stock);\n"
        "    return _stock;\n"
        "  }}\n"
        "  /// The same, into an object that is there.\n"
        "  void _copy_to({0}& _stock) const {{\n"
        "{1}"
        "  }}\n",
        stock_, body);
  }

  std::string field_to_stock(const Field& f) {
    const std::string name = f.name;
    switch (analysis_.part(f)) {
      case Part::control:
        return fmt::format("    _stock.{0} = {0};\n", name);
      case Part::data:
        return fmt::format("    {0}.copy_to(_stock.{0});\n", name);
      case Part::mixed:
        break;
    }
    if (f.array == ArrayKind::none) return fmt::format("    {0}._copy_to(_stock.{0});\n", name);
    const std::string sized =
        f.array == ArrayKind::variable ? fmt::format("    _stock.{0}.resize({0}.size());\n", name) : "";
    return sized + element_loop(fmt::format("{0}[_i]._copy_to(_stock.{0}[_i])", name));
  }

  static std::string element_loop(const std::string& statement) {
    const std::string array = statement.substr(0, statement.find('['));
    return fmt::format("    for (::std::size_t _i = 0; _i < {}.size(); ++_i) {};\n", array, statement);
  }

  std::string aliases() const {
    const std::string& name = message_.name;
    std::string text = name_ == name ? "" : fmt::format("typedef {} {};\n", name_, name);
    return text + fmt::format(
                      "typedef ::boost::shared_ptr<{0}> {0}Ptr;\n"
                      "typedef ::boost::shared_ptr<{0} const> {0}ConstPtr;\n",
                      name);
  }

  std::string operators() {
    std::string text = fmt::format(
        "inline ::std::ostream& operator<<(::std::ostream& stream, const {0}& message) {{\n"
        "  const auto stock = ::boost::make_shared<{1}>();\n"
        "  message._copy_to(*stock);\n"
        "  return stream << *stock;\n"
        "}}\n",
        name_, stock_);
    if (!analysis_.facts(message_).comparable) {
      return text +
             "\n// No operator==: a message without fields is inside, and roscpp does not compare those.\n";
    }
    return text + comparison_of_twins() + comparison_with_stock();
  }

  std::string comparison_of_twins() const {
    std::vector<std::string> terms;
    for (const Field& f : message_.fields) terms.push_back(fmt::format("lhs.{0} == rhs.{0}", f.name));
    return fmt::format(
        "\n"
        "inline bool operator==(const {0}& lhs, const {0}& rhs) {{\n"
        "  return {1};\n"
        "}}\n"
        "\n"
        "inline bool operator!=(const {0}& lhs, const {0}& rhs) {{ return !(lhs == rhs); }}\n",
        name_, fmt::join(terms, " &&\n         "));
  }

  // A ported node compares what it keeps with what it receives; nothing is converted for it.
  std::string comparison_with_stock() const {
    std::vector<std::string> terms;
    for (const Field& f : message_.fields) terms.push_back(equals_stock(f));
    return fmt::format(
        "\n"
        "/// Without a copy of either.\n"
        "inline bool operator==(const {0}& lhs, const {1}& rhs) {{\n"
        "  return {2};\n"
        "}}\n"
        "\n"
        "inline bool operator==(const {1}& lhs, const {0}& rhs) {{ return rhs == lhs; }}\n"
        "inline bool operator!=(const {0}& lhs, const {1}& rhs) {{ return !(lhs == rhs); }}\n"
        "inline bool operator!=(const {1}& lhs, const {0}& rhs) {{ return !(rhs == lhs); }}\n",
        name_, stock_, fmt::join(terms, " &&\n         "));
  }

  std::string equals_stock(const Field& f) const {
    const std::string& name = f.name;
    if (analysis_.part(f) != Part::mixed || f.array == ArrayKind::none) {
      return fmt::format("lhs.{0} == rhs.{0}", name);
    }
    const std::string elements =
        fmt::format("::std::equal(lhs.{0}.begin(), lhs.{0}.end(), rhs.{0}.begin())", name);
    return f.array == ArrayKind::variable
               ? fmt::format("lhs.{0}.size() == rhs.{0}.size() &&\n         {1}", name, elements)
               : elements;
  }

  const Message& message_;
  Analysis& analysis_;
  std::string name_;
  std::string stock_;
};

}  // namespace

std::string twin_class(const Message& message, Analysis& analysis) {
  return ClassEmitter(message, analysis).emit();
}

}  // namespace tzc::msggen
