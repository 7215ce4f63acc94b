// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pcl_conversions/pcl_conversions.h>
#include <ros/ros.h>
