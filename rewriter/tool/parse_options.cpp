// SPDX-License-Identifier: BSD-3-Clause
#include "tool/parse_options.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "command_line/arguments.h"
#include "port/filter.h"
#include "port/shell_word.h"
#include "tool/explain.h"
#include "tool/undo_without_apply.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace {

constexpr const char* description =
    "Ports roscpp packages to TZC: messages are built in shared memory and cross process borders without a "
    "copy.\n"
    "Without --apply or --out-dir nothing is written: the report goes to standard error, a unified diff "
    "that\n"
    "`git apply` takes to standard output.";

constexpr const char* footer = R"(Examples:
  tzc-rewrite src/my_camera                      what would change, as a report and a diff
  tzc-rewrite src/my_camera | git apply          the same, applied by git
  tzc-rewrite --apply src                        port every package below src, all files of a package or none
  tzc-rewrite --check --baseline tzc.json src    for CI: fails when a site appears that is not ported
  tzc-rewrite --report port.html src/my_camera   a page to read: sites, reasons, side-by-side diff
  tzc-rewrite --explain TZC1004                  what a code means and what to do about it

Exit status:
  0  nothing is left to port
  1  the dry run or check has edits, or a site that stays on TCPROS and is not suppressed; or some packages were
     written and others could not be
  2  an error; nothing was written

A site that shall stay as it is gets a comment on its line or the line above:
  // tzc-ignore[TZC1010]: the driver needs the raw publisher)";

const std::map<std::string, Level> levels = {
    {"zero_copy", Level::zero_copy}, {"one_copy", Level::one_copy}, {"plain", Level::plain}};
const std::map<std::string, OnExhausted> exhausted = {{"deliver", OnExhausted::deliver},
                                                      {"drop", OnExhausted::drop},
                                                      {"return", OnExhausted::return_from_function}};
const std::map<std::string, bool> exported_headers = {{"keep", false}, {"change", true}};
const std::map<std::string, Verify> verifications = {
    {"source", Verify::source}, {"syntax", Verify::syntax}, {"build", Verify::build}};

/// Everything CLI11 fills in; outlives its parse.
struct Raw {
  Options options;
  bool apply = false, check = false, list_codes = false, no_cache = false;
  std::string explain, mem_size, small, level = "zero_copy", on_exhausted = "deliver", verify = "syntax";
  std::string exported_headers = "keep";
};

std::string report_format(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension();
  return extension == ".json" || extension == ".sarif" || extension == ".html"
             ? ""
             : file + ": a report ends in .json, .sarif or .html";
}

std::string size_format(const std::string& text) {
  return parse_size(text) ? "" : text + ": a size is a number of bytes, with K, M or G behind it";
}

template <class Enum>
std::string one_of(const std::map<std::string, Enum>& names, const std::string& text) {
  if (names.count(text)) return "";
  std::string all;
  for (const auto& [name, value] : names) all += (all.empty() ? "" : ", ") + name;
  return text + ": is none of " + all;
}

/// An option that may be repeated, each time with one value.
CLI::Option* repeated(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                      const std::string& type, const std::string& text) {
  return app.add_option(name, values, text)->allow_extra_args(false)->type_name(type);
}

void add_actions(CLI::App& app, Raw& raw) {
  const char* group = "What to do (default: a dry run)";
  app.add_flag("--apply", raw.apply, "Change the packages in place")->group(group);
  app.add_option("--out-dir", raw.options.out_dir, "Write ported copies of the packages into DIR")
      ->type_name("DIR")
      ->group(group);
  app.add_flag("--check", raw.check, "Only say whether anything is left to port")->group(group);
  app.add_option("--undo", raw.options.undo,
                 "Where --apply saves the patch that takes it back (default: below ~/.local/state/tzc)")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("--force", raw.options.force, "Write over uncommitted changes")->group(group);
}

