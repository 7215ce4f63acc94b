// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "buildfiles/cmake_project.h"
#include "model/edit.h"
#include "model/expected.h"

namespace tzc::rewriter {

/// Whether CMakeLists.txt has a find_package(catkin) to which components can be added.
enum class CatkinUse { components, simple, none };
CatkinUse catkin_use(const CmakeProject& project);

/// `tzc` among the components of each find_package(catkin ...).
Edits add_component(const CmakeProject& project);

/// `gentzc` in each generate_messages(LANGS ...) that names the generators of the package's messages, gencpp among them.
Edits add_generator(const CmakeProject& project);

/// The edits that make the target compile and link against TZC; none for what it has already. The target must
/// be found_target().
Edits add_include(const CmakeProject& project, const std::string& target);
Edits add_link(const CmakeProject& project, const std::string& target);

/// The package's own message headers are generated before the target is compiled.
Edits add_message_dependency(const CmakeProject& project, const std::string& target,
                             const std::string& package);

/// tzc_generate_messages(PACKAGE) after find_package(catkin) or catkin_simple(): this package's build makes another package's
/// twins. Error: neither is there.
Expected<Edits> add_foreign_messages(const CmakeProject& project, const std::string& package);

/// For --dual, behind find_package(catkin): a block that uses TZC where it is found.
Edits add_optional_tzc(const CmakeProject& project, const std::set<std::string>& foreign_messages);

/// catkin_package(CATKIN_DEPENDS tzc), for packages whose exported headers include TZC's.
Edits add_catkin_depends(const CmakeProject& project);

/// Libraries that catkin_package(LIBRARIES) names for other packages to link.
std::set<std::string> exported_libraries(const CmakeProject& project);
/// Folders that catkin_package(INCLUDE_DIRS) exports; include/ where nothing says so. Canonical, with the folders and files that links
/// in them lead to.
std::set<std::string> exported_folders(const CmakeProject& project, const std::string& package_dir);

}  // namespace tzc::rewriter
