// SPDX-License-Identifier: BSD-3-Clause
#include "edits/conditional_code.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>

namespace tzc::rewriter {
namespace {

/// The other way round: A, !A.
std::string negated(const std::string& condition) {
  if (condition.rfind("!(", 0) == 0) return condition.substr(2, condition.size() - 3);
  static const std::regex one_word("!(defined\\(\\w+\\)|\\w+)");
  if (std::regex_match(condition, one_word)) return condition.substr(1);
  static const std::regex word("defined\\(\\w+\\)|\\w+");
  return std::regex_match(condition, word) ? "!" + condition : "!(" + condition + ")";
}

/// What must hold for `#DIRECTIVE rest` to be true.
std::set<std::string> conditions_of(const std::string& directive, const std::string& rest) {
  const std::string expression = squeezed(rest);
  if (directive == "ifdef" || directive == "elifdef") return {"defined(" + expression + ")"};
  if (directive == "ifndef" || directive == "elifndef") return {"!defined(" + expression + ")"};
  static const std::regex without_parentheses("\\bdefined\\s+(\\w+)"),
      spaces("\\bdefined\\s*\\(\\s*(\\w+)\\s*\\)");
  const std::string uniform = squeezed(std::regex_replace(
      std::regex_replace(rest, without_parentheses, "defined($1)"), spaces, "defined($1)"));
  if (uniform.find("||") != std::string::npos || uniform.find('?') != std::string::npos) return {uniform};
  std::set<std::string> all;
  std::size_t begin = 0, depth = 0;
  for (std::size_t at = 0; at <= uniform.size(); ++at) {
    if (at < uniform.size() && uniform[at] == '(') ++depth;
    if (at < uniform.size() && uniform[at] == ')') --depth;
    if (at < uniform.size() && (depth > 0 || uniform.compare(at, 2, "&&") != 0)) continue;
    all.insert(uniform.substr(begin, at - begin));
    begin = at + 2;
    ++at;
  }
  return all;
}

/// What must hold for a later branch of the conditional.
std::string otherwise(const std::set<std::string>& conditions) {
  if (conditions.size() == 1) return negated(*conditions.begin());
  std::string all;
  for (const std::string& condition : conditions) all += (all.empty() ? "" : "&&") + condition;
  return "!(" + all + ")";
}

/// The namespace that the words in front of a brace open, without a name: an empty one; none: they open something else.
std::optional<std::string> namespace_of(const std::string& head) {
  const std::string words = squeezed(head), keyword = "namespace";
  const std::size_t at = words.rfind("inline", 0) == 0 ? 6 : 0;
  if (words.compare(at, keyword.size(), keyword) != 0) return {};
  return words.substr(at + keyword.size());
}

/// The class that the words in front of a brace define; empty: none, or one whose name they qualify or specialize.
std::string class_of(std::string head) {
  constexpr std::size_t longest = 2000;  // std::regex is recursive
  if (head.size() > longest) return "";
  static const std::regex of_template("^\\s*template\\s*<[^{}();]*>\\s*(?=(class|struct)\\b)");
  head = std::regex_replace(head, of_template, "", std::regex_constants::format_first_only);
  static const std::regex definition(
      "^\\s*(?:class|struct)\\s+(?:\\w+\\s+)*?(\\w+)\\s*(?:\\bfinal\\s*)?(?::(?!:)[^;{}]*)?$");
  std::smatch match;
  return std::regex_match(head, match, definition) && match[1] != "final" ? match[1].str() : "";
}

}  // namespace

/// Goes through the text once.
class ConditionalCode::Reader {
 public:
  Reader(const std::string& text, ConditionalCode& to) : text_(text), to_(to) {
    to_.branches_.push_back({0, text.size(), 0, 0, {}});
  }

  void run() {
    for (std::size_t at = 0; at < text_.size(); ++at) {
      const char c = text_[at];
      if (c == '#')
        head_ = 1 + (at = directive(at));
      else if (c == '{')
        opened(at);
      else if (c == '}')
        closed(at);
      else if (c == ';')
        head_ = at + 1;
    }
  }

 private:
  std::size_t directive(std::size_t at) {
    std::size_t end = at;
    for (; end < text_.size() && text_[end] != '\n'; ++end)
      if (text_[end] == '\\') ++end;
    end = std::min(end, text_.size());
    const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
    const auto last = text_.begin() + static_cast<std::ptrdiff_t>(end);
    const auto name = std::find_if_not(text_.begin() + static_cast<std::ptrdiff_t>(at) + 1, last, is_space);
    const auto behind = std::find_if_not(name, last, [](unsigned char c) { return std::isalnum(c) != 0; });
    directive({name, behind}, {std::find_if_not(behind, last, is_space), last}, at, end);
    return end;
  }

  void directive(const std::string& name, const std::string& rest, std::size_t at, std::size_t end) {
    if (name == "if" || name == "ifdef" || name == "ifndef") {
      open_.push_back({to_.branches_.size(), {}});
      add(conditions_of(name, rest), end);
    } else if (name.rfind("el", 0) == 0 && !open_.empty()) {
      leave(at);
      add(name == "else" ? std::set<std::string>() : conditions_of(name, rest), end);
    } else if (name == "endif" && !open_.empty()) {
      leave(at);
      open_.pop_back();
    } else if (name == "define" || name == "undef") {
      to_.changed_.insert(rest.substr(0, rest.find_first_of(" \t\n(\\")));
    } else if (name.rfind("include", 0) == 0) {
      to_.includes_.insert(at);
    }
  }

