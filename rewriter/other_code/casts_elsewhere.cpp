// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/casts_elsewhere.h"

#include <algorithm>

#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "edits/source_text.h"

namespace tzc::rewriter {
namespace {

/// Package -> others that may be given what it is given.
using Givers = std::map<std::string, std::set<std::string>>;

/// TZC's own casts are no concern of what is ported to it.
bool is_tzc(const std::string& package_dir) {
  const Expected<PackageXml> package = read_package_xml(package_dir);
  return package && package->name == "tzc";
}

/// Whether a file makes a class known that others make by its name and call through its base. A nodelet's base takes no message.
bool exports_plugin(const std::string& file) {
  const Expected<std::string> read = read_file(file);
  const std::string text = read ? *read : "";
  for (const char* macro : {"PLUGINLIB_", "CLASS_LOADER_REGISTER_CLASS"})
    for (std::size_t at = text.find(macro); at != std::string::npos; at = text.find(macro, at + 1))
      if (text.substr(at, text.find(')', at) - at).find("nodelet::Nodelet") == std::string::npos) return true;
  return false;
}

std::set<std::string> reached(const std::set<std::string>& from, const Givers& edges) {
  std::set<std::string> found;
  std::vector<std::string> open(from.begin(), from.end());
  while (!open.empty()) {
    const std::string one = open.back();
    open.pop_back();
    if (!found.insert(one).second) continue;
    if (const auto next = edges.find(one); next != edges.end())
      open.insert(open.end(), next->second.begin(), next->second.end());
  }
  return found;
}

/// What the words of a type may mean.
enum class Meaning { another, any, message };

class TypeWords {
 public:
  TypeWords(const std::string& message, const std::map<std::string, std::vector<CodeWords>>& aliases,
            const std::set<std::string>& parameters)
      : package_(message.substr(0, message.find('/'))), aliases_(aliases), parameters_(parameters) {
    const std::string base = message.substr(message.find('/') + 1);
    names_ = {base, base + "_", base + "Ptr", base + "ConstPtr"};
  }

  /// By the outermost name: const_cast<Cloud<M>&> is about a Cloud, but const_cast<shared_ptr<M>&> about an M.
  Meaning of(const CodeWords& type) {
    if (is_const(type)) return Meaning::another;
    static const std::set<std::string> around = {"const", "volatile", "typename", "struct", "class", ":"};
    std::size_t at = 0;
    while (at < type.size() && around.count(type[at]) != 0) ++at;
    CodeWords chain;
    for (; at < type.size(); ++at) {
      if (type[at] == ":") continue;
      if (!chain.empty() && (at == 0 || type[at - 1] != ":")) break;
      chain.push_back(type[at]);
    }
    const bool has_arguments = at < type.size() && type[at] == "<";
    const Meaning whole = of_chain(chain);
    if (whole != Meaning::another || !has_arguments || !leads_on(chain.back())) return whole;
    return of(CodeWords(type.begin() + static_cast<std::ptrdiff_t>(at) + 1, type.end()));
  }

 private:
  /// const M&, M const&
  static bool is_const(const CodeWords& type) {
    unsigned depth = 0;
    for (const std::string& word : type) {
      if (word == "<") ++depth;
      if (word == ">" && depth-- == 0) return false;
      if (depth == 0 && (word == "*" || word == "&")) return false;
      if (depth == 0 && word == "const") return true;
    }
    return false;
  }
  static bool leads_on(const std::string& name) {
    static const std::set<std::string> pointers = {"shared_ptr", "unique_ptr", "scoped_ptr", "weak_ptr",
                                                   "MessageEvent"};
    return pointers.count(name) != 0;
  }

  /// std::remove_const_t<M>, decltype(image), and the arrays of messages
  static bool hides_type(const std::string& name) {
    static const std::set<std::string> words = {"auto", "decltype", "vector", "type", "element_type"};
    return words.count(name) != 0 || name.rfind("remove_", 0) == 0 || name.rfind("decay", 0) == 0;
  }

  Meaning of_chain(const CodeWords& chain) {
    Meaning meaning = Meaning::another;
    for (const std::string& name : chain) {
      const bool is_other_package =
          name.size() > 5 && name.compare(name.size() - 5, 5, "_msgs") == 0 && name != package_;
      if (is_other_package) return Meaning::another;
      if (names_.count(name) != 0) return Meaning::message;
      if (parameters_.count(name) != 0 || hides_type(name)) meaning = Meaning::any;
    }
    return chain.empty() ? Meaning::another : std::max(meaning, of_alias(chain.back()));
  }

  Meaning of_alias(const std::string& name) {
    const auto known = aliases_.find(name);
    if (known == aliases_.end() || !seen_.insert(name).second) return Meaning::another;
    Meaning meaning = Meaning::another;
    for (const CodeWords& words : known->second) meaning = std::max(meaning, of(words));
    return meaning;
  }

  const std::string package_;
  const std::map<std::string, std::vector<CodeWords>>& aliases_;
  const std::set<std::string>& parameters_;
  std::set<std::string> names_, seen_;
};

}  // namespace

std::set<std::string> packages_that_may_be_given(const FolderSet& packages, const IncludeGraph& graph,
                                                 const std::function<bool(const std::string&)>& is_left_out) {
  Givers includes, included;
  for (const std::string& file : graph.code()) {
    const std::string* user = graph.packages().of(file);
    if (!user || is_left_out(file)) continue;
    std::set<std::string> others;
    for (const std::string& header : graph.included_by(file))
      if (const std::string* other = graph.packages().of(header); other && *other != *user)
        others.insert(*other);
    const bool is_plugin = !others.empty() && exports_plugin(file);
    for (const std::string& other : others) {
      includes[*user].insert(other);
      included[other].insert(*user);
      if (is_plugin) includes[other].insert(*user);
    }
  }
  const std::set<std::string> own(packages.begin(), packages.end());
  std::set<std::string> all = reached(reached(own, included), includes);
  for (auto at = all.begin(); at != all.end();)
    at = own.count(*at) != 0 || is_tzc(*at) ? all.erase(at) : std::next(at);
  return all;
}

CastsElsewhere::CastsElsewhere(const FolderSet& packages, const std::set<std::string>& files) {
  for (const std::string& file : files)
    if (const std::string* package = packages.of(file)) read(file, *package);
}

void CastsElsewhere::read(const std::string& file, const std::string& package) {
  const Expected<std::string> content = read_file(file);
  if (!content) return;
  const std::string text = without_comments(*content);
  CastsOfCode code = casts_of_code(text);
  for (CodeCast& cast : code.casts) {
    const Location where{file, cast.line, 1};
    casts_.push_back({std::move(cast), package, where});
  }
  for (auto& [name, types] : code.aliases)
    aliases_[name].insert(aliases_[name].end(), types.begin(), types.end());
  parameters_.merge(code.parameters);
  names_[package].merge(identifiers_in(text));
}

std::optional<Location> CastsElsewhere::of(const std::string& type) const {
  const std::string base = type.substr(type.find('/') + 1);
  const auto names_type = [&](const std::string& package) {
    const std::set<std::string>& words = names_.at(package);
    return words.count(base) != 0 || words.count(base + "Ptr") != 0 || words.count(base + "ConstPtr") != 0;
  };
  for (const Cast& cast : casts_) {
    const Meaning meaning = TypeWords(type, aliases_, parameters_).of(cast.code.type);
    const bool may_be =
        meaning == Meaning::any && !cast.code.is_c && !cast.code.of_this && names_type(cast.package);
    if (meaning == Meaning::message || may_be) return cast.where;
  }
  return {};
}

}  // namespace tzc::rewriter
