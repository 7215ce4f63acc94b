// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::msggen {

/// The files that may hold a message of this name: NAME.msg in the folder, or the action that it comes from,
/// there or in action/ beside it (genaction makes real messages of an action, which fields may use).
std::vector<std::string> message_candidates(const std::string& folder, const std::string& name);

/// The files of services that a request or response of this name may come from. It is no message to genmsg.
std::vector<std::string> service_candidates(const std::string& folder, const std::string& name);

/// Whether one of these files is there, for one of the folders.
bool comes_from_service(const std::vector<std::string>& folders, const std::string& name);

}  // namespace tzc::msggen
