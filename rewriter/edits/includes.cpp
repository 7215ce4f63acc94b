// SPDX-License-Identifier: BSD-3-Clause
#include "edits/includes.h"

#include <algorithm>
#include <set>
#include <vector>

#include "edits/source_text.h"

namespace tzc::rewriter {
namespace {

/// What a condition of the preprocessor includes or leaves out as a whole; or the file.
struct Branch {
  std::size_t begin = 0, end = std::string::npos;
};

struct Include {
  std::string header;
  std::size_t begin, end;  ///< of its line; end: behind the newline
  std::size_t branch;      ///< the innermost one around it: index in Scan::branches
};

/// A line with those that it goes on in.
struct Line {
  std::size_t begin, end;  ///< end: behind the newline
  std::string text;        ///< without white space and comments at both ends
};

/// The length of the byte order mark in front of the text.
std::size_t mark_of(const std::string& content) {
  return content.rfind("\xef\xbb\xbf", 0) == 0 ? 3 : 0;
}

/// Whether the line goes on in the next one: in a directive or a comment, and as compilers read it, blanks behind a backslash aside.
bool goes_on(const std::string& content, std::size_t begin, std::size_t newline) {
  const std::size_t last = content.find_last_not_of(std::string("\0 \t\v\f\r", 6), newline - 1);
  if (newline == begin || last == std::string::npos || last < begin) return false;
  return content[last] == '\\' || (last >= begin + 2 && content.compare(last - 2, 3, "\?\?/") == 0);
}

/// Behind the line that begins at `at`.
std::size_t end_of_line(const std::string& content, std::size_t at) {
  for (;;) {
    const std::size_t newline = content.find('\n', at);
    if (newline == std::string::npos) return content.size();
    if (!goes_on(content, at, newline)) return newline + 1;
    at = newline + 1;
  }
}

std::vector<Line> lines_of(const std::string& content) {
  const std::string code = without_comments(content);  // as long as the content
  std::vector<Line> lines;
  for (std::size_t at = mark_of(content); at < content.size();) {
    const std::size_t end = end_of_line(content, at);
    const std::size_t first = code.find_first_not_of(" \t\r\n", at);
    const bool is_empty = first >= end;
    const std::size_t last = is_empty ? 0 : code.find_last_not_of(" \t\r\n", end - 1);
    lines.push_back({at, end, is_empty ? "" : content.substr(first, last + 1 - first)});
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
  std::vector<Include> includes;  ///< before any code
  std::vector<Branch> branches{{}};
  std::size_t top = 0;  ///< behind the include guard, #pragma once and the comments at the top
};

Scan scan(const std::string& content) {
  Scan result;
  result.top = mark_of(content);
  std::vector<std::size_t> open{0};  // branches, the innermost last
  const auto begin_branch = [&](std::size_t at) {
    open.push_back(result.branches.size());
    result.branches.push_back({at, std::string::npos});
  };
  const auto end_branch = [&](std::size_t at) {
    if (open.size() == 1) return;  // of the include guard
    result.branches[open.back()].end = at;
    open.pop_back();
  };
  bool guard_seen = false, code_seen = false;
  const std::vector<Line> lines = lines_of(content);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& text = lines[i].text;
    const std::string directive = directive_of(text);
    if (starts_with(directive, "if")) {
      const bool guard =
          !guard_seen && open.size() == 1 && starts_with(directive, "ifndef") && is_guard(lines, i);
      guard_seen = guard_seen || guard;
      if (!guard) begin_branch(lines[i].end);
    }
    if (starts_with(directive, "el") && open.size() > 1) {
      end_branch(lines[i].begin);
      begin_branch(lines[i].end);
    }
    if (starts_with(directive, "endif")) end_branch(lines[i].begin);
    if (starts_with(directive, "include")) result.all.insert(header_of(directive));
    if (starts_with(directive, "include") && !code_seen)
      result.includes.push_back({header_of(directive), lines[i].begin, lines[i].end, open.back()});
    if (directive.empty() && !text.empty()) code_seen = true;
    if (!code_seen && open.size() == 1) result.top = lines[i].end;
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

/// Behind what begins on the line in front of `at` and ends on another one: a comment, as far as the rest of its last line.
std::size_t outside_comments(const std::string& content, std::size_t at) {
  while (at < content.size() && without_comments(content.substr(0, at) + "x").back() != 'x')
    at = end_of_line(content, at);
  return at;
}

/// Where a condition includes ros/ros.h and all that is ported, as in sources for ROS 1 and ROS 2, TZC's header belongs there, too.
void keep_those_around(Scan& scan, const Edits& edits, const std::string& file) {
  const auto has_all = [&](const Branch& branch) {
    return std::all_of(edits.begin(), edits.end(), [&](const Edit& edit) {
      return edit.file != file || (branch.begin <= edit.offset && edit.offset + edit.length <= branch.end);
    });
  };
  const bool is_edited =
      std::any_of(edits.begin(), edits.end(), [&](const Edit& edit) { return edit.file == file; });
  scan.includes.erase(std::remove_if(scan.includes.begin(), scan.includes.end(),
                                     [&](const Include& include) {
                                       return include.branch != 0 &&
                                              (!is_edited || !has_all(scan.branches[include.branch]));
                                     }),
                      scan.includes.end());
}

/// The edit that includes a header in a file; none: it is included already.
std::optional<Edit> include_edit(const std::string& file, const std::string& content,
                                 const std::string& header, const Edits& edits) {
  Scan found = scan(content);
  if (found.all.count(header) != 0) return {};
  keep_those_around(found, edits, file);
  Edit edit;
  edit.file = file;
  edit.offset = outside_comments(content, position_for(found, header));
  edit.text = "#include <" + header + ">\n";
  if (edit.offset > mark_of(content) && content[edit.offset - 1] != '\n') edit.text = "\n" + edit.text;
  edit.rule = "include";
  return edit;
}

}  // namespace

Edits include_edits(const NeededHeaders& needed, const Edits& others, const ReadFile& read) {
  Edits edits;
  for (const auto& [file, headers] : needed) {
    const std::string content = read(file).value_or("");
    for (const std::string& header : headers)
      if (std::optional<Edit> edit = include_edit(file, content, header, others))
        edits.push_back(std::move(*edit));
  }
  return edits;
}

}  // namespace tzc::rewriter
