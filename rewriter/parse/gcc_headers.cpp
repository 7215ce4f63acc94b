// SPDX-License-Identifier: BSD-3-Clause
#include "parse/gcc_headers.h"

namespace tzc::rewriter {
namespace {

/// GCC's stddef.h declares it in the global namespace as well.
constexpr const char* prelude = "typedef decltype(nullptr) nullptr_t;\n";

/// Clang cannot parse GCC's omp.h, and Clang's own comes with a package that is often not installed. Only the
/// declarations matter here: nothing is compiled.
constexpr const char* omp = R"(#pragma once
#include <cstddef>
#include <cstdint>
typedef struct omp_lock_t { void* lock; } omp_lock_t;
typedef struct omp_nest_lock_t { void* lock; } omp_nest_lock_t;
typedef enum omp_sched_t {
  omp_sched_static = 1, omp_sched_dynamic = 2, omp_sched_guided = 3, omp_sched_auto = 4,
  omp_sched_monotonic = 0x80000000u
} omp_sched_t;
typedef enum omp_proc_bind_t {
  omp_proc_bind_false = 0, omp_proc_bind_true = 1, omp_proc_bind_master = 2, omp_proc_bind_primary = 2,
  omp_proc_bind_close = 3, omp_proc_bind_spread = 4
} omp_proc_bind_t;
typedef enum omp_lock_hint_t {
  omp_lock_hint_none = 0, omp_lock_hint_uncontended = 1, omp_lock_hint_contended = 2,
  omp_lock_hint_nonspeculative = 4, omp_lock_hint_speculative = 8
} omp_lock_hint_t;
typedef omp_lock_hint_t omp_sync_hint_t;
extern "C" {
void omp_set_num_threads(int) noexcept;
int omp_get_num_threads() noexcept;
int omp_get_max_threads() noexcept;
int omp_get_thread_num() noexcept;
int omp_get_num_procs() noexcept;
int omp_in_parallel() noexcept;
void omp_set_dynamic(int) noexcept;
int omp_get_dynamic() noexcept;
void omp_set_nested(int) noexcept;
int omp_get_nested() noexcept;
int omp_get_cancellation() noexcept;
void omp_set_schedule(omp_sched_t, int) noexcept;
void omp_get_schedule(omp_sched_t*, int*) noexcept;
int omp_get_thread_limit() noexcept;
void omp_set_max_active_levels(int) noexcept;
int omp_get_max_active_levels() noexcept;
int omp_get_level() noexcept;
int omp_get_ancestor_thread_num(int) noexcept;
int omp_get_team_size(int) noexcept;
int omp_get_active_level() noexcept;
int omp_in_final() noexcept;
omp_proc_bind_t omp_get_proc_bind() noexcept;
int omp_get_num_places() noexcept;
int omp_get_place_num_procs(int) noexcept;
void omp_get_place_proc_ids(int, int*) noexcept;
int omp_get_place_num() noexcept;
void omp_set_default_device(int) noexcept;
int omp_get_default_device() noexcept;
int omp_get_num_devices() noexcept;
int omp_get_num_teams() noexcept;
int omp_get_team_num() noexcept;
int omp_is_initial_device() noexcept;
int omp_get_initial_device() noexcept;
int omp_get_max_task_priority() noexcept;
double omp_get_wtime() noexcept;
double omp_get_wtick() noexcept;
void omp_init_lock(omp_lock_t*) noexcept;
void omp_init_lock_with_hint(omp_lock_t*, omp_lock_hint_t) noexcept;
void omp_destroy_lock(omp_lock_t*) noexcept;
void omp_set_lock(omp_lock_t*) noexcept;
void omp_unset_lock(omp_lock_t*) noexcept;
int omp_test_lock(omp_lock_t*) noexcept;
void omp_init_nest_lock(omp_nest_lock_t*) noexcept;
void omp_init_nest_lock_with_hint(omp_nest_lock_t*, omp_lock_hint_t) noexcept;
void omp_destroy_nest_lock(omp_nest_lock_t*) noexcept;
void omp_set_nest_lock(omp_nest_lock_t*) noexcept;
void omp_unset_nest_lock(omp_nest_lock_t*) noexcept;
int omp_test_nest_lock(omp_nest_lock_t*) noexcept;
}
)";

}  // namespace

const std::map<std::string, std::string>& gcc_headers() {
  static const std::map<std::string, std::string> headers{{gcc_prelude, prelude},
                                                          {std::string(gcc_header_dir) + "/omp.h", omp}};
  return headers;
}

}  // namespace tzc::rewriter
