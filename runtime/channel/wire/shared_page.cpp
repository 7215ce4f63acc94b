// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wire/shared_page.h"

#include <new>

#include "posix/shared_memory.h"
#include "trace/trace.h"

namespace tzc {
namespace channel {
namespace {

// The number of its file is the same in both processes.
std::uint64_t trace_number_of(int file) {
  if (!trace::active) return 0;
  const auto identity = posix::identify(file);
  return identity ? identity->number : 0;
}

}  // namespace

Expected<SharedPage> SharedPage::create(std::uint32_t first_sequence) {
  const std::size_t size = posix::page_size();
  auto memory = posix::create_shared_memory("tzc-connection", size, size, posix::Sharing::peers_write);
  if (!memory) return memory.error();
  SharedPage page;
  page.file_ = std::move(memory->file);
  page.mapping_ = std::move(memory->mapping);
  page.trace_number_ = trace_number_of(page.fd());
  new (page.mapping_.data()) ConnectionPage{{pack(DeliveryCursors{first_sequence, first_sequence})}, {}};
  return {std::move(page)};
}

Expected<SharedPage> SharedPage::open(posix::FileDescriptor file, std::size_t size) {
  Error wrong;
  wrong.what = "refuse a connection page of " + std::to_string(size) + " bytes";
  if (size < sizeof(ConnectionPage) || size > (std::size_t{1} << 20)) return wrong;
  const Status checked = posix::check_received(file.get(), size, posix::Sharing::peers_write);
  if (!checked) return checked.error();
  auto mapping = posix::Mapping::map(file.get(), size, posix::Access::read_write);
  if (!mapping) return mapping.error();
  SharedPage page;
  page.mapping_ = std::move(*mapping);
  page.trace_number_ = trace_number_of(file.get());
  return {std::move(page)};
}

}  // namespace channel
}  // namespace tzc
