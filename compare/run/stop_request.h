// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc::compare {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGQUIT are noted, so that what was started can be stopped in order; but for those
/// that are ignored already.
void watch_for_stop_requests();

/// Throws Stopped when one of those signals has come.
void check_for_stop_request();

/// Waits. Throws Stopped as soon as one of those signals has come.
void sleep_ms(int milliseconds);

}  // namespace tzc::compare
