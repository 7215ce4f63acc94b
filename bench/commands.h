// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace bench {

struct Command {
  const char* name;
  const char* help;
  int (*run)(int argc, char** argv);  // argv[0] is the command; returns the exit code
};

int run_core(int argc, char** argv);
int run_roscpp(int argc, char** argv);
int run_scale(int argc, char** argv);
int run_soak(int argc, char** argv);
int run_sustained(int argc, char** argv);
int run_paper(int argc, char** argv);
int run_inside(int argc, char** argv);

}  // namespace bench
}  // namespace tzc
