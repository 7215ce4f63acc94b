// SPDX-License-Identifier: BSD-3-Clause
#include "parse/library.h"

#include <fmt/format.h>

#include <algorithm>

#include "parse/candidates.h"
#include "parse/library_hints.h"
#include "parse/source.h"

namespace tzc::msggen {
namespace {

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
  bool broken = false;      // its own file has faults; what it uses is looked at nevertheless
  bool of_service = false;  // to genmsg it is no message, which a field could have
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
  const std::size_t faults_before = diagnostics_.reported();
  ParsedFile parsed = parse_file(source, package, diagnostics_);
  const bool broken = diagnostics_.reported() > faults_before;
  const bool of_service = parsed.kind == ParsedFile::Kind::service;
  if (of_service) services_.push_back({package, parsed.name});
  std::vector<std::string> names;
  for (Message& message : parsed.messages) {
    names.push_back(message.full_name());
    add_entry({std::move(message), broken, of_service});
  }
  return names;
}

// The same definition may come twice (an action and the messages that were made of it), two different ones
// may not.
void Library::add_entry(Entry added) {
  const Message& message = added.message;
  const std::string name = message.full_name();
  auto& entry = entries_[name];
  if (!entry) {
    entry = std::make_unique<Entry>(std::move(added));
    return;
  }
  if (entry->message.text == message.text) {
    entry->of_service &= added.of_service;
    return;
  }
  Diagnostic d;
  d.file = message.file;
  d.message = fmt::format("{} is defined twice", name);
  d.hint = fmt::format("the other definition is {}", entry->message.file);
  diagnostics_.report(std::move(d));
}

const Message* Library::find(const std::string& full_name) {
  Entry* entry = load(full_name, Wanted::any);
  return entry && resolve(*entry) ? &entry->message : nullptr;
}

Library::Entry* Library::known(const std::string& full_name, Wanted wanted) const {
  const auto found = entries_.find(full_name);
  if (found == entries_.end()) return nullptr;
  return wanted == Wanted::field_type && found->second->of_service ? nullptr : found->second.get();
}

Library::Entry* Library::load(const std::string& full_name, Wanted wanted) {
  if (Entry* entry = known(full_name, wanted)) return entry;
  const Name name = split_name(full_name);
  for (const std::string& folder : folders_of(name.package)) {
    const bool found = load_from(message_candidates(folder, name.type), full_name) ||
                       (wanted == Wanted::any && load_from(service_candidates(folder, name.type), full_name));
    if (found) return known(full_name, wanted);
  }
  return nullptr;
}

bool Library::load_from(const std::vector<std::string>& candidates, const std::string& full_name) {
  for (const std::string& candidate : candidates) {
    if (!is_file(candidate)) continue;
    const auto names = add_file(candidate, split_name(full_name).package);
    if (std::find(names.begin(), names.end(), full_name) != names.end()) return true;
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
  const std::size_t faults_before = diagnostics_.reported();
  Entry* inner = load(field.base, Wanted::field_type);
  if (!inner) {
    if (diagnostics_.reported() == faults_before) report_unknown(message, field);
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
  // A hint takes a search; nobody would read it.
  if (diagnostics_.has_enough_of(user.file)) return report(user, field, "unknown type", "");
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
  const bool is_of_service = known(package + "/" + name, Wanted::any) != nullptr;
  if (is_of_service || comes_from_service(folders_of(package), name))
    return "it is a service's request or response, which only the service can use: make a .msg of it";
  std::vector<std::string> names;
  for (const auto& [full_name, entry] : entries_) {
    if (!entry->of_service && split_name(full_name).package == package)
      names.push_back(split_name(full_name).type);
  }
  return type_hint(package, name, {folders_of(package), std::move(names)}, options_.path, installed());
}

}  // namespace tzc::msggen
