// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/roscpp_version.h"

#include <link.h>
#include <ros/common.h>
#include <ros/console.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

namespace tzc {
namespace detail {
namespace {

constexpr char kLibrary[] = "libroscpp.so";

std::string to_text(const RoscppVersion& version) {
  std::ostringstream text;
  text << version[0] << '.' << version[1] << '.' << version[2];
  return text.str();
}

bool is_known(const RoscppVersion& version) {
  return version >= kFirstKnownRoscpp && version < kFirstUnknownRoscpp;
}

std::string real_path(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(realpath(path.c_str(), nullptr), std::free);
  return real ? real.get() : path;
}

/// Where the path's last component begins.
std::size_t name_begin(const std::string& path) {
  return path.rfind('/') + 1;  // npos + 1 is 0
}

/// What stands between <version ...> and the next tag of a package.xml; empty when nothing does.
std::string version_element(const std::string& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::size_t tag = text.find("<version");
  const std::size_t begin = tag == std::string::npos ? tag : text.find('>', tag);
  if (begin == std::string::npos) return std::string();
  return text.substr(begin + 1, text.find('<', begin) - begin - 1);
}

int note_library(dl_phdr_info* object, std::size_t, void* path) {
  const std::string name = object->dlpi_name;
  if (name.compare(name_begin(name), sizeof kLibrary - 1, kLibrary) != 0) return 0;
  *static_cast<std::string*>(path) = name;
  return 1;
}

/// The file of roscpp that is loaded; empty when it is linked in.
std::string loaded_library() {
  std::string path;
  dl_iterate_phdr(note_library, &path);
  return path;
}

/// Why this process's roscpp is left alone; empty: it is not.
std::string check() {
  return reason_to_leave_alone({ROS_VERSION_MAJOR, ROS_VERSION_MINOR, ROS_VERSION_PATCH},
                               version_of_library(loaded_library()));
}

bool check_and_warn() {
  const std::string reason = check();
  if (!reason.empty())
    ROS_WARN_STREAM("TZC: every topic of this node stays on TCPROS: "
                    << reason << " (" << real_path(loaded_library()) << "; share/doc/tzc/versions.md)");
  return reason.empty();
}

}  // namespace

std::optional<RoscppVersion> parse_roscpp_version(const std::string& text) {
  RoscppVersion version{};
  if (std::sscanf(text.c_str(), "%d.%d.%d", &version[0], &version[1], &version[2]) != 3) return std::nullopt;
  return version;
}

std::optional<RoscppVersion> version_of_library(const std::string& path) {
  const std::string real = real_path(path);
  const std::string name = real.substr(name_begin(real));
  if (name.compare(0, sizeof kLibrary, std::string(kLibrary) + ".") == 0)
    if (const auto version = parse_roscpp_version(name.substr(sizeof kLibrary))) return version;
  return parse_roscpp_version(
      version_element(real.substr(0, name_begin(real)) + "../share/roscpp/package.xml"));
}

std::string reason_to_leave_alone(const RoscppVersion& headers, const std::optional<RoscppVersion>& library) {
  const RoscppVersion last_known{kFirstUnknownRoscpp[0], kFirstUnknownRoscpp[1] - 1, 0};
  const std::string known = "; this version of TZC knows roscpp " + to_text(kFirstKnownRoscpp) + " to " +
                            std::to_string(last_known[0]) + "." + std::to_string(last_known[1]);
  if (!is_known(headers)) return "TZC was built for roscpp " + to_text(headers) + known;
  if (library && !is_known(*library)) return "it runs on roscpp " + to_text(*library) + known;
  return std::string();
}

bool is_roscpp_known_so_early() {
  return check().empty();
}

bool is_roscpp_known() {
  static const bool known = check_and_warn();
  return known;
}

}  // namespace detail
}  // namespace tzc
