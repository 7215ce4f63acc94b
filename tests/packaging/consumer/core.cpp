// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/channel.h>

#include <cstdio>

int main() {
  const auto publisher = tzc::channel::Publisher::create(tzc::channel::PublisherOptions());
  const bool allocated = publisher && (*publisher)->memory()->allocate(3);
  std::printf("3 bytes, %s\n", allocated ? "allocated" : "not allocated");
}