void add_inputs(CLI::App& app, Raw& raw) {
  const char* group = "Where to look";
  Options& options = raw.options;
  app.add_option("PACKAGE_DIR", options.packages, "Packages, or folders that hold packages")->type_name("");
  app.add_option("-p", options.build_dir,
                 "Build folder with compile_commands.json, or with those of the packages by name (default: "
                 "catkin's usual places)")
      ->type_name("BUILD_DIR")
      ->group(group);
  repeated(app, "--tzc-include", options.tzc_includes, "DIR",
           "TZC's headers (default: where tzc-rewrite is installed)")
      ->group(group);
  app.add_option("-j,--jobs", options.jobs, "Files analysed at a time (default: one for each processor)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->group(group);
}

void add_selection(CLI::App& app, Raw& raw) {
  const char* group = "What to port";
  Options& options = raw.options;
  repeated(app, "--only", options.only, "WHAT",
           "Only these sites: topic=GLOB, type=GLOB or file=GLOB, several with commas")
      ->delimiter(',')
      ->check(filter_format)
      ->group(group);
  repeated(app, "--except", options.except, "WHAT", "All but these sites")
      ->delimiter(',')
      ->check(filter_format)
      ->group(group);
  repeated(app, "--dead-files", options.dead_files, "GLOB",
           "Files that nothing compiles any more: what they name is ported (see --explain=TZC3007)")
      ->delimiter(',')
      ->group(group);
  app.add_option("--level", raw.level, "How far to go: zero_copy (default), one_copy or plain")
      ->check([](const std::string& text) { return one_of(levels, text); })
      ->type_name("LEVEL")
      ->group(group);
  app.add_option("--exported-headers", raw.exported_headers,
                 "keep (default): functions and members that exported headers declare stay as they are; "
                 "change: those of headers that only the packages named here are seen to include are ported, "
                 "with all that use them")
      ->check([](const std::string& text) { return one_of(exported_headers, text); })
      ->type_name("WHAT")
      ->group(group);
  app.add_option(
         "--small", raw.small,
         "Leave messages alone whose arrays are known to hold fewer bytes (default: 4K; 0: port them all)")
      ->check(size_format)
      ->type_name("BYTES")
      ->group(group);
}

void add_verification(CLI::App& app, Raw& raw) {
  const char* group = "How a port is verified before it is shown or written";
  app.add_option(
         "--verify", raw.verify,
         "syntax (default): the package's compiler accepts each changed unit, and CMake configures a "
         "scratch copy with the edited build files; build: the copy is built, too; source: nothing is "
         "configured")
      ->check([](const std::string& text) { return one_of(verifications, text); })
      ->type_name("HOW")
      ->group(group);
  app.add_flag("--strict", raw.options.strict, "Refuse a package with a source that does not parse")
      ->group(group);
}

void add_code_choices(CLI::App& app, Raw& raw) {
  const char* group = "What ported code does";
  Options& options = raw.options;
  app.add_option("--on-exhausted", raw.on_exhausted,
                 "When shared memory is used up: deliver by copy (default), drop, or return")
      ->check([](const std::string& text) { return one_of(exhausted, text); })
      ->type_name("ACTION")
      ->group(group);
  app.add_option("--mem-size", raw.mem_size,
                 "Shared memory of each publisher (default: the runtime sizes it)")
      ->check(size_format)
      ->type_name("BYTES")
      ->group(group);
  repeated(app, "--bag", options.bags, "FILE", "Measure message sizes in a recording")->group(group);
  app.add_flag("--dual", options.dual, "Still builds without TZC, behind one macro")->group(group);
}

void add_outputs(CLI::App& app, Raw& raw) {
  const char* group = "What to say";
  Options& options = raw.options;
  repeated(app, "--report", options.reports, "FILE", "Write a report: .json, .sarif or .html")
      ->check(report_format)
      ->group(group);
  app.add_option("--baseline", options.baseline, "A JSON report whose sites are accepted as they are")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("-q,--quiet", options.quiet, "No report and no progress on the terminal")->group(group);
  app.add_option("--explain", raw.explain, "Explain a code and end")->type_name("TZCnnnn")->group(group);
  app.add_flag("--list-codes", raw.list_codes, "List all codes and end")->group(group);
}

void add_cache(CLI::App& app, Raw& raw) {
  const char* group = "What to remember";
  app.add_option("--cache-dir", raw.options.cache_dir,
                 "Where --check and dry runs keep results (default: ~/.cache/tzc)")
      ->type_name("DIR")
      ->group(group);
  app.add_flag("--no-cache", raw.no_cache, "Analyse everything anew and keep nothing")->group(group);
}

/// Only runs that write nothing use results of others. Who includes an exported header is searched each time.
std::string cache_dir_of(const Raw& raw) {
  const bool writes = raw.apply || !raw.options.out_dir.empty();
  const bool searches = exported_headers.at(raw.exported_headers);
  if (raw.no_cache || writes || searches || raw.options.verify == Verify::build) return "";
  if (!raw.options.cache_dir.empty()) return std::filesystem::absolute(raw.options.cache_dir);
  const std::string folder = user_folder("XDG_CACHE_HOME", ".cache");
  return folder.empty() ? "" : folder + "/tzc/rewrite";
}

/// As a shell takes it.
std::string command_line(int argc, const char* const* argv) {
  std::string line = "tzc-rewrite";
  for (int i = 1; i < argc; ++i) line += " " + shell_word(argv[i]);
  return line;
}

Answer mistake(const std::string& text) {
  return {"tzc-rewrite: " + text + "\n  see tzc-rewrite --help\n", 2};
}

std::variant<Options, Answer> checked(Raw& raw) {
  if (raw.list_codes) return Answer{list_of_codes(), 0};
  if (!raw.explain.empty()) return explain(raw.explain);
  if (raw.options.packages.empty()) return mistake("no package is named");
  if (raw.apply + raw.check + !raw.options.out_dir.empty() > 1)
    return mistake("--apply, --out-dir and --check exclude each other");
  if (!raw.options.undo.empty() && !raw.apply)
    return undo_without_apply(raw.options.undo, raw.options.packages);
  if (raw.apply) raw.options.action = Action::apply;
  if (raw.check) raw.options.action = Action::check;
  if (!raw.options.out_dir.empty()) raw.options.action = Action::out_dir;
  raw.options.level = levels.at(raw.level);
  raw.options.change_exported = exported_headers.at(raw.exported_headers);
  raw.options.verify = verifications.at(raw.verify);
  raw.options.on_exhausted = exhausted.at(raw.on_exhausted);
  raw.options.cache_dir = cache_dir_of(raw);
  if (!raw.mem_size.empty()) raw.options.mem_size = parse_size(raw.mem_size);
  if (!raw.small.empty()) raw.options.small = *parse_size(raw.small);
  return raw.options;
}

}  // namespace

