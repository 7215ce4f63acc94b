// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <geometry_msgs/Point.h>
