// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc::compare {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGQUIT are noted, so that what was started can be stopped in order.
void watch_for_stop_requests();

/// Waits. Throws Stopped as soon as one of those signals has come.
void sleep_ms(int milliseconds);

}  // namespace tzc::compare