std::variant<Options, Answer> parse_options(int argc, const char* const* argv) {
  Raw raw;
  CLI::App app(description, "tzc-rewrite");
  app.footer(footer);
  app.get_formatter()->column_width(34);
  app.set_version_flag("--version", "tzc-rewrite " TZC_VERSION);
  add_actions(app, raw);
  add_inputs(app, raw);
  add_selection(app, raw);
  add_verification(app, raw);
  add_code_choices(app, raw);
  add_outputs(app, raw);
  add_cache(app, raw);
  if (const std::string why = command_line::why_incomplete(argc, argv); !why.empty()) return mistake(why);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Answer{app.help(), 0};
  } catch (const CLI::CallForVersion& version) {
    return Answer{std::string(version.what()) + "\n", 0};
  } catch (const CLI::ParseError& error) {
    return mistake(error.what());
  }
  raw.options.command = command_line(argc, argv);
  return checked(raw);
}

std::optional<std::uint64_t> parse_size(const std::string& text) {
  std::size_t end = 0;
  std::uint64_t number = 0;
  for (; end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) && end < 15; ++end)
    number = number * 10 + static_cast<std::uint64_t>(text[end] - '0');
  if (end == 0) return std::nullopt;
  static const std::map<std::string, int> shifts = {{"", 0},     {"b", 0},   {"k", 10},  {"kb", 10},
                                                    {"kib", 10}, {"m", 20},  {"mb", 20}, {"mib", 20},
                                                    {"g", 30},   {"gb", 30}, {"gib", 30}};
  std::string unit = text.substr(end);
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto shift = shifts.find(unit);
  if (shift == shifts.end() || number >> (63 - shift->second) != 0) return std::nullopt;
  return number << shift->second;
}

}  // namespace tzc::rewriter
