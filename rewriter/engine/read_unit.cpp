// SPDX-License-Identifier: BSD-3-Clause
#include "engine/read_unit.h"

#include <clang/AST/ASTContext.h>

#include <iterator>
#include <memory>

#include "engine/api_calls.h"

namespace tzc::rewriter {
namespace {

std::vector<Place> skipped_in_packages(const ParseResult& parsed, const CollectOptions& options) {
  std::vector<Place> skipped;
  for (const SkippedBranch& branch : parsed.skipped)
    if (options.packages.hold(branch.file) && !options.generated.hold(branch.file))
      skipped.push_back({branch.file, branch.begin, branch.end, branch.line, 1});
  return skipped;
}

template <class T>
void append(std::vector<T>& into, std::vector<T>& from) {
  std::move(from.begin(), from.end(), std::back_inserter(into));
}

}  // namespace

void UnitReading::merge(UnitReading&& other) {
  facts.merge(std::move(other.facts));
  api_calls.merge(other.api_calls);
  calls.merge(other.calls);
  append(skipped, other.skipped);
  compiled.merge(other.compiled);
  append(errors, other.errors);
}

UnitReading read_unit(const CompileUnit& unit, const CollectOptions& options, FileAccesses* accesses) {
  auto reading = std::make_unique<UnitReading>();
  ParseOptions parse_options;
  parse_options.accesses = accesses;
  parse_options.include_dirs = options.include_dirs;
  parse_options.skip_system_bodies = true;
  ParseResult parsed = parse(unit, parse_options, [&](clang::ASTContext& ast) {
    reading->facts = collect_unit(ast, unit, options);
    reading->api_calls = api_calls(ast, options.packages, options.exported_dirs);
    reading->calls[unit.id()] = package_calls(ast, options.packages);
  });
  if (parsed.crashed) {
    static_cast<void>(reading.release());  // half made: nothing may touch it again
    reading = std::make_unique<UnitReading>();
  }
  reading->crashed = parsed.crashed;
  reading->skipped = skipped_in_packages(parsed, options);
  reading->compiled = std::move(parsed.compiled);
  reading->errors = std::move(parsed.errors);
  return std::move(*reading);
}

}  // namespace tzc::rewriter
