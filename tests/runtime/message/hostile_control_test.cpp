// SPDX-License-Identifier: BSD-3-Clause
// Control parts that no honest peer sends: refused, or read inside of the blocks; never more
// memory than a constant times the input. Run under AddressSanitizer this also shows that nothing is read
// elsewhere.
#include "counting_new.h"
#include "message_types.h"
#include "random_message.h"
#include "test_memory.h"

namespace tzc {
namespace message {
namespace {

using test::TestMemory;
using Bytes = std::vector<std::uint8_t>;

/// What a subscriber gets: control bytes and blocks in memory of exactly their size.
struct Received {
  Bytes control;
  std::vector<std::unique_ptr<std::uint8_t[]>> memory;
  std::vector<ConstBlock> blocks;

  explicit Received(const Encoded& encoded) : control(encoded.control) {
    for (const BufferPtr& buffer : encoded.buffers) {
      memory.emplace_back(new std::uint8_t[buffer->size()]);
      std::memcpy(memory.back().get(), buffer->data(), buffer->size());
      blocks.push_back(ConstBlock{memory.back().get(), buffer->size()});
    }
  }

  bool contains(const void* data, std::size_t bytes) const {
    const auto* const first = static_cast<const std::uint8_t*>(data);
    return std::any_of(blocks.begin(), blocks.end(), [=](const ConstBlock& block) {
      return first >= block.data && bytes <= block.size &&
             first - block.data <= std::ptrdiff_t(block.size - bytes);
    });
  }
  std::size_t size() const {
    std::size_t total = control.size();
    for (const ConstBlock& block : blocks) total += block.size;
    return total;
  }
};

/// Reads `control`, of exactly its size, against the blocks; true when it was accepted.
template <class M>
bool survives(const Received& received, const Bytes& control) {
  const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[control.size()]);
  std::copy(control.begin(), control.end(), exact.get());
  const auto view = make_view<M>(exact.get(), control.size(), received.blocks, nullptr);
  test::requested_bytes = 0;
  const auto copy = make_copy<M>(exact.get(), control.size(), received.blocks);
  EXPECT_LE(test::requested_bytes, 4096 + 64 * sizeof(M) + 64 * received.size());
  EXPECT_EQ(bool(view), bool(copy));
  if (!view) return false;
  test::visit_arrays(
      *view, [&](const void* data, std::size_t bytes) { EXPECT_TRUE(received.contains(data, bytes)); });
  return true;
}

/// A message of some type, received; and how to read a control part as that type.
struct Case {
  Received received;
  bool (*survives)(const Received&, const Bytes&);
};

template <class M>
void add_cases(std::vector<Case>& cases, const std::shared_ptr<TestMemory>& memory) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    Encoded encoded;
    if (!encode(test::random_message<M>(seed), memory, encoded))
      throw std::runtime_error("no memory for the test");
    cases.push_back(Case{Received(encoded), &survives<M>});
  }
}

template <class... M>
std::vector<Case> cases_of(::testing::Types<M...>) {
  const auto memory = std::make_shared<TestMemory>();
  std::vector<Case> cases;
  (add_cases<M>(cases, memory), ...);
  return cases;
}

class HostileControl : public ::testing::Test {
 protected:
  /// check(case) for every message type, until one fails.
  template <class Check>
  void for_all(Check check) {
    static const std::vector<Case> cases = cases_of(test::MessageTypes());
    for (std::size_t i = 0; i < cases.size() && !HasFailure(); ++i) {
      SCOPED_TRACE("case " + std::to_string(i));
      check(cases[i]);
    }
  }
};

TEST(ControlReader, elements_without_bytes_are_refused_but_none_of_them_are_none) {
  const std::vector<ConstBlock> blocks;
  const std::uint8_t none[4] = {0, 0, 0, 0}, many[4] = {1, 0, 0, 0};
  EXPECT_EQ(detail::ControlReader(none, 4, blocks).vector_size(0), 0u);
  EXPECT_THROW(detail::ControlReader(many, 4, blocks).vector_size(0), detail::ControlReader::Malformed);
}

TEST_F(HostileControl, untouched_is_accepted) {
  for_all([](const Case& c) { EXPECT_TRUE(c.survives(c.received, c.received.control)); });
}

TEST_F(HostileControl, cut_anywhere_is_refused) {
  for_all([](const Case& c) {
    for (std::size_t size = 0; size < c.received.control.size(); ++size) {
      const Bytes cut(c.received.control.begin(), c.received.control.begin() + size);
      EXPECT_FALSE(c.survives(c.received, cut)) << "cut at " << size;
    }
  });
}

TEST_F(HostileControl, bytes_too_many_are_refused) {
  for_all([](const Case& c) {
    Bytes longer = c.received.control;
    longer.push_back(0);
    EXPECT_FALSE(c.survives(c.received, longer));
  });
}

TEST_F(HostileControl, any_byte_changed_stays_inside_the_blocks) {
  for_all([](const Case& c) {
    for (std::size_t at = 0; at < c.received.control.size(); ++at) {
      for (const int mask : {0x01, 0x40, 0x80, 0xff}) {
        Bytes flipped = c.received.control;
        flipped[at] ^= static_cast<std::uint8_t>(mask);
        c.survives(c.received, flipped);
      }
    }
  });
}

TEST_F(HostileControl, missing_blocks_are_refused) {
  for_all([](const Case& c) {
    Encoded nothing;
    Received bare(nothing);
    if (c.received.blocks.empty()) return;
    EXPECT_FALSE(c.survives(bare, c.received.control));
  });
}

TEST_F(HostileControl, noise_is_harmless) {
  std::mt19937 random(1);
  for_all([&](const Case& c) {
    for (int round = 0; round < 300; ++round) {
      Bytes noise(random() % 300);
      for (std::uint8_t& byte : noise) byte = random() % 3 ? 0 : static_cast<std::uint8_t>(random());
      c.survives(c.received, noise);
    }
  });
}

}  // namespace
}  // namespace message
}  // namespace tzc
