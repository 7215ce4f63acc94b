// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a control part, read as several message types against blocks of exact sizes: refused, or every
// array lies inside the blocks.
#include <nav_msgs/Path.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JoyFeedbackArray.h>
#include <sensor_msgs/MultiEchoLaserScan.h>
#include <sensor_msgs/PointCloud.h>
#include <tzc/message.h>
#include <visualization_msgs/InteractiveMarker.h>

#include <cstdlib>
#include <memory>

#include "../../runtime/message/random_message.h"

namespace {

using tzc::ConstBlock;

struct Blocks {
  std::unique_ptr<std::uint8_t[]> small{new std::uint8_t[64]()};
  std::unique_ptr<std::uint8_t[]> large{new std::uint8_t[1000]()};
  std::vector<ConstBlock> list{ConstBlock{small.get(), 64}, ConstBlock{large.get(), 1000}};
};

bool lies_inside(const ConstBlock& block, const void* data, std::size_t bytes) {
  const auto* const first = static_cast<const std::uint8_t*>(data);
  return first >= block.data && first + bytes <= block.data + block.size;
}

template <class M>
void try_as(const std::uint8_t* control, std::size_t size, const Blocks& blocks) {
  const auto view = tzc::message::make_view<M>(control, size, blocks.list, nullptr);
  const auto copy = tzc::message::make_copy<M>(control, size, blocks.list);
  if (bool(view) != bool(copy)) std::abort();
  if (!view) return;
  tzc::test::visit_arrays(*view, [&](const void* data, std::size_t bytes) {
    if (!lies_inside(blocks.list[0], data, bytes) && !lies_inside(blocks.list[1], data, bytes)) std::abort();
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Blocks blocks;
  if (size == 0) return 0;
  using Try = void (*)(const std::uint8_t*, std::size_t, const Blocks&);
  static const Try types[] = {try_as<sensor_msgs::Image>,
                              try_as<sensor_msgs::PointCloud>,
                              try_as<sensor_msgs::JoyFeedbackArray>,
                              try_as<sensor_msgs::MultiEchoLaserScan>,
                              try_as<nav_msgs::Path>,
                              try_as<visualization_msgs::InteractiveMarker>};
  types[data[0] % (sizeof types / sizeof *types)](data + 1, size - 1, blocks);
  return 0;
}
