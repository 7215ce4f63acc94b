// SPDX-License-Identifier: BSD-3-Clause
#include "parse/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "parse/library_hints.h"
#include "parse/source.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_message = 0xFFFFFFFFu;
constexpr std::size_t deepest_nesting = 100;
constexpr std::size_t most_data_fields = 10000;

struct Name {
  std::string package, type;
};

Name split_name(const std::string& full_name) {
  const std::size_t slash = full_name.find('/');
  return {full_name.substr(0, slash), slash == std::string::npos ? "" : full_name.substr(slash + 1)};
}

}  // namespace

struct Library::Entry {
  enum class State { fresh, resolving, good, bad };
  Message message;
  bool broken = false;  // its own file has faults; what it uses is looked at nevertheless
  State state = State::fresh;
};

Library::Library(LibraryOptions options, Diagnostics& diagnostics)
    : options_(std::move(options)), diagnostics_(diagnostics) {}
Library::~Library() = default;

std::vector<std::string> Library::add_file(const std::string& file, const std::string& package) {
  const auto source = read_source(file, diagnostics_);
  return source ? add_source(*source, package) : std::vector<std::string>{};
}

std::vector<std::string> Library::add_source(const Source& source, const std::string& package) {
  const std::size_t faults_before = diagnostics_.size();
  ParsedFile parsed = parse_file(source, package, diagnostics_);
  const bool broken = diagnostics_.size() > faults_before;
  if (parsed.kind == ParsedFile::Kind::service) services_.push_back({package, parsed.name});
  std::vector<std::string> names;
  for (Message& message : parsed.messages) add_message(std::move(message), broken, names);
  return names;
}

// The same definition may come twice (an action and the messages that were made of it), two different ones
// may not.
void Library::add_message(Message message, bool broken, std::vector<std::string>& names) {
  const std::string name = message.full_name();
  names.push_back(name);
  auto& entry = entries_[name];
  if (!entry) {
    entry = std::make_unique<Entry>();
    entry->broken = broken;
    entry->message = std::move(message);
    return;
  }
  if (entry->message.text == message.text) return;
  Diagnostic d;
  d.file = message.file;
  d.message = fmt::format("{} is defined twice", name);
  d.hint = fmt::format("the other definition is {}", entry->message.file);
  diagnostics_.report(std::move(d));
}

const Message* Library::find(const std::string& full_name) {
  Entry* entry = load(full_name);
  return entry && resolve(*entry) ? &entry->message : nullptr;
}

Library::Entry* Library::load(const std::string& full_name) {
  auto known = entries_.find(full_name);
  if (known != entries_.end()) return known->second.get();
  const Name name = split_name(full_name);
  for (const std::string& folder : folders_of(name.package)) {
    if (!load_from(name.package, folder, name.type)) continue;
    known = entries_.find(full_name);
    return known == entries_.end() ? nullptr : known->second.get();
  }
  return nullptr;
}

// NAME.msg, or the action or service that it comes from, in the folder itself or in the one beside it.
bool Library::load_from(const std::string& package, const std::string& folder, const std::string& name) {
  std::vector<fs::path> candidates = {fs::path(folder) / (name + ".msg")};
  auto add_origin = [&](const char* suffix, const char* kind) {
    const std::string_view tail = suffix;
    if (name.size() <= tail.size() || name.compare(name.size() - tail.size(), tail.size(), tail) != 0) return;
    const std::string file = name.substr(0, name.size() - tail.size()) + "." + kind;
    candidates.push_back(fs::path(folder) / file);
    candidates.push_back(fs::path(folder).parent_path() / kind / file);
  };
  for (const char* suffix :
       {"ActionGoal", "ActionResult", "ActionFeedback", "Action", "Goal", "Result", "Feedback"}) {
    add_origin(suffix, "action");
  }
  add_origin("Request", "srv");
  add_origin("Response", "srv");
  for (const fs::path& candidate : candidates) {
    if (!is_file(candidate.string())) continue;
    const auto names = add_file(candidate.string(), package);
    if (std::find(names.begin(), names.end(), package + "/" + name) != names.end()) return true;
  }
  return false;
}

std::vector<std::string> Library::folders_of(const std::string& package) {
  auto given = options_.path.find(package);
  if (given != options_.path.end()) return given->second;
  if (!options_.use_installed) return {};
  const Package* found = installed().find(package);
  return found ? found->message_directories() : std::vector<std::string>{};
}

const PackageIndex& Library::installed() {
  if (!installed_) {
    installed_ = std::make_unique<PackageIndex>(options_.installed ? options_.installed() : PackageIndex({}));
  }
  return *installed_;
}

