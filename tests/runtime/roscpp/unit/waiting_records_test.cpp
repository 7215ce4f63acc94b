// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/waiting_records.h"

#include <gtest/gtest.h>

#include <string>

namespace tzc {
namespace detail {
namespace {

channel::RecordPtr record(std::uint32_t number, std::size_t bytes = 1) {
  const std::string control(bytes, 'x');
  return channel::make_record(number, control.data(), control.size());
}

std::vector<std::uint32_t> drain(WaitingRecords& records) {
  std::vector<std::uint32_t> numbers;
  for (; !records.empty(); records.pop()) numbers.push_back(channel::parts_of(*records.front()).tag);
  return numbers;
}

using Numbers = std::vector<std::uint32_t>;

TEST(WaitingRecords, keep_their_order) {
  WaitingRecords records(10);
  for (std::uint32_t number : {3, 4, 5}) records.push(record(number));
  EXPECT_EQ(drain(records), (Numbers{3, 4, 5}));
}

TEST(WaitingRecords, undelivered_ones_come_first) {
  WaitingRecords records(10);
  records.push(record(3));
  records.push_before({record(1), record(2)});
  EXPECT_EQ(drain(records), (Numbers{1, 2, 3}));
}

TEST(WaitingRecords, small_ones_beyond_the_queue_wait_as_in_a_sockets_buffers) {
  WaitingRecords records(2);
  for (std::uint32_t number = 0; number < 100; ++number) records.push(record(number));
  EXPECT_EQ(drain(records).size(), 100u);
}

TEST(WaitingRecords, large_ones_beyond_the_queue_drop_the_oldest) {
  WaitingRecords records(2);
  for (std::uint32_t number = 0; number < 5; ++number) records.push(record(number, 3 << 20));
  EXPECT_EQ(drain(records), (Numbers{3, 4}));
}

TEST(WaitingRecords, popping_makes_room_again) {
  WaitingRecords records(1);
  for (int round = 0; round < 3; ++round) {
    records.push(record(1, 5 << 20));
    records.pop();
  }
  for (std::uint32_t number : {7, 8}) records.push(record(number));
  EXPECT_EQ(drain(records), (Numbers{7, 8})) << "what was taken out does not count any more";
}

TEST(WaitingRecords, the_newest_are_those_of_the_queue) {
  WaitingRecords records(2), unlimited(0);
  for (std::uint32_t number = 0; number < 5; ++number) {
    records.push(record(number));
    unlimited.push(record(number));
  }
  records.keep_newest();
  unlimited.keep_newest();
  EXPECT_EQ(drain(records), (Numbers{3, 4}));
  EXPECT_EQ(drain(unlimited).size(), 5u);
}

TEST(WaitingRecords, a_queue_without_a_limit_drops_nothing) {
  WaitingRecords records(0);
  for (std::uint32_t number = 0; number < 5; ++number) records.push(record(number, 3 << 20));
  EXPECT_EQ(drain(records).size(), 5u);
}

}  // namespace
}  // namespace detail
}  // namespace tzc
