// SPDX-License-Identifier: BSD-3-Clause
// What the stand-ins include of the standard library; precompiled for the tests.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>
