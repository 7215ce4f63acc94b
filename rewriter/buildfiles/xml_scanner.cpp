// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/xml_scanner.h"

#include <algorithm>
#include <regex>

namespace tzc::rewriter {
namespace {

constexpr const char* blanks = " \t\r\n";

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(blanks) - begin + 1));
}

struct Tag {
  std::size_t begin = 0, end = 0;
  std::string name, attributes;
  bool closing = false, empty = false;
};

class Scanner {
 public:
  Scanner(std::string_view content, const std::string& path) : text_(content), path_(path) {}

  Expected<XmlDocument> run() {
    for (Tag tag; next(tag);) {
      if (tag.closing)
        close(tag);
      else
        open(tag);
      if (depth_ < 0 || (depth_ == 0 && tag.closing)) break;
    }
    if (broken_ || depth_ != 0 || document_.root.empty())
      return Error{"is not well-formed XML", path_, "repair it; catkin cannot read it either"};
    return document_;
  }

 private:
  bool skip(std::string_view opening, std::string_view closing) {
    if (text_.substr(at_, opening.size()) != opening) return false;
    const std::size_t end = text_.find(closing, at_ + opening.size());
    broken_ |= end == std::string_view::npos;
    at_ = broken_ ? text_.size() : end + closing.size();
    return true;
  }

  bool next(Tag& tag) {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) {
      if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>") || skip("<!", ">")) continue;
      return read(tag);
    }
    return false;
  }

  /// An attribute may hold a '>': condition="$ROS_DISTRO >= noetic".
  std::size_t end_of_tag() const {
    char quote = 0;
    for (std::size_t i = at_; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote ? c == quote : c == '"' || c == '\'')
        quote = quote ? '\0' : c;
      else if (!quote && c == '>')
        return i;
    }
    return std::string_view::npos;
  }

  bool read(Tag& tag) {
    const std::size_t end = end_of_tag();
    if (end == std::string_view::npos) return !(broken_ = true);
    std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
    tag = {at_,
           end + 1,
           "",
           "",
           !inside.empty() && inside.front() == '/',
           !inside.empty() && inside.back() == '/'};
    if (tag.closing) inside.remove_prefix(1);
    if (tag.empty) inside.remove_suffix(1);
    const std::size_t name_end = std::min(inside.find_first_of(blanks), inside.size());
    tag.name = inside.substr(0, name_end);
    tag.attributes = trimmed(inside.substr(name_end));
    at_ = tag.end;
    return true;
  }

  void open(const Tag& tag) {
    if (depth_ == 0) {
      document_.root = tag.name;
      document_.root_attributes = tag.attributes;
    }
    if (depth_ == 1) child_ = tag;
    if (tag.empty && depth_ == 1)
      document_.children.push_back({tag.name, tag.attributes, "", tag.begin, tag.end});
    if (!tag.empty) ++depth_;
  }

  void close(const Tag& tag) {
    if (--depth_ == 1)
      document_.children.push_back({child_.name, child_.attributes,
                                    trimmed(text_.substr(child_.end, tag.begin - child_.end)), child_.begin,
                                    tag.end});
    if (depth_ == 0) document_.root_close = tag.begin;
  }

  std::string_view text_;
  std::string path_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool broken_ = false;
  Tag child_;
  XmlDocument document_;
};

}  // namespace

Expected<XmlDocument> scan_xml(std::string_view content, const std::string& path) {
  return Scanner(content, path).run();
}

std::string xml_attribute(const std::string& attributes, const std::string& name) {
  const std::regex pattern("\\b" + name + "\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)')");
  std::smatch match;
  if (!std::regex_search(attributes, match, pattern)) return "";
  return match[1].matched ? match[1].str() : match[2].str();
}

}  // namespace tzc::rewriter
