// SPDX-License-Identifier: BSD-3-Clause
#include "engine/read_unit.h"

#include <clang/AST/ASTContext.h>

#include <memory>
#include <utility>

#include "engine/api_calls.h"
#include "model/append.h"
#include "model/erase_if.h"

namespace tzc::rewriter {
namespace {

/// Without what concerns other packages, or code that the build makes.
PreprocessorNotes in_packages(PreprocessorNotes notes, const CollectOptions& options) {
  const auto is_foreign = [&](const Place& place) {
    return !options.packages.hold(place.file) || options.generated.hold(place.file);
  };
  for (std::vector<Place>* places : {&notes.skipped, &notes.dropped, &notes.texts})
    erase_if(*places, is_foreign);
  return notes;
}

}  // namespace

void UnitReading::merge(UnitReading&& other) {
  facts.merge(std::move(other.facts));
  api_calls.merge(other.api_calls);
  calls.merge(other.calls);
  preprocessor.merge(std::move(other.preprocessor));
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
  reading->preprocessor = in_packages(std::move(parsed.preprocessor), options);
  reading->errors = std::move(parsed.errors);
  return std::move(*reading);
}

}  // namespace tzc::rewriter
