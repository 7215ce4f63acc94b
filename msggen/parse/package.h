// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::msggen {

/// A package's folder, and those inside it that hold definitions.
struct Package {
  std::string name;
  std::string directory;
  /// It, or one of its name that it hides, lies in PREFIX/share, its C++ headers therefore in PREFIX/include.
  bool installed = false;

  /// The folder msg/, those below it (add_message_files(DIRECTORY msg/sub) puts messages there, whose names do
  /// not tell), and where an installed package says that it has messages. Never empty.
  std::vector<std::string> message_directories() const;
  /// All .msg files in them, and the .srv and .action files in srv/, action/ and below; sorted by folder,
  /// without actions whose messages are also there as .msg.
  std::vector<std::string> definition_files() const;
};

/// Whether genmsg's CMake file, which generate_messages() installs, lies in the package's folder.
bool has_genmsg_file(const std::string& package_directory);

/// The folders of messages that this file names: add_message_files(DIRECTORY messages) puts them where it
/// likes. The file in a devel space names a workspace's source folders; they are not taken from there, but
/// found with the workspace.
std::vector<std::string> folders_named_by_genmsg(const std::string& package_directory);

}  // namespace tzc::msggen
