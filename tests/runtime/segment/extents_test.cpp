// SPDX-License-Identifier: BSD-3-Clause
#include "segment/extents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "segment/size_class.h"

namespace tzc {
namespace segment {
namespace {

struct Range {
  std::uint64_t offset, bytes;
};

TEST(Extents, returns_the_lowest_fit) {
  Extents extents(64, 1000);
  EXPECT_EQ(extents.allocate(100), 64u);
  EXPECT_EQ(extents.allocate(100), 164u);
  extents.release(64, 100);
  EXPECT_EQ(extents.allocate(200), 264u);
  EXPECT_EQ(extents.allocate(50), 64u);
}

TEST(Extents, joins_neighbours_whatever_the_order) {
  std::vector<int> order{0, 1, 2, 3};
  do {
    Extents extents(0, 400);
    for (int i = 0; i < 4; ++i) ASSERT_EQ(extents.allocate(100), static_cast<std::uint64_t>(i) * 100);
    for (const int i : order) extents.release(static_cast<std::uint64_t>(i) * 100, 100);
    EXPECT_TRUE(extents.empty());
    EXPECT_EQ(extents.allocate(400), 0u);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Extents, stays_below_the_limit) {
  Extents extents(0, 1000);
  EXPECT_EQ(extents.allocate(300, 299), Extents::none);
  EXPECT_EQ(extents.allocate(300, 300), 0u);
  EXPECT_EQ(extents.allocate(1, 300), Extents::none);
}

TEST(Extents, one_size_loses_nothing) {
  std::mt19937 random(1);
  const std::uint64_t size = 4096 + 64, blocks = 100;
  Extents extents(0, size * blocks);
  std::vector<std::uint64_t> live;
  for (int i = 0; i < 100'000; ++i) {
    if (live.size() < blocks && random() % 2 == 0) {
      live.push_back(extents.allocate(size));
      ASSERT_NE(live.back(), Extents::none);
    } else if (!live.empty()) {
      std::swap(live[random() % live.size()], live.back());
      extents.release(live.back(), size);
      live.pop_back();
    }
  }
}

// The stated bound: M * (1 + log2 n) for sizes between unit and n * unit, of which M are in use at most.
std::uint64_t bound(std::uint64_t most_in_use, std::uint64_t n) {
  return static_cast<std::uint64_t>(static_cast<double>(most_in_use) *
                                    (1 + std::log2(static_cast<double>(n))));
}

TEST(Extents, random_traffic_stays_within_the_bound) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const std::uint64_t unit = 64, n = 1 << (1 + seed % 12), most = unit * n * 16;
    Extents extents(0, bound(most, n));
    std::vector<Range> live;
    std::uint64_t in_use = 0;
    for (int i = 0; i < 20'000; ++i) {
      const std::uint64_t bytes = unit * (1 + random() % n);
      if (in_use + bytes <= most) {
        const std::uint64_t offset = extents.allocate(bytes);
        ASSERT_NE(offset, Extents::none) << "seed " << seed;
        live.push_back({offset, bytes});
        in_use += bytes;
      } else {
        std::swap(live[random() % live.size()], live.back());
        extents.release(live.back().offset, live.back().bytes);
        in_use -= live.back().bytes;
        live.pop_back();
      }
    }
  }
}

// Robson's adversary (1971): in round i keep one word of each 2^i range, at the offset that keeps most ranges
// occupied, free the rest, and ask for ranges of 2^i. It forces any allocator to waste about half of log2 n.
TEST(Extents, robsons_adversary_stays_within_the_bound) {
  const std::uint64_t most = 1 << 12, rounds = 8, n = 1 << rounds;
  Extents extents(0, bound(most, n));
  std::vector<Range> live;
  std::uint64_t in_use = 0;
  for (std::uint64_t round = 0; round <= rounds; ++round) {
    const std::uint64_t size = std::uint64_t{1} << round;
    const auto covers = [size](const Range& range, std::uint64_t remainder) {
      const std::uint64_t first = range.offset + (remainder + size - range.offset % size) % size;
      return first < range.offset + range.bytes;
    };
    std::uint64_t best = 0, best_kept = 0;
    for (std::uint64_t remainder = 0; remainder < size; ++remainder) {
      std::uint64_t waste = 0;
      for (const Range& range : live)
        waste += covers(range, remainder) ? size - std::min(size, range.bytes) : 0;
      if (waste > best_kept) best = remainder, best_kept = waste;
    }
    std::vector<Range> kept;
    for (const Range& range : live) {
      if (covers(range, best)) {
        kept.push_back(range);
      } else {
        extents.release(range.offset, range.bytes);
        in_use -= range.bytes;
      }
    }
    live = kept;
    while (in_use + size <= most) {
      const std::uint64_t offset = extents.allocate(size);
      ASSERT_NE(offset, Extents::none) << "round " << round;
      live.push_back({offset, size});
      in_use += size;
    }
  }
}

// 20,000 ranges of 1 KB between blocks that are kept: a search for 2 KB passes over them once, and over those that come
// back since, one at a time.
TEST(Extents, ranges_that_are_too_small_are_not_looked_at_again) {
  constexpr std::uint64_t small = 1024, ranges = 20'000, searches = 1'000;
  Extents extents(0, 4 * small * ranges);
  for (std::uint64_t i = 0; i < 2 * ranges; ++i) ASSERT_EQ(extents.allocate(small), i * small);
  for (std::uint64_t i = 0; i < 2 * ranges; i += 2) extents.release(i * small, small);
  const std::uint64_t first = extents.allocate(2 * small);
  EXPECT_EQ(first, 2 * ranges * small);
  const std::uint64_t before = extents.looked_at();
  for (std::uint64_t i = 0; i < searches; ++i) {
    extents.release(first, 2 * small);
    ASSERT_EQ(extents.allocate(2 * small), first);
  }
  EXPECT_LE(extents.looked_at() - before, 2 * searches);
  extents.release(3 * small, small);  // joins both neighbours: lower, and now large enough
  EXPECT_EQ(extents.allocate(2 * small), 2 * small);
}

// As before the searches began anywhere but at the first range.
std::uint64_t lowest_fit(const std::vector<bool>& used, std::uint64_t bytes) {
  std::uint64_t length = 0;
  for (std::uint64_t i = 0; i < used.size(); ++i) {
    length = used[i] ? 0 : length + 1;
    if (length == bytes) return i + 1 - bytes;
  }
  return Extents::none;
}

TEST(Extents, finds_the_lowest_fit_whatever_was_released) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    constexpr std::uint64_t size = 2'000;
    Extents extents(0, size);
    std::vector<bool> used(size);
    std::vector<Range> live;
    for (int i = 0; i < 2'000; ++i) {
      const std::uint64_t bytes = 1 + random() % (1 << random() % 9);
      const std::uint64_t expected = lowest_fit(used, bytes), offset = extents.allocate(bytes);
      ASSERT_EQ(offset, expected) << "seed " << seed << ", step " << i;
      if (offset != Extents::none) {
        live.push_back({offset, bytes});
        std::fill_n(used.begin() + static_cast<std::ptrdiff_t>(offset), bytes, true);
      }
      if (live.empty() || (offset != Extents::none && random() % 2 == 0)) continue;
      std::swap(live[random() % live.size()], live.back());
      extents.release(live.back().offset, live.back().bytes);
      std::fill_n(used.begin() + static_cast<std::ptrdiff_t>(live.back().offset), live.back().bytes, false);
      live.pop_back();
    }
  }
}

TEST(SizeClass, wastes_less_than_a_sixteenth_plus_a_cache_line) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const std::size_t bytes = random() >> (random() % 60);
    if (bytes > SIZE_MAX / 4) continue;
    const std::size_t rounded = size_class(bytes);
    ASSERT_GE(rounded, bytes);
    ASSERT_LE(rounded, bytes + bytes / 16 + cache_line);
    ASSERT_EQ(rounded % cache_line, 0u);
    ASSERT_EQ(size_class(rounded), rounded);
  }
  EXPECT_EQ(size_class(0), cache_line);
  EXPECT_EQ(size_class(4 << 20), 4u << 20);
}

}  // namespace
}  // namespace segment
}  // namespace tzc
