// SPDX-License-Identifier: BSD-3-Clause
#include "edits/includes.h"

#include <set>
#include <vector>

namespace tzc::rewriter {
namespace {

struct Include {
  std::string header;
  std::size_t begin, end;  ///< of its line; end: behind the newline
};

struct Line {
  std::size_t begin, end;  ///< end: behind the newline
  std::string text;        ///< without white space at both ends
};

/// The length of the byte order mark in front of the text.
std::size_t mark_of(const std::string& content) {
  return content.rfind("\xef\xbb\xbf", 0) == 0 ? 3 : 0;
}

std::vector<Line> lines_of(const std::string& content) {
  std::vector<Line> lines;
  for (std::size_t at = mark_of(content); at < content.size();) {
    std::size_t end = content.find('\n', at);
    end = end == std::string::npos ? content.size() : end + 1;
    const std::size_t first = content.find_first_not_of(" \t\r\n", at);
    std::string text = first < end ? content.substr(first, end - first) : "";
    while (!text.empty() && std::string(" \t\r\n").find(text.back()) != std::string::npos) text.pop_back();
    lines.push_back({at, end, text});
    at = end;
  }
  return lines;
}

std::string directive_of(const std::string& line) {
  if (line.empty() || line[0] != '#') return "";
  const std::size_t name = line.find_first_not_of(" \t", 1);
  return name == std::string::npos ? "" : line.substr(name);
}

bool starts_with(const std::string& text, const char* prefix) {
  return text.rfind(prefix, 0) == 0;
}

std::string header_of(const std::string& directive) {
  const std::size_t open = directive.find_first_of("<\"");
  const std::size_t close = directive.find_first_of(">\"", open + 1);
  return open == std::string::npos || close == std::string::npos
             ? ""
             : directive.substr(open + 1, close - open - 1);
}

bool is_guard(const std::vector<Line>& lines, std::size_t i) {
  for (++i; i < lines.size(); ++i)
    if (!lines[i].text.empty()) return starts_with(directive_of(lines[i].text), "define");
  return false;
}

struct Scan {
  std::set<std::string> all;      ///< every header that is included
  std::vector<Include> includes;  ///< outside of conditions, before any code
  std::size_t top = 0;            ///< behind the include guard, #pragma once and the comments at the top
};

Scan scan(const std::string& content) {
  Scan result;
  result.top = mark_of(content);
  int depth = 0;
  bool guard_seen = false, code_seen = false, in_comment = false, continues = false;
  const std::vector<Line> lines = lines_of(content);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& text = lines[i].text;
    const bool continued = continues;  // a line of the directive above it
    const std::string directive = in_comment || continued ? "" : directive_of(text);
    continues = (continued || !directive.empty()) && !text.empty() && text.back() == '\\';
    if (text.find("/*") != std::string::npos) in_comment = true;
    if (text.find("*/") != std::string::npos) in_comment = false;
    if (starts_with(directive, "if")) {
      const bool guard = !guard_seen && depth == 0 && starts_with(directive, "ifndef") && is_guard(lines, i);
      guard_seen = guard_seen || guard;
      depth += guard ? 0 : 1;
    }
    if (starts_with(directive, "endif")) --depth;
    if (starts_with(directive, "include")) result.all.insert(header_of(directive));
    if (starts_with(directive, "include") && depth == 0 && !code_seen)
      result.includes.push_back({header_of(directive), lines[i].begin, lines[i].end});
    const bool comment = in_comment || starts_with(text, "//") || text.find("*/") != std::string::npos;
    if (directive.empty() && !text.empty() && !comment && !continued) code_seen = true;
    if (!code_seen && depth == 0 && !continues) result.top = lines[i].end;
  }
  return result;
}

/// Whether a header is one of ROS, by the package that its path names.
bool is_of_ros(const std::string& header) {
  static const std::set<std::string> packages = {"actionlib",
                                                 "camera_info_manager",
                                                 "cv_bridge",
                                                 "diagnostic_updater",
                                                 "dynamic_reconfigure",
                                                 "image_geometry",
                                                 "image_transport",
                                                 "laser_geometry",
                                                 "message_filters",
                                                 "nodelet",
                                                 "pcl_conversions",
                                                 "pcl_ros",
                                                 "pluginlib",
                                                 "ros",
                                                 "rosbag",
                                                 "stereo_image_proc",
                                                 "std_srvs",
                                                 "tf",
                                                 "tf2",
                                                 "tf2_ros",
                                                 "tf2_geometry_msgs",
                                                 "tf2_sensor_msgs",
                                                 "tzc"};
  const std::string package = header.substr(0, header.find('/'));
  const std::string ending = "_msgs";
  const bool messages = package.size() > ending.size() &&
                        package.compare(package.size() - ending.size(), ending.size(), ending) == 0;
  return package != header && (messages || packages.count(package) != 0);
}

/// The last of ROS's headers in the group of lines that includes ros/ros.h, or else in the first group with one.
const Include* last_of_ros(const std::vector<Include>& includes) {
  const Include *found = nullptr, *previous = nullptr;
  bool decided = false, in_group = false;
  for (const Include& include : includes) {
    const bool new_group = !previous || previous->end != include.begin;
    if (new_group && decided) return found;
    if (new_group) in_group = !found;
    if (is_of_ros(include.header) && (in_group || include.header == "ros/ros.h")) {
      in_group = true;
      found = &include;
    }
    decided |= include.header == "ros/ros.h";
    previous = &include;
  }
  return found;
}

/// "tzc/sensor_msgs/Image.h" stands behind "sensor_msgs/Image.h", others with ROS's headers.
std::size_t position_for(const Scan& scan, const std::string& header) {
  const std::string stock = header.substr(std::string("tzc/").size());
  for (const Include& include : scan.includes)
    if (include.header == stock && stock != "ros.h") return include.end;
  if (const Include* neighbour = last_of_ros(scan.includes)) return neighbour->end;
  return scan.includes.empty() ? scan.top : scan.includes.back().end;
}

/// The edit that includes a header in a file; none: it is included already.
std::optional<Edit> include_edit(const std::string& file, const std::string& content,
                                 const std::string& header) {
  const Scan found = scan(content);
  if (found.all.count(header) != 0) return {};
  Edit edit;
  edit.file = file;
  edit.offset = position_for(found, header);
  edit.text = "#include <" + header + ">\n";
  if (edit.offset > mark_of(content) && content[edit.offset - 1] != '\n') edit.text = "\n" + edit.text;
  edit.rule = "include";
  return edit;
}

}  // namespace

Edits include_edits(const NeededHeaders& needed, const ReadFile& read) {
  Edits edits;
  for (const auto& [file, headers] : needed) {
    const std::string content = read(file).value_or("");
    for (const std::string& header : headers)
      if (std::optional<Edit> edit = include_edit(file, content, header)) edits.push_back(std::move(*edit));
  }
  return edits;
}

}  // namespace tzc::rewriter
