// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "facts/collect_unit.h"
#include "parse/parse.h"
#include "support/temp_dir.h"

namespace tzc::rewriter::test {

/// The facts of one source, with the headers of the standard library that it includes, among others. It has to parse.
inline Facts facts_of_unit(const std::string& code, const std::string& standard = "c++17") {
  const tzc::test::TempDir package;
  const std::string file =
      package.write("src/node.cpp", "#include <ros/ros.h>\n#include <sensor_msgs/Image.h>\n" + code);
  CompileUnit unit{file, "/", {"c++", "-std=" + standard, "-I" TZC_FAKES, "-c", file}};
  if (standard == "c++17")
    unit.arguments.insert(unit.arguments.end(), {"-include-pch", TZC_FAKES_PRECOMPILED});
  const RuleSet rules = all_rules();
  const CollectOptions options{package.path(), package / "build", {}, &rules, {}, {}};
  Facts facts;
  const ParseResult parsed =
      parse(unit, ParseOptions(), [&](clang::ASTContext& ast) { facts = collect_unit(ast, unit, options); });
  if (!parsed.errors.empty()) throw std::runtime_error("does not parse: " + parsed.errors[0].text);
  return facts;
}

/// Those of a package that consists of these sources.
inline Facts facts_of_all(const std::vector<std::string>& sources) {
  Facts facts;
  for (const std::string& source : sources) facts.merge(facts_of_unit(source));
  facts.leave_out_unshown_code();
  return facts;
}

inline Facts facts_of(const std::string& code, const std::string& standard = "c++17") {
  Facts facts = facts_of_unit(code, standard);
  facts.leave_out_unshown_code();
  return facts;
}

}  // namespace tzc::rewriter::test
