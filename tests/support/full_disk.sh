#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: full_disk.sh PROGRAM ARGUMENT...
# A program whose output finds a full disk says so and does not succeed.
set -uo pipefail
errors=$("$@" 2>&1 >/dev/full)
status=$?
[ "$status" -ne 0 ] && grep -q "No space left on device" <<<"$errors" && ! grep -q "defect" <<<"$errors" && exit 0
printf 'ends with %s and says: %s\n' "$status" "$errors"
exit 1
