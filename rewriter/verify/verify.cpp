// SPDX-License-Identifier: BSD-3-Clause
#include "verify/verify.h"

#include <algorithm>
#include <iterator>
#include <mutex>

#include "edits/apply.h"
#include "edits/files.h"
#include "edits/in_parallel.h"
#include "verify/changed_calls.h"

namespace tzc::rewriter {

Expected<FileContents> Verifier::written(const Edits& edits) const {
  FileContents contents;
  for (const auto& [file, of_file] : by_file(edits)) {
    const std::string original = read_(file).value_or("");
    Expected<std::string> content = apply_edits(original, of_file);
    if (content && judges_.written_text) content = judges_.written_text(file, original, *content);
    if (!content) return content.error();
    contents[file] = std::move(*content);
  }
  return contents;
}

std::vector<const CompileUnit*> Verifier::touched(const FileContents& contents,
                                                  const std::set<std::string>& only) const {
  std::set<std::string> files;
  for (const auto& item : contents)
    if (const auto found = packages_.facts.units_of_file.find(item.first);
        found != packages_.facts.units_of_file.end())
      files.insert(found->second.begin(), found->second.end());
  std::vector<const CompileUnit*> units;
  for (const CompileUnit& unit : packages_.units)
    if (files.count(unit.file) && (only.empty() || only.count(unit.file))) units.push_back(&unit);
  return units;
}

std::string Verifier::key_of(const std::string& unit, const FileContents& contents) const {
  std::string key;
  for (const auto& [file, content] : contents) {
    const auto users = packages_.facts.units_of_file.find(file);
    if (users != packages_.facts.units_of_file.end() && users->second.count(unit))
      key += file + "\n" + std::to_string(content_hash(content)) + "\n";
  }
  return key;
}

std::vector<Diagnostic> Verifier::changed_calls(const CompileUnit& unit, const std::vector<PackageCall>& now,
                                                const Attribution& attribution) const {
  const auto before = packages_.calls.find(unit.id());
  if (before == packages_.calls.end()) return {};
  const auto includes = [&](const std::string& file) {
    const auto users = packages_.facts.units_of_file.find(file);
    return users != packages_.facts.units_of_file.end() && users->second.count(unit.file) != 0;
  };
  const auto is_line = [&](const std::string& file, unsigned edited_line, unsigned line) {
    return attribution.original(file, edited_line).has(line);
  };
  const auto is_replaced = [&](const PackageCall& call) {
    return attribution.has_edit(call.file, call.line, packages_.rules.replacing(call.callee));
  };
  const std::optional<PackageCall> change =
      changed_call({before->second, includes, is_line, is_replaced}, now);
  if (!change) return {};
  return {{{change->file, change->line, 1},
           "this call would choose another " + picked_by(*change) + " than before",
           {},
           true}};
}

std::vector<Diagnostic> Verifier::idle_edits(const std::vector<IdleAllocation>& idle,
                                             const Attribution& attribution) const {
  std::vector<Diagnostic> errors;
  for (const IdleAllocation& call : idle)
    if (attribution.has_edit(call.file, attribution.original(call.file, call.line).first, {"allocate"}))
      errors.push_back({{call.file, call.line, 1},
                        "allocate() would do nothing for a '" + call.type + "', which stays a stock message",
                        {},
                        true});
  return errors;
}

Verifier::Judgement Verifier::ask_clang(const VerifyRequest& request, const FileContents& contents,
                                        const Attribution& attribution) {
  ParseOptions options = options_;
  options.overlay = contents;
  options.skip_system_bodies = true;  // edits cannot break what system headers define
  const std::vector<const CompileUnit*> units = touched(contents, request.only);
  Judgement all;
  std::mutex mutex;
  unsigned done = 0;
  in_parallel(jobs_, units.size(), [&](std::size_t i) {
    const std::string key = units[i]->id() + "\n" + key_of(units[i]->file, contents);
    std::unique_lock<std::mutex> lock(mutex);
    auto known = clang_said_.find(key);
    if (known == clang_said_.end()) {
      lock.unlock();
      std::vector<PackageCall> calls;
      std::vector<IdleAllocation> idle;
      ParseResult parsed = parse(*units[i], options, [&](clang::ASTContext& ast) {
        calls = package_calls(ast, packages_.folders);
        idle = idle_allocations(ast, packages_.folders);
      });
      if (parsed.errors.empty()) parsed.errors = changed_calls(*units[i], calls, attribution);
      if (parsed.errors.empty()) parsed.errors = idle_edits(idle, attribution);
      lock.lock();
      known = clang_said_.emplace(key, std::move(parsed.errors)).first;
    }
    for (const Diagnostic& error : known->second) all.emplace_back(units[i]->file, error);
    if (request.progress) request.progress(++done, static_cast<unsigned>(units.size()));
  });
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.first < b.first;
  });  // any order of completion
  return all;
}

