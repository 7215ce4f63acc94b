// SPDX-License-Identifier: BSD-3-Clause
#include "tool/port_writer.h"

#include "transaction/swap.h"

namespace tzc::rewriter {

Expected<PortWriter> PortWriter::open(const Options& options, const std::vector<std::string>& packages) {
  PortWriter writer(options);
  if (options.action == Action::out_dir) {
    Expected<OutDir> out_dir = OutDir::open(options.out_dir, packages, options.packages);
    if (!out_dir) return out_dir.error();
    writer.out_dir_.emplace(std::move(*out_dir));
  }
  if (options.action == Action::apply) {
    Expected<UndoPatch> undo = UndoPatch::open(options.undo, packages);
    if (!undo) return undo.error();
    writer.undo_.emplace(std::move(*undo));
  }
  return writer;
}

Expected<void> PortWriter::write(std::vector<PackagePort>& ports) {
  if (!out_dir_ && !undo_) return {};
  Expected<void> ready;
  if (undo_ && !options_.force) ready = check_committed(ports);
  for (std::size_t i = 0; ready && out_dir_ && i < ports.size(); ++i) ready = out_dir_->stage(ports[i]);
  if (!ready) return ports.clear(), ready;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    const Expected<void> done = write_one(ports[i]);
    if (!done) return ports.erase(ports.begin() + static_cast<long>(i), ports.end()), done;
  }
  return {};
}

Expected<void> PortWriter::write_one(const PackagePort& port) {
  if (out_dir_) {
    has_written_ = true;
    return out_dir_->move_in(port);
  }
  if (port.contents.empty()) return {};
  const Expected<void> saved = save_undo(port);
  if (!saved) return saved;
  Expected<void> done = write_in_place(port);
  if (done || is_swap_unfinished(port.package_dir))
    has_written_ = true;
  else
    undo_->drop_last();
  return done;
}

/// Without a place that the user named, a port is worth more than its undo patch: git has the originals, too.
Expected<void> PortWriter::save_undo(const PackagePort& port) {
  Expected<void> saved = undo_->add(port);
  if (saved || !options_.undo.empty()) return saved;
  warning_ = "no undo patch could be saved: " + to_string(saved.error());
  return {};
}

}  // namespace tzc::rewriter
