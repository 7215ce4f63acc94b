// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// TZC for roscpp nodes: tzc::advertise, tzc::Publisher, tzc::subscribe, tzc::attach, tzc::attached.
#include <ros/ros.h>
#include <tzc/advertise.h>
#include <tzc/allocate.h>
#include <tzc/attach.h>
#include <tzc/direct_dispatch.h>
#include <tzc/publish.h>
#include <tzc/publisher.h>
#include <tzc/spin.h>
#include <tzc/subscribe.h>