bool Library::resolve(Entry& entry) {
  using State = Entry::State;
  if (entry.state != State::fresh) return entry.state == State::good;
  entry.state = State::resolving;
  resolving_.push_back(entry.message.full_name());
  bool good = true;
  for (Field& field : entry.message.fields) good &= field.builtin || resolve_field(entry.message, field);
  good = good && !entry.broken && check_size(entry.message);
  resolving_.pop_back();
  entry.state = good ? State::good : State::bad;
  return good;
}

bool Library::resolve_field(const Message& message, Field& field) {
  const std::size_t faults_before = diagnostics_.size();
  Entry* inner = load(field.base);
  if (!inner) {
    if (diagnostics_.size() == faults_before) report_unknown(message, field);
    return false;
  }
  if (inner->state == Entry::State::resolving) {
    report(message, field, fmt::format("circular definition: {}", cycle_text(field.base)),
           "a message cannot contain itself, not even in an array");
    return false;
  }
  if (resolving_.size() >= deepest_nesting) {
    report(message, field, fmt::format("messages are nested more than {} deep", deepest_nesting), "");
    return false;
  }
  field.message = &inner->message;
  return resolve(*inner);
}

std::string Library::cycle_text(const std::string& closing) const {
  auto start = std::find(resolving_.begin(), resolving_.end(), closing);
  std::string text;
  for (; start != resolving_.end(); ++start) text += *start + " -> ";
  return text + closing;
}

// Sizes are limited by the 32-bit length in front of every ROS message; data fields by what a definition can
// mean.
bool Library::check_size(const Message& message) {
  std::uint64_t bytes = 0;
  std::size_t data_fields = 0;
  for (const Field& field : message.fields) {
    const std::uint64_t count = field.array == ArrayKind::fixed ? field.length : 1;
    const std::uint64_t one = field.array == ArrayKind::variable ? 4 : analysis_.element_wire_size(field);
    bytes = saturating_add(bytes, saturating_multiply(one, count));
    if (field.message) data_fields += analysis_.facts(*field.message).data_fields.size();
    if (bytes > largest_message) {
      report(message, field, fmt::format("with this field {} takes more than 4 GiB", message.full_name()),
             "a ROS message's length is a 32-bit number; a variable-length array is written []");
      return false;
    }
    if (data_fields > most_data_fields) {
      report(message, field,
             fmt::format("with this field {} has more than {} arrays inside", message.full_name(),
                         most_data_fields),
             "");
      return false;
    }
  }
  return true;
}

void Library::report(const Message& message, const Field& field, std::string text, std::string hint) {
  Diagnostic d;
  d.file = message.file;
  d.at = field.at;
  d.width = field.type_width;
  d.source_line = field.source_line;
  d.message = std::move(text);
  d.hint = std::move(hint);
  diagnostics_.report(std::move(d));
}

void Library::report_unknown(const Message& user, const Field& field) {
  const Name name = split_name(field.base);
  const bool own = name.package == user.package;
  if (!own && folders_of(name.package).empty()) {
    return report(user, field, fmt::format("unknown package '{}'", name.package),
                  unknown_package_hint(name.package));
  }
  report(user, field, fmt::format("unknown type '{}'", own ? name.type : field.base),
         unknown_type_hint(name.package, name.type));
}

void Library::report_missing(const std::string& full_name) {
  const Name name = split_name(full_name);
  Diagnostic d;
  const bool shaped = !name.package.empty() && !name.type.empty() && name.type.find('/') == std::string::npos;
  const bool known = shaped && !folders_of(name.package).empty();
  d.message =
      known ? fmt::format("unknown type '{}'", full_name) : fmt::format("unknown package '{}'", name.package);
  if (!shaped) {
    d.message = fmt::format("'{}' is not the name of a type", full_name);
    d.hint = "a type is written as package/Name";
  } else {
    d.hint = known ? unknown_type_hint(name.package, name.type) : unknown_package_hint(name.package);
  }
  diagnostics_.report(std::move(d));
}

std::string Library::unknown_package_hint(const std::string& package) {
  return package_hint(package, options_.path, installed(), options_.use_installed);
}

std::string Library::unknown_type_hint(const std::string& package, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [full_name, entry] : entries_) {
    if (split_name(full_name).package == package) names.push_back(split_name(full_name).type);
  }
  return type_hint(package, name, {folders_of(package), std::move(names)}, options_.path, installed());
}

}  // namespace tzc::msggen
