// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/output.h"

namespace tzc::rewriter::test {

inline Site site(SiteKind kind, const std::string& file, unsigned line, const std::string& type,
                 Level level) {
  Site site;
  site.kind = kind;
  site.where = {"/ws/src/demo/" + file, line, 3};
  site.message_type = type;
  site.level = level;
  site.id = std::string(name_of(kind)) + ":" + file + ":" + std::to_string(line);
  return site;
}

/// A package with a site of every level, remarks, a flow chain, a suppression, a note, and two changed files.
inline PackageReport sample() {
  PackageReport package;
  Report& report = package.report;
  report.package = "demo";
  report.package_dir = "/ws/src/demo";

  report.sites.push_back(
      site(SiteKind::advertise, "src/camera.cpp", 8, "sensor_msgs/Image", Level::zero_copy));
  report.sites.back().topic = "camera/image";
  report.sites.back().memory_note = "10 queued + 2 in use, each 6 MB: 72 MB";
  report.sites.push_back(
      site(SiteKind::publish, "src/camera.cpp", 21, "sensor_msgs/Image", Level::zero_copy));
  report.sites.back().topic = "camera/image";

  Site relay = site(SiteKind::publish, "src/relay.cpp", 12, "sensor_msgs/PointCloud2", Level::one_copy);
  relay.code = "TZC1004";
  relay.reason = "the message was received in `callback` and is published as it came";
  relay.flow_path = {{{"/ws/src/demo/src/relay.cpp", 9, 15}, "received as `in`"},
                     {{"/ws/src/demo/src/relay.cpp", 12, 3}, "published"}};
  report.sites.push_back(relay);

  Site vendor = site(SiteKind::publish, "src/relay.cpp", 30, "sensor_msgs/Image", Level::plain);
  vendor.code = "TZC1010";
  vendor.reason = "`pub_` is passed to vendor::start<T>(), which \"wants\" a ros::Publisher & keeps it";
  report.sites.push_back(vendor);
  vendor.where.line = 33;
  vendor.id += "b";
  vendor.suppressed = true;
  vendor.suppression_reason = "the SDK is closed";
  report.sites.push_back(vendor);

  report.sites.push_back(site(SiteKind::publish, "src/relay.cpp", 40, "std_msgs/String", Level::not_needed));
  report.sites.push_back(site(SiteKind::subscribe, "src/viewer.cpp", 5, "sensor_msgs/Image", Level::shared));
  Site writer = site(SiteKind::subscribe, "src/viewer.cpp", 6, "sensor_msgs/Image", Level::copied);
  writer.code = "TZC2001";
  report.sites.push_back(writer);

  report.notes.push_back(
      {"TZC3001", Location{"/ws/src/demo/src/old.cpp", 1, 1}, "not compiled in this build folder"});
  package.changes = {
      {"CMakeLists.txt", "find_package(catkin REQUIRED COMPONENTS roscpp)\n",
       "find_package(catkin REQUIRED COMPONENTS roscpp tzc)\n"},
      {"src/camera.cpp", "#include <ros/ros.h>\n1\n2\n3\n4\n5\n6\n7\n8\n  ros::Publisher pub_;\nend\n",
       "#include <ros/ros.h>\n#include <tzc/ros.h>\n1\n2\n3\n4\n5\n6\n7\n8\n  tzc::Publisher pub_;\nend\n"}};
  package.source_root = "/ws/src";
  for (const unsigned i : {0u, 1u}) {
    Site& site = report.sites[i];
    site.pending = true;
    package.pending.push_back({"TZC5001", site.where, "can be zero_copy and is not ported yet", site.id});
  }
  return package;
}

}  // namespace tzc::rewriter::test
