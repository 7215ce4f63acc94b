// SPDX-License-Identifier: BSD-3-Clause
#include "posix/shared_memory.h"

#include <utility>

namespace tzc {
namespace posix {

Expected<SharedMemory> create_shared_memory(const char* name, std::size_t size, std::size_t committed,
                                            Sharing sharing) {
  auto file = create_memory_file(name, size, sharing);
  if (!file) return file.error();
  if (committed > 0) {
    const Status reserved = reserve(*file, 0, committed);
    if (!reserved) return reserved.error();
  }
  auto mapping = Mapping::map(file->descriptor.get(), size, Access::read_write);
  if (!mapping) return mapping.error();
  const Status sealed = seal(*file, sharing);
  if (!sealed) return sealed.error();
  return {SharedMemory{std::move(*file), std::move(*mapping)}};
}

}  // namespace posix
}  // namespace tzc