  /// A branch of the conditional that is open.
  void add(std::set<std::string> own, std::size_t begin) {
    Open& conditional = open_.back();
    const std::string next = own.empty() ? "" : otherwise(own);
    own.insert(conditional.before.begin(), conditional.before.end());
    if (!next.empty()) conditional.before.insert(next);
    to_.branches_.push_back({begin, text_.size(), inner_, conditional.first, std::move(own)});
    conditional.around = inner_;
    inner_ = to_.branches_.size() - 1;
  }
  void leave(std::size_t at) {
    to_.branches_[inner_].end = at;
    inner_ = open_.back().around;
  }

  void opened(std::size_t at) {
    const std::string head = text_.substr(head_, at - head_);
    const std::optional<std::string> space = namespace_of(head);
    const std::string name = space ? std::string() : class_of(head);
    const bool is_top = std::find(blocks_.begin(), blocks_.end(), block) == blocks_.end();
    if (!name.empty() && is_top) {
      std::string whole;
      for (const std::string& around : blocks_) whole += around + "::";
      to_.classes_.push_back({whole + name, inner_});
    }
    blocks_.push_back(space.value_or(block));
    head_ = at + 1;
  }
  void closed(std::size_t at) {
    if (!blocks_.empty()) blocks_.pop_back();
    head_ = at + 1;
  }

  static constexpr const char* block = "{";  // of anything but a namespace
  struct Open {
    std::size_t first;             ///< its first branch
    std::set<std::string> before;  ///< what holds where none of the branches so far is compiled
    std::size_t around = 0;
  };

  const std::string& text_;
  ConditionalCode& to_;
  std::size_t inner_ = 0, head_ = 0;
  std::vector<Open> open_;
  std::vector<std::string> blocks_;
};

ConditionalCode::ConditionalCode(const std::string& text) {
  Reader(text, *this).run();
}

std::size_t ConditionalCode::branch_at(std::size_t offset) const {
  std::size_t found = 0;
  for (std::size_t i = 1; i < branches_.size(); ++i)
    if (branches_[i].begin <= offset && offset < branches_[i].end) found = i;  // inner ones come later
  return found;
}

bool ConditionalCode::is_within(std::size_t branch, std::size_t outer) const {
  while (branch != outer && branch != 0) branch = branches_[branch].parent;
  return branch == outer;
}

/// Branches of one conditional, or what must hold for one must not hold for the other. A macro that the file itself changes may
/// have another value further down, and any macro may behind an #include.
bool ConditionalCode::contradicts(std::size_t one, std::size_t other) const {
  if (branches_[one].conditional == branches_[other].conditional) return one != other;
  const std::size_t begin = std::min(branches_[one].begin, branches_[other].begin),
                    end = std::max(branches_[one].begin, branches_[other].begin);
  if (includes_.lower_bound(begin) != includes_.lower_bound(end)) return false;
  const std::set<std::string>& conditions = branches_[other].conditions;
  return std::any_of(
      branches_[one].conditions.begin(), branches_[one].conditions.end(), [&](const std::string& condition) {
        const std::set<std::string> words = identifiers_in(condition);
        return conditions.count(negated(condition)) != 0 &&
               std::none_of(words.begin(), words.end(),
                            [&](const std::string& word) { return changed_.count(word) != 0; });
      });
}

/// Whether the branch defines a class that the other one defines, too.
bool ConditionalCode::defines_again(std::size_t one, std::size_t other) const {
  const auto defines = [&](std::size_t branch, const std::string& name) {
    return std::any_of(classes_.begin(), classes_.end(), [&](const Class& defined) {
      return defined.branch == branch && defined.name == name;
    });
  };
  return one != other && other != 0 &&
         std::any_of(classes_.begin(), classes_.end(), [&](const Class& defined) {
           return defined.branch == one && defines(other, defined.name);
         });
}

bool ConditionalCode::excludes(std::size_t one, std::size_t other) const {
  for (std::size_t outer = one; outer != 0; outer = branches_[outer].parent)
    for (std::size_t around = other; around != 0; around = branches_[around].parent)
      if (!is_within(other, outer) && !is_within(one, around) &&
          (contradicts(outer, around) || defines_again(outer, around)))
        return true;
  return false;
}

bool ConditionalCode::excludes(const TextRange& range, std::size_t offset) const {
  const std::size_t there = branch_at(offset);
  bool any = false;
  for (std::size_t i = 1; i < branches_.size(); ++i) {
    const auto is_inside = [&](std::size_t branch) {
      return branch != 0 && branches_[branch].begin >= range.begin && branches_[branch].begin < range.end;
    };
    if (!is_inside(i) || is_inside(branches_[i].parent)) continue;
    if (!excludes(i, there)) return false;
    any = true;
  }
  return any;
}

}  // namespace tzc::rewriter
