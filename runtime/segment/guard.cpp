// SPDX-License-Identifier: BSD-3-Clause
#include "tzc/guard.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "segment/guard_report.h"
#include "segment/guard_settings.h"

namespace tzc {
namespace guard {
namespace {

constexpr std::size_t usual_quarantine = 16;
constexpr std::size_t most_quarantine = 1024;

__thread bool has_number = false;
__thread std::uint64_t current_number = 0;

bool is_one_of(const char* text, std::initializer_list<const char*> words) {
  for (const char* word : words)
    if (std::strcmp(text, word) == 0) return true;
  return false;
}

Action read_action() {
  const char* text = std::getenv("TZC_GUARD");
  if (text == nullptr || is_one_of(text, {"", "0", "off", "false", "no"})) return Action::none;
  if (is_one_of(text, {"1", "on", "true", "yes"})) return Action::go_on;
  if (is_one_of(text, {"abort"})) return Action::abort;
  std::fprintf(
      stderr,
      "TZC: TZC_GUARD cannot be '%s': it is one of 0, 1, abort; guard mode is off (share/doc/tzc/guard.md)\n",
      text);
  return Action::none;
}

std::size_t read_quarantine() {
  const char* text = std::getenv("TZC_GUARD_QUARANTINE");
  if (text == nullptr || *text == '\0') return usual_quarantine;
  char* end = nullptr;
  const unsigned long blocks = std::strtoul(text, &end, 10);
  if (*end == '\0' && blocks >= 1 && blocks <= most_quarantine) return blocks;
  std::fprintf(stderr,
               "TZC: TZC_GUARD_QUARANTINE cannot be '%s': it is a number from 1 to %zu; %zu is taken "
               "(share/doc/tzc/guard.md)\n",
               text, most_quarantine, usual_quarantine);
  return usual_quarantine;
}

}  // namespace

Action action() noexcept {
  static const Action given = read_action();
  return given;
}

std::size_t quarantined_blocks() noexcept {
  static const std::size_t given = read_quarantine();
  return given;
}

std::uint64_t message_number(std::uint64_t otherwise) noexcept {
  return has_number ? current_number : otherwise;
}

bool active = action() != Action::none;

void MessageNumber::set(std::uint64_t number) noexcept {
  has_number = true;
  current_number = number;
}

void MessageNumber::clear() noexcept {
  has_number = false;
}

}  // namespace guard
}  // namespace tzc
