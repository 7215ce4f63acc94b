// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/String.h>
