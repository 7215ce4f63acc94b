// SPDX-License-Identifier: BSD-3-Clause
// The inner loops of the module `message`. Not part of the test run: build target message_bench and run it.
#include <benchmark/benchmark.h>
#include <tzc/message.h>
#include <tzc/sensor_msgs/Image.h>
#include <tzc/sensor_msgs/PointCloud.h>

#include <numeric>

#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace {

constexpr std::size_t four_megabytes = 4 << 20;

std::shared_ptr<test::TestMemory> memory() {
  static const auto shared = std::make_shared<test::TestMemory>();
  return shared;
}

sensor_msgs::Image allocated_image(std::size_t bytes) {
  sensor_msgs::Image image;
  image.header.frame_id = "camera";
  image.encoding = "rgb8";
  image.data.resize(bytes);
  if (!message::allocate(image, memory())) throw std::runtime_error("no memory");
  return image;
}

void EncodeTwin(benchmark::State& state) {
  const auto image = allocated_image(static_cast<std::size_t>(state.range(0)));
  message::Encoded encoded;
  for (auto _ : state) {
    if (!message::encode(image, memory(), encoded)) state.SkipWithError("no memory");
    benchmark::DoNotOptimize(encoded.control.data());
  }
}
BENCHMARK(EncodeTwin)->Arg(4096)->Arg(four_megabytes)->Arg(64 << 20);

void EncodeStockView(benchmark::State& state) {
  const auto image = allocated_image(four_megabytes);
  message::Encoded encoded, again;
  message::encode(image, memory(), encoded);
  const auto view = message::stock_view(image, encoded);
  for (auto _ : state) {
    if (!message::encode(*view, memory(), again)) state.SkipWithError("no memory");
    benchmark::DoNotOptimize(again.control.data());
  }
}
BENCHMARK(EncodeStockView);

/// A cloud whose channels are added after allocate, and bound or not, is filled and encoded. Arguments: channels, values of each.
template <bool bound>
void BuildChannels(benchmark::State& state) {
  const auto channels = static_cast<std::size_t>(state.range(0)),
             values = static_cast<std::size_t>(state.range(1));
  message::Encoded encoded;
  for (auto _ : state) {
    sensor_msgs::PointCloud cloud;
    if (!message::allocate(cloud, memory())) state.SkipWithError("no memory");
    if (bound)
      cloud.channels.resize(channels);
    else
      static_cast<std::vector<sensor_msgs::ChannelFloat32>&>(cloud.channels).resize(channels);
    for (auto& channel : cloud.channels) {
      channel.values.resize(values);
      std::iota(channel.values.begin(), channel.values.end(), 0.0F);
    }
    if (!message::encode(cloud, memory(), encoded)) state.SkipWithError("no memory");
    encoded = message::Encoded();
  }
}
BENCHMARK_TEMPLATE(BuildChannels, false)->ArgsProduct({{1, 4, 16, 64}, {4, 1000, 100000}});
BENCHMARK_TEMPLATE(BuildChannels, true)->ArgsProduct({{1, 4, 16, 64}, {4, 1000, 100000}});

void EncodeStock(benchmark::State& state) {
  ::sensor_msgs::Image image;
  image.data.resize(static_cast<std::size_t>(state.range(0)));
  message::Encoded encoded;
  for (auto _ : state) {
    if (!message::encode(image, memory(), encoded)) state.SkipWithError("no memory");
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * state.range(0));
}
BENCHMARK(EncodeStock)->Arg(4096)->Arg(four_megabytes);

/// What a publish makes for callbacks of its own process, read as they read it.
template <class View>
void show_and_read(benchmark::State& state, View view) {
  const auto image = allocated_image(static_cast<std::size_t>(state.range(0)));
  message::Encoded encoded;
  message::encode(image, memory(), encoded);
  for (auto _ : state) {
    const auto seen = view(image, encoded);
    for (std::size_t i = 0; i < seen->data.size(); i += 64) benchmark::DoNotOptimize(seen->data[i]);
  }
}
void ShowStockView(benchmark::State& state) {
  show_and_read(state, [](const auto& image, auto& encoded) { return message::stock_view(image, encoded); });
}
BENCHMARK(ShowStockView)->Arg(1000)->Arg(4096)->Arg(four_megabytes);
void ShowCallbackView(benchmark::State& state) {
  show_and_read(state,
                [](const auto& image, auto& encoded) { return message::callback_view(image, encoded); });
}
BENCHMARK(ShowCallbackView)->Arg(1000)->Arg(4096)->Arg(four_megabytes);

void MakeView(benchmark::State& state) {
  const auto image = allocated_image(four_megabytes);
  message::Encoded encoded;
  message::encode(image, memory(), encoded);
  const auto blocks = test::blocks_of(encoded);
  const auto hold = std::make_shared<int>();
  for (auto _ : state) {
    auto view = message::make_view<::sensor_msgs::Image>(encoded.control.data(), encoded.control.size(),
                                                         blocks, hold);
    benchmark::DoNotOptimize(view);
  }
}
BENCHMARK(MakeView);

template <class Sequence>
Sequence make_sequence(std::size_t size) {
  return Sequence(size);
}
template <>
Array<float> make_sequence(std::size_t size) {
  Array<float> array;
  array.bind(memory());
  array.resize(size);
  return array;
}
template <>
Array<std::uint8_t> make_sequence(std::size_t size) {
  Array<std::uint8_t> array;
  array.bind(memory());
  array.resize(size);
  return array;
}

template <class Sequence>
void WriteByIndex(benchmark::State& state) {
  auto sequence = make_sequence<Sequence>(100000);
  for (auto _ : state) {
    for (std::size_t i = 0; i < sequence.size(); ++i)
      sequence[i] = static_cast<typename Sequence::value_type>(i * 3);
    benchmark::ClobberMemory();
  }
}
template <class Sequence>
void ReadByIndex(benchmark::State& state) {
  const auto sequence = make_sequence<Sequence>(100000);
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < sequence.size(); ++i) sum += static_cast<std::uint64_t>(sequence[i]);
    benchmark::DoNotOptimize(sum);
  }
}
template <class Sequence>
void WriteByIterator(benchmark::State& state) {
  auto sequence = make_sequence<Sequence>(100000);
  for (auto _ : state) {
    std::iota(sequence.begin(), sequence.end(), typename Sequence::value_type(1));
    benchmark::ClobberMemory();
  }
}
template <class Sequence>
void PushBack(benchmark::State& state) {
  auto sequence = make_sequence<Sequence>(100000);
  for (auto _ : state) {
    sequence.clear();
    for (int i = 0; i < 100000; ++i) sequence.push_back(static_cast<typename Sequence::value_type>(i));
    benchmark::ClobberMemory();
  }
}
#define TZC_COMPARE(Function)                              \
  BENCHMARK_TEMPLATE(Function, std::vector<std::uint8_t>); \
  BENCHMARK_TEMPLATE(Function, Array<std::uint8_t>);       \
  BENCHMARK_TEMPLATE(Function, std::vector<float>);        \
  BENCHMARK_TEMPLATE(Function, Array<float>)
TZC_COMPARE(WriteByIndex);
TZC_COMPARE(ReadByIndex);
TZC_COMPARE(WriteByIterator);
TZC_COMPARE(PushBack);

}  // namespace
}  // namespace tzc