Expected<Verifier::Judgement> Verifier::ask_compiler(const VerifyRequest& request,
                                                     const FileContents& contents) {
  Judgement all;
  if (!judges_.compiler) return all;
  std::set<std::string> units, unknown;
  for (const CompileUnit* unit : touched(contents, request.only)) {
    units.insert(unit->file);
    if (!compiler_said_.count(unit->file + "\n" + key_of(unit->file, contents))) unknown.insert(unit->file);
  }
  if (!unknown.empty()) {
    const Expected<std::vector<CompilerError>> errors = judges_.compiler(contents, unknown);
    if (!errors) return errors.error();
    for (const std::string& unit : unknown) compiler_said_[unit + "\n" + key_of(unit, contents)];
    for (const CompilerError& error : *errors)
      compiler_said_[error.unit + "\n" + key_of(error.unit, contents)].push_back(
          {error.where, error.text, error.notes});
  }
  for (const std::string& unit : units)
    for (const Diagnostic& error : compiler_said_[unit + "\n" + key_of(unit, contents)])
      all.emplace_back(unit, error);
  return all;
}

bool Failure::is_same(const Failure& other) const {
  const Location &here = error.where, &there = other.error.where;
  const bool placed = here.line > 0 && there.line > 0;
  return unit == other.unit && here.file == there.file &&
         (placed ? origin.has(other.origin.first) || other.origin.has(origin.first)
                 : error.text == other.error.text);
}

void Verifier::attribute(Failure& failure, const Attribution& attribution) const {
  const Diagnostic& error = failure.error;
  failure.origin = attribution.original(error.where.file, error.where.line);
  failure.suspects = attribution.suspects_of(error);
  std::set<std::string> files;
  for (const auto& [file, users] : packages_.facts.units_of_file)
    if (users.count(failure.unit)) files.insert(file);
  const std::set<ComponentId> named = attribution.named_at(error);
  const std::set<ComponentId> edited = attribution.edited_in(files);
  std::set_intersection(named.begin(), named.end(), edited.begin(), edited.end(),
                        std::back_inserter(failure.candidates));
  failure.named = failure.candidates.size();
  std::set_difference(edited.begin(), edited.end(), named.begin(), named.end(),
                      std::back_inserter(failure.candidates));
}

Expected<Verification> Verifier::run(const VerifyRequest& request) {
  Verification result;
  Expected<FileContents> contents = written(request.edits);
  if (!contents) return contents.error();
  result.contents = std::move(*contents);
  const Attribution attribution(packages_.facts, packages_.components,
                                {request.edits, result.contents, read_});
  Expected<Judgement> judgement = Judgement();
  Judge judge = Judge::clang;
  if (request.judge != Judge::compiler) judgement = ask_clang(request, result.contents, attribution);
  if (judgement->empty() && request.judge != Judge::clang) {
    judge = Judge::compiler;
    judgement = ask_compiler(request, result.contents);
  }
  if (!judgement) return judgement.error();
  for (const auto& [unit, error] : *judgement) {
    result.failures.push_back({error, unit, judge, {}, {}, {}, 0});
    attribute(result.failures.back(), attribution);
  }
  return result;
}

}  // namespace tzc::rewriter
