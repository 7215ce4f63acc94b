// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A function of the hot path, from publish() to the callback. The linker puts them all next to each other: right
/// after a wake-up each further page of code costs a walk through the page tables, and on a virtual machine a
/// long one.
#define TZC_HOT __attribute__((hot))
