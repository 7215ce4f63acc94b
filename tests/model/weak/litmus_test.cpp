// SPDX-License-Identifier: BSD-3-Clause
// The explorer of the C++ memory model on litmus tests whose outcomes are published: Lahav et al., "Repairing sequential
// consistency in C/C++11" (PLDI 2017); Sarkar et al., "Understanding POWER multiprocessors" (PLDI 2011) and the test7
// guide of Maranget, Sarkar and Sewell, which name them; C++20 (P0668, P0982) for release sequences and SC.
#include <gtest/gtest.h>

#include <algorithm>

#include "weak/explorer.h"

namespace tzc {
namespace model {
namespace weak {
namespace {

constexpr auto rlx = std::memory_order_relaxed;
constexpr auto acq = std::memory_order_acquire;
constexpr auto rel = std::memory_order_release;
constexpr auto acq_rel = std::memory_order_acq_rel;
constexpr auto sc = std::memory_order_seq_cst;
enum Location : std::size_t { x, y, z };

using Step = std::function<void(Context&)>;
using Thread = std::vector<Step>;
/// What the reads return, thread by thread, and the last values that are asked for.
using Result = std::vector<Word>;

Step W(Location location, Word value, std::memory_order order) {
  return [=](Context& context) { Atomic(context, location).store(value, order); };
}
Step R(Location location, std::memory_order order) {
  return [=](Context& context) { context.note(Atomic(context, location).load(order)); };
}
Step Add(Location location, std::memory_order order) {
  return [=](Context& context) { context.note(Atomic(context, location).fetch_add(1, order)); };
}
Step F(std::memory_order order) {
  return [=](Context& context) { fence(context, order); };
}
Step PlainW(Location location, Word value) {
  return [=](Context& context) { Plain(context, location).write(value); };
}
Step PlainR(Location location) {
  return [=](Context& context) { context.note(Plain(context, location).read()); };
}
/// Only if the thread's first read returned that.
Step When(Word value, const Step& step) {
  return [=](Context& context) {
    if (context.notes().front() == value) step(context);
  };
}

struct LitmusTest {
  std::vector<Thread> threads;
  bool with_last = false;  // the last values of x and y are part of the result
};

Explorer explorer_of(const LitmusTest& test, std::vector<Result>& results) {
  Explorer explorer;
  explorer.initial = {0, 0, 0};
  for (const Thread& thread : test.threads) {
    explorer.threads.push_back([&thread](Context& context) {
      for (const Step& step : thread) step(context);
    });
  }
  explorer.on_end = [&results, &test](const Outcome& outcome) {
    Result result;
    for (const auto& notes : outcome.notes) result.insert(result.end(), notes.begin(), notes.end());
    if (test.with_last) result.insert(result.end(), {outcome.last[x], outcome.last[y]});
    results.push_back(result);
  };
  return explorer;
}

testing::AssertionResult allows(const LitmusTest& test, const Result& result) {
  std::vector<Result> results;
  Explorer explorer = explorer_of(test, results);
  if (!explorer.explore()) return testing::AssertionFailure() << explorer.violation();
  if (results.empty()) return testing::AssertionFailure() << "no execution at all";
  return std::count(results.begin(), results.end(), result) > 0
             ? testing::AssertionSuccess() << "allowed"
             : testing::AssertionFailure() << "not among " << results.size() << " executions";
}

/// Explored to its end, and never so.
testing::AssertionResult forbids(const LitmusTest& test, const Result& result) {
  std::vector<Result> results;
  Explorer explorer = explorer_of(test, results);
  if (!explorer.explore() || results.empty()) return testing::AssertionFailure() << explorer.violation();
  return std::count(results.begin(), results.end(), result) == 0 ? testing::AssertionSuccess()
                                                                 : testing::AssertionFailure() << "allowed";
}

std::string refusal(const LitmusTest& test) {
  std::vector<Result> results;
  Explorer explorer = explorer_of(test, results);
  return explorer.explore() ? "" : explorer.violation();
}

LitmusTest sb(std::memory_order write, std::memory_order read) {
  return {{{W(x, 1, write), R(y, read)}, {W(y, 1, write), R(x, read)}}};
}

TEST(Litmus, store_buffering) {
  EXPECT_TRUE(allows(sb(rlx, rlx), {0, 0}));
  EXPECT_TRUE(allows(sb(rel, acq), {0, 0}));
  EXPECT_TRUE(allows(sb(sc, rlx), {0, 0}));
  EXPECT_TRUE(allows(sb(sc, acq), {0, 0}));
  EXPECT_TRUE(forbids(sb(sc, sc), {0, 0}));
  EXPECT_TRUE(allows(sb(sc, sc), {0, 1}));
  EXPECT_TRUE(allows(sb(sc, sc), {1, 1}));
}

TEST(Litmus, store_buffering_with_fences) {
  const auto with = [](std::memory_order order) {
    return LitmusTest{{{W(x, 1, rlx), F(order), R(y, rlx)}, {W(y, 1, rlx), F(order), R(x, rlx)}}};
  };
  EXPECT_TRUE(forbids(with(sc), {0, 0}));
  EXPECT_TRUE(allows(with(acq_rel), {0, 0}));
  EXPECT_TRUE(allows({{{W(x, 1, rlx), F(sc), R(y, rlx)}, {W(y, 1, rlx), R(x, rlx)}}}, {0, 0}));
  EXPECT_TRUE(forbids({{{W(x, 1, rlx), F(sc), R(y, rlx)}, {W(y, 1, sc), R(x, sc)}}}, {0, 0}));
}

TEST(Litmus, store_buffering_with_updates) {
  const auto with = [](std::memory_order order, std::memory_order read) {
    return LitmusTest{{{Add(x, order), R(y, read)}, {Add(y, order), R(x, read)}}};
  };
  EXPECT_TRUE(forbids(with(sc, sc), {0, 0, 0, 0}));
  EXPECT_TRUE(allows(with(acq_rel, acq), {0, 0, 0, 0}));
}

LitmusTest mp(std::memory_order write, std::memory_order read) {
  return {{{W(x, 1, rlx), W(y, 1, write)}, {R(y, read), R(x, rlx)}}};
}

TEST(Litmus, message_passing) {
  EXPECT_TRUE(allows(mp(rlx, rlx), {1, 0}));
  EXPECT_TRUE(allows(mp(rel, rlx), {1, 0}));
  EXPECT_TRUE(allows(mp(rlx, acq), {1, 0}));
  EXPECT_TRUE(forbids(mp(rel, acq), {1, 0}));
  EXPECT_TRUE(forbids(mp(sc, sc), {1, 0}));
  EXPECT_TRUE(allows(mp(rel, acq), {0, 0}));
  EXPECT_TRUE(allows(mp(rel, acq), {0, 1}));
}

TEST(Litmus, message_passing_with_fences) {
  EXPECT_TRUE(forbids({{{W(x, 1, rlx), F(rel), W(y, 1, rlx)}, {R(y, rlx), F(acq), R(x, rlx)}}}, {1, 0}));
  EXPECT_TRUE(forbids({{{W(x, 1, rlx), F(rel), W(y, 1, rlx)}, {R(y, acq), R(x, rlx)}}}, {1, 0}));
  EXPECT_TRUE(forbids({{{W(x, 1, rlx), W(y, 1, rel)}, {R(y, rlx), F(acq), R(x, rlx)}}}, {1, 0}));
  EXPECT_TRUE(allows({{{W(x, 1, rlx), F(acq), W(y, 1, rlx)}, {R(y, rlx), F(acq), R(x, rlx)}}}, {1, 0}));
  EXPECT_TRUE(allows({{{W(x, 1, rlx), F(rel), W(y, 1, rlx)}, {R(y, rlx), F(rel), R(x, rlx)}}}, {1, 0}));
}

// A relaxed write after an SC one may be seen first: SC does not make its write a fence.
TEST(Litmus, message_passing_past_an_sc_write) {
  EXPECT_TRUE(allows({{{W(x, 1, sc), W(y, 1, rlx)}, {R(y, rlx), R(x, sc)}}}, {1, 0}));
  EXPECT_TRUE(allows({{{W(x, 1, sc), W(y, 1, rel)}, {R(y, rlx), R(x, sc)}}}, {1, 0}));
}

TEST(Litmus, release_sequences_are_continued_by_updates_alone) {
  const auto with = [](const Step& second) {
    return LitmusTest{{{W(x, 1, rlx), W(y, 1, rel), second}, {R(y, acq), R(x, rlx)}}};
  };
  const Result result{2, 0};
  EXPECT_TRUE(allows(with(W(y, 2, rlx)), result));
  const LitmusTest by_update{{{W(x, 1, rlx), W(y, 1, rel)}, {Add(y, rlx)}, {R(y, acq), R(x, rlx)}}};
  EXPECT_TRUE(forbids(by_update, {1, 2, 0}));
  EXPECT_TRUE(allows(by_update, {0, 1, 0}));
}

// RC11 forbids it and hardware does not; so such a program is refused, not declared right.
TEST(Litmus, load_buffering_is_out_of_scope) {
  const auto lb = [](std::memory_order read, std::memory_order write) {
    return LitmusTest{{{R(x, read), W(y, 1, write)}, {R(y, read), W(x, 1, write)}}};
  };
  EXPECT_NE(refusal(lb(rlx, rlx)).find("load buffering"), std::string::npos);
  EXPECT_NE(refusal({{{R(x, rlx), W(y, 1, rlx)}, {R(y, acq), W(x, 1, rel)}}}).find("load buffering"),
            std::string::npos);
  EXPECT_TRUE(forbids(lb(acq, rlx), {1, 1}));
  EXPECT_TRUE(forbids(lb(rlx, rel), {1, 1}));
  EXPECT_TRUE(forbids({{{R(x, rlx), F(acq), W(y, 1, rlx)}, {R(y, rlx), F(acq), W(x, 1, rlx)}}}, {1, 1}));
}

LitmusTest iriw(std::memory_order write, std::memory_order read) {
  return {{{W(x, 1, write)}, {W(y, 1, write)}, {R(x, read), R(y, read)}, {R(y, read), R(x, read)}}};
}

TEST(Litmus, independent_reads_of_independent_writes) {
  const Result result{1, 0, 1, 0};
  EXPECT_TRUE(allows(iriw(rlx, rlx), result));
  EXPECT_TRUE(allows(iriw(rel, acq), result));
  EXPECT_TRUE(allows(iriw(sc, acq), result));
  EXPECT_TRUE(forbids(iriw(sc, sc), result));
  const LitmusTest fenced{
      {{W(x, 1, rlx)}, {W(y, 1, rlx)}, {R(x, rlx), F(sc), R(y, rlx)}, {R(y, rlx), F(sc), R(x, rlx)}}};
  EXPECT_TRUE(forbids(fenced, result));
}

// With one acquire each, the two SC reads may disagree about the SC writes (Lahav et al., figure 1).
TEST(Litmus, independent_reads_acquire_then_sc) {
  const LitmusTest test{{{W(x, 1, sc)}, {R(x, acq), R(y, sc)}, {R(y, acq), R(x, sc)}, {W(y, 1, sc)}}};
  EXPECT_TRUE(allows(test, {1, 0, 1, 0}));
}

TEST(Litmus, z6_u) {
  const LitmusTest test{{{W(x, 1, sc), W(y, 1, rel)}, {Add(y, sc), R(y, rlx)}, {W(y, 3, sc), R(x, sc)}}};
  EXPECT_TRUE(allows(test, {1, 3, 0}));
}

TEST(Litmus, two_plus_two_writes) {
  const auto with = [](std::memory_order order) {
    return LitmusTest{{{W(x, 1, order), W(y, 2, order)}, {W(y, 1, order), W(x, 2, order)}}, true};
  };
  EXPECT_TRUE(allows(with(rlx), {1, 1}));
  EXPECT_TRUE(allows(with(rel), {1, 1}));
  EXPECT_TRUE(forbids(with(sc), {1, 1}));
}

TEST(Litmus, write_to_read_causality) {
  const auto with = [](std::memory_order write, std::memory_order read) {
    return LitmusTest{{{W(x, 1, rlx)}, {R(x, read), W(y, 1, write)}, {R(y, read), R(x, rlx)}}};
  };
  EXPECT_TRUE(allows(with(rel, acq), {1, 1, 1}));
  EXPECT_TRUE(forbids({{{W(x, 1, rel)}, {R(x, acq), W(y, 1, rel)}, {R(y, acq), R(x, rlx)}}}, {1, 1, 0}));
  EXPECT_TRUE(allows({{{W(x, 1, rlx)}, {R(x, acq), W(y, 1, rlx)}, {R(y, acq), R(x, rlx)}}}, {1, 1, 0}));
}

TEST(Litmus, isa2) {
  const auto with = [](std::memory_order second) {
    return LitmusTest{{{W(x, 1, rlx), W(y, 1, rel)}, {R(y, acq), W(z, 1, second)}, {R(z, acq), R(x, rlx)}}};
  };
  EXPECT_TRUE(forbids(with(rel), {1, 1, 0}));
  EXPECT_TRUE(allows(with(rlx), {1, 1, 0}));
}

TEST(Litmus, read_to_write_causality) {
  const auto with = [](std::memory_order write, std::memory_order read) {
    return LitmusTest{{{W(x, 1, write)}, {R(x, read), R(y, read)}, {W(y, 1, write), R(x, read)}}};
  };
  EXPECT_TRUE(allows(with(rel, acq), {1, 0, 0}));
  EXPECT_TRUE(forbids(with(sc, sc), {1, 0, 0}));
  EXPECT_TRUE(forbids({{{W(x, 1, rel)}, {R(x, acq), F(sc), R(y, rlx)}, {W(y, 1, rlx), F(sc), R(x, rlx)}}},
                      {1, 0, 0}));
}

TEST(Litmus, r_and_s) {
  const auto r = [](std::memory_order write, std::memory_order read) {
    return LitmusTest{{{W(x, 1, write), W(y, 1, write)}, {W(y, 2, write), R(x, read)}}, true};
  };
  EXPECT_TRUE(allows(r(rel, acq), {0, 1, 2}));
  EXPECT_TRUE(forbids(r(sc, sc), {0, 1, 2}));
  const auto s = [](std::memory_order write, std::memory_order read) {
    return LitmusTest{{{W(x, 2, rlx), W(y, 1, write)}, {R(y, read), W(x, 1, rlx)}}, true};
  };
  EXPECT_TRUE(allows(s(rlx, acq), {1, 2, 1}));
  EXPECT_TRUE(forbids(s(rel, acq), {1, 2, 1}));
}

TEST(Litmus, coherence) {
  EXPECT_TRUE(forbids({{{W(x, 1, rlx)}, {R(x, rlx), R(x, rlx)}}}, {1, 0}));
  EXPECT_TRUE(forbids({{{W(x, 1, rlx), W(x, 2, rlx)}, {R(x, rlx), R(x, rlx)}}}, {2, 1}));
  EXPECT_TRUE(forbids({{{W(x, 1, rlx), W(x, 2, rlx)}}, true}, {1, 0}));
  EXPECT_TRUE(forbids({{{W(x, 1, rlx), R(x, rlx)}, {W(x, 2, rlx)}}, true}, {2, 1, 0}));
  EXPECT_TRUE(forbids({{{R(x, rlx), W(x, 1, rlx)}, {W(x, 2, rlx)}}, true}, {2, 2, 0}));
  EXPECT_TRUE(forbids({{{W(x, 1, rlx)}, {W(x, 2, rlx)}, {R(x, rlx), R(x, rlx)}, {R(x, rlx), R(x, rlx)}}},
                      {1, 2, 2, 1}));
}

TEST(Litmus, updates_are_atomic) {
  EXPECT_TRUE(forbids({{{Add(x, rlx)}, {Add(x, rlx)}}}, {0, 0}));
  EXPECT_TRUE(forbids({{{Add(x, rlx)}, {W(x, 5, rlx)}}, true}, {0, 1, 0}) &&
              allows({{{Add(x, rlx)}, {W(x, 5, rlx)}}, true}, {0, 5, 0}) &&
              allows({{{Add(x, rlx)}, {W(x, 5, rlx)}}, true}, {5, 6, 0}));
}

TEST(Litmus, memory_that_is_no_atomic_must_not_be_raced_for) {
  const auto with = [](std::memory_order write, std::memory_order read) {
    return LitmusTest{{{PlainW(x, 1), W(y, 1, write)}, {R(y, read), When(1, PlainR(x))}}};
  };
  EXPECT_NE(refusal(with(rlx, acq)).find("race"), std::string::npos);
  EXPECT_NE(refusal(with(rel, rlx)).find("race"), std::string::npos);
  EXPECT_TRUE(allows(with(rel, acq), {1, 1}));
  EXPECT_TRUE(forbids(with(rel, acq), {1, 0}));
}

TEST(Explorer, a_thread_that_waits_for_ever_is_found) {
  Explorer explorer;
  explorer.initial = {0};
  explorer.threads = {[](Context& context) { Atomic(context, x).await(1, acq); }};
  EXPECT_FALSE(explorer.explore());
  EXPECT_EQ(explorer.violation(), "a thread waits for ever");
  explorer.threads.push_back([](Context& context) { Atomic(context, x).store(1, rlx); });
  Explorer other = explorer;
  EXPECT_TRUE(other.explore()) << other.violation();
}

}  // namespace
}  // namespace weak
}  // namespace model
}  // namespace tzc
