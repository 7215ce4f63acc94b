// SPDX-License-Identifier: BSD-3-Clause
#include "paper/contender_table.h"

#include "core/contenders.h"
#ifdef TZC_BENCH_ROSCPP
#include "roscpp/contenders.h"
#endif

namespace tzc {
namespace bench {
namespace {

using Create = std::unique_ptr<Contender> (*)();

constexpr Create table[] = {
#ifdef TZC_BENCH_ROSCPP
    tcpros_contender,
    intraprocess_contender,
    tzc_queue_contender,
    tzc_spin_contender,
    tzc_direct_contender,
    asl_contender,
#endif
    ach_contender,
    tzc_reader_contender,
#ifdef TZC_BENCH_ICEORYX
    iceoryx_listener_contender,
#endif
#ifdef TZC_BENCH_LCM
    lcm_contender,
#endif
#ifdef TZC_BENCH_CYCLONE
    cyclone_contender,
    cyclone_shm_contender,
#endif
#ifdef TZC_BENCH_FASTDDS
    fastdds_contender,
    fastdds_shm_contender,
    fastdds_loan_contender,
#endif
};

constexpr Create real_time_table[] = {futex_contender, ach_contender, tzc_reader_contender};

template <std::size_t size>
Contenders create_all(const Create (&table)[size]) {
  Contenders contenders;
  for (const Create create : table) contenders.push_back(create());
  return contenders;
}

}  // namespace

Contenders all_contenders() {
  return create_all(table);
}

Contenders real_time_contenders() {
  return create_all(real_time_table);
}

nlohmann::json contender_versions() {
  nlohmann::json versions{{"tzc", TZC_VERSION}};
#ifdef TZC_BENCH_ROSCPP
  versions["roscpp"] = roscpp_version();
#endif
#ifdef TZC_BENCH_ICEORYX
  versions["iceoryx"] = iceoryx_version();
#endif
#ifdef TZC_BENCH_LCM
  versions["lcm"] = lcm_version();
#endif
#ifdef TZC_BENCH_CYCLONE
  versions["cyclonedds"] = cyclone_version();
#endif
#ifdef TZC_BENCH_FASTDDS
  versions["fastdds"] = fastdds_version();
#endif
  return versions;
}

}  // namespace bench
}  // namespace tzc
