// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/package_xml.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "buildfiles/insertion.h"
#include "buildfiles/xml_scanner.h"
#include "edits/files.h"

namespace tzc::rewriter {
namespace {

using Names = std::vector<std::string>;

int format_of(const XmlDocument& document) {
  const std::string format = xml_attribute(document.root_attributes, "format");
  return format.empty() ? 1 : std::atoi(format.c_str());
}

bool has(const XmlDocument& document, const std::string& name, const std::string& text) {
  return std::any_of(document.children.begin(), document.children.end(),
                     [&](const XmlElement& e) { return e.name == name && e.text == text; });
}

const XmlElement* last_of(const XmlDocument& document, const Names& names) {
  for (const std::string& name : names)
    for (auto e = document.children.rbegin(); e != document.children.rend(); ++e)
      if (e->name == name) return &*e;
  return nullptr;
}

/// The dependency elements that are missing. catkin refuses a <depend> beside any other dependency on the same package.
Names wanted(const XmlDocument& document) {
  auto missing = [&](const std::string& name) { return !has(document, name, "tzc"); };
  const bool is_first = format_of(document) == 1;
  if (!is_first && !missing("depend")) return {};
  if (!is_first && missing("build_depend") && missing("build_export_depend") && missing("exec_depend"))
    return {"depend"};
  Names names;
  for (const char* name : {"build_depend", is_first ? "run_depend" : "exec_depend"})
    if (missing(name)) names.push_back(name);
  return names;
}

/// The end of the element's line where only blanks or a whole comment follow, else the end of the element.
std::size_t place_after(std::string_view content, const XmlElement& element) {
  const std::size_t end = std::min(content.find_first_of("\r\n", element.end), content.size());
  const std::string_view rest = content.substr(element.end, end - element.end);
  const std::size_t first = rest.find_first_not_of(" \t");
  const std::size_t comment_end = rest.rfind("-->");
  const bool whole_comment = first != std::string_view::npos && rest.substr(first, 4) == "<!--" &&
                             comment_end != std::string_view::npos &&
                             rest.find_first_not_of(" \t", comment_end + 3) == std::string_view::npos;
  return first == std::string_view::npos || whole_comment ? end : element.end;
}

/// ' condition="..."' of what makes it a catkin package: it may be one for ROS 2, too, which has no TZC.
std::string condition_of_catkin(const XmlDocument& document) {
  for (const XmlElement& element : document.children) {
    if (element.name != "buildtool_depend" || element.text.rfind("catkin", 0) != 0) continue;
    const std::string condition = xml_attribute(element.attributes, "condition");
    const char quote = condition.find('"') == std::string::npos ? '"' : '\'';
    return condition.empty() ? "" : std::string(" condition=") + quote + condition + quote;
  }
  return "";
}

Edit add_behind(std::string_view content, const std::string& path, const XmlElement& after,
                const std::string& element) {
  Edit edit;
  edit.file = path;
  edit.offset = place_after(content, after);
  edit.text = line_ending(content) + indentation(content, after.begin) + element;
  edit.rule = "build-files";
  return edit;
}

Names neighbours(const std::string& name) {
  if (name == "build_depend") return {"build_depend", "buildtool_depend"};
  if (name == "exec_depend")
    return {"exec_depend", "build_export_depend", "build_depend", "buildtool_depend"};
  if (name == "run_depend") return {"run_depend", "build_depend", "buildtool_depend"};
  return {"depend", "exec_depend", "build_export_depend", "build_depend", "buildtool_depend"};
}

}  // namespace

Expected<PackageXml> read_package_xml(const std::string& package_dir) {
  PackageXml package;
  package.path = canonical_path(package_dir + "/package.xml");
  const Expected<std::string> content = read_file(package.path);
  if (!content)
    return Error{"is no package: it has no package.xml", package_dir, "name the folder of a catkin package"};
  const Expected<XmlDocument> document = scan_xml(*content, package.path);
  if (!document) return document.error();
  package.format = format_of(*document);
  if (const XmlElement* name = last_of(*document, {"name"})) package.name = name->text;
  if (package.name.empty() || document->root != "package")
    return Error{"is no package.xml: it names no package", package.path, "add <name> to it"};
  const bool named =
      has(*document, "buildtool_depend", "catkin") || has(*document, "buildtool_depend", "catkin_simple");
  package.catkin = named || (package.format == 1 && !last_of(*document, {"buildtool_depend"}));
  return package;
}

Expected<Edits> depend_on_tzc(std::string_view content, const std::string& path) {
  const Expected<XmlDocument> document = scan_xml(content, path);
  if (!document) return document.error();
  const std::string condition = condition_of_catkin(*document);
  Edits edits;
  for (const std::string& name : wanted(*document)) {
    const XmlElement* neighbour = last_of(*document, neighbours(name));
    if (!neighbour && !document->children.empty()) neighbour = &document->children.back();
    const std::string element = "<" + name + condition + ">tzc</" + name + ">";
    if (neighbour) edits.push_back(add_behind(content, path, *neighbour, element));
  }
  return edits;
}

}  // namespace tzc::rewriter
