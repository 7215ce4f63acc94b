// SPDX-License-Identifier: BSD-3-Clause
#include "parse/folders.h"

#include <algorithm>
#include <deque>
#include <set>

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 16;

fs::path real_path(const fs::path& path) {
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  return failed ? path : real;
}

bool is_link(const fs::path& path) {
  std::error_code ignored;
  return fs::is_symlink(path, ignored);
}

class Walk {
 public:
  explicit Walk(const std::function<bool(const std::string&)>& visit) : visit_(visit) {}

  void run(const fs::path& root) {
    // A link to a folder above the root would lead all over the machine.
    const fs::path real = real_path(root);
    for (fs::path above = real; above != above.parent_path();) {
      above = above.parent_path();
      shown_.insert(above.string());
    }
    links_.push_back({root, 0});
    while (!links_.empty()) {
      const Link next = links_.front();
      links_.pop_front();
      enter(next.folder, real_path(next.folder), next.depth);
    }
  }

 private:
  struct Link {
    fs::path folder;
    int depth;
  };

  void enter(const fs::path& folder, const fs::path& real, int depth) {
    if (!shown_.insert(real.string()).second || !visit_(folder.string()) || depth == deepest) return;
    for (const fs::path& inner : entries(folder)) {
      if (inner.filename().string().front() == '.' || !is_folder(inner)) continue;
      if (is_link(inner)) {
        links_.push_back({inner, depth + 1});
      } else {
        enter(inner, real / inner.filename(), depth + 1);
      }
    }
  }

  const std::function<bool(const std::string&)>& visit_;
  std::deque<Link> links_;
  std::set<std::string> shown_;
};

}  // namespace

std::vector<fs::path> entries(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> result;
  for (fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, ignored), end;
       !ignored && it != end; it.increment(ignored)) {
    result.push_back(it->path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

void walk_folders(const std::string& folder, const std::function<bool(const std::string& folder)>& visit) {
  Walk(visit).run(folder);
}

}  // namespace tzc::msggen
