// SPDX-License-Identifier: BSD-3-Clause
#include "engine/verdict.h"

#include <fmt/format.h>

#include <algorithm>

namespace tzc::compare {
namespace {

constexpr double own_factor = 2, own_margin = 0.05, own_margin_s = 2;

double share(std::size_t count, std::size_t total) {
  return total == 0 ? 0 : static_cast<double>(count) / static_cast<double>(total);
}

bool is_stamp(const std::string& field) {
  const std::string end = "header.stamp";
  return field.size() >= end.size() && field.compare(field.size() - end.size(), end.size(), end) == 0;
}

class StreamJudge {
 public:
  StreamJudge(StreamComparison port, std::vector<const StreamComparison*> own, const Rules& rules)
      : port_(std::move(port)), own_(std::move(own)), rules_(rules) {}

  StreamVerdict run() {
    if (port_.first.is_advertised && port_.second.is_advertised) {
      judge_messages();
    } else {
      judge_presence();
    }
    StreamVerdict verdict{std::move(port_), Outcome::equal, std::move(findings_)};
    verdict.outcome = outcome(verdict);
    return verdict;
  }

 private:
  void judge_presence() {
    const bool varies = std::any_of(own_.begin(), own_.end(), [](const StreamComparison* own) {
      return own->first.is_advertised != own->second.is_advertised;
    });
    const std::size_t total = std::max(port_.first.messages, port_.second.messages);
    findings_.push_back({port_.first.is_advertised ? Cause::not_published : Cause::new_topic, "", total,
                         total, varies ? 1.0 : 0.0, !varies, ""});
  }

  void judge_messages() {
    if (!port_.type_difference.empty()) {
      findings_.push_back({Cause::type, "", 0, 0, 0, true, port_.type_difference});
      return;
    }
    judge_loss();
    const std::size_t duplicates = port_.pairing.duplicates;
    add(
        Cause::extra, "", judged(port_.pairing.second_only), port_.second.messages, rules_.allowed_loss,
        [&](const StreamComparison& own) { return lost_or_extra_share(own); },
        duplicates ? fmt::format("{} of them repeat another message", duplicates) : "");
    add(
        Cause::order, "", port_.pairing.reordered, port_.pairing.pairs.size(), 0,
        [](const StreamComparison& own) { return share(own.pairing.reordered, own.pairing.pairs.size()); },
        "");
    for (const auto& [path, field] : port_.fields) judge_field(path, field);
  }

  void judge_field(const std::string& path, const FieldCount& field) {
    add(
        Cause::content, path, field.messages, port_.pairing.pairs.size(), 0,
        [&path = path](const StreamComparison& own) {
          const auto found = own.fields.find(path);
          return found == own.fields.end() ? 0 : share(found->second.messages, own.pairing.pairs.size());
        },
        describe(field));
  }

  static std::string describe(const FieldCount& field) {
    const FieldDifference& first = field.example;
    const std::string offset = first.first_offset == first.second_offset
                                   ? fmt::format("byte {}", first.first_offset)
                                   : fmt::format("bytes {} and {}", first.first_offset, first.second_offset);
    return fmt::format("first in message {}: {}{}: {} in the original, {} in the port",
                       field.example_pair.first, first.where.empty() ? "" : first.where + " at ", offset,
                       first.first_value, first.second_value);
  }

  void judge_loss() {
    std::size_t count = judged(port_.pairing.first_only);
    std::string detail;
    if (!rules_.judge_after && falls_silent()) {
      count += port_.pairing.first_only.after.size();
      detail = fmt::format("the port has published nothing in its last {:.1f} s", port_.second.silence_s);
    }
    add(
        Cause::loss, "", count, port_.first.messages, rules_.allowed_loss,
        [&](const StreamComparison& own) { return lost_or_extra_share(own); }, detail);
  }

  /// Whether the port is silent before the end of its run for longer than chance explains.
  bool falls_silent() const {
    double own_s = port_.first.silence_s;
    for (const StreamComparison* own : own_) own_s = std::max(own_s, own->second.silence_s);
    return port_.second.silence_s > own_factor * own_s + own_margin_s;
  }

  std::size_t judged(const Unpaired& unpaired) const {
    const bool judge_before = rules_.judge_before && rules_.late_topics.count(port_.topic) == 0;
    return unpaired.between.size() + (judge_before ? unpaired.before.size() : 0) +
           (rules_.judge_after ? unpaired.after.size() : 0);
  }

  /// Which of two runs of the same program loses a message is chance, so losses count in both directions.
  double lost_or_extra_share(const StreamComparison& own) const {
    return std::max(share(judged(own.pairing.first_only), own.first.messages),
                    share(judged(own.pairing.second_only), own.second.messages));
  }

  template <class OwnShare>
  void add(Cause cause, const std::string& field, std::size_t count, std::size_t total, double allowed,
           const OwnShare& own_share, const std::string& detail) {
    if (count == 0) return;
    double own = 0;
    for (const StreamComparison* comparison : own_) own = std::max(own, own_share(*comparison));
    if (own > 0) allowed = std::max(allowed, own_factor * own + own_margin);
    findings_.push_back({cause, field, count, total, own, share(count, total) > allowed, detail});
  }

  Outcome outcome(const StreamVerdict& verdict) const {
    const auto counts = [&](const Finding& finding) {
      return finding.is_different ||
             (rules_.strict && finding.cause == Cause::content && !is_stamp(finding.field));
    };
    if (std::any_of(verdict.findings.begin(), verdict.findings.end(), counts)) return Outcome::different;
    if (verdict.comparison.first.messages == 0 && verdict.comparison.second.messages == 0)
      return Outcome::silent;
    return verdict.findings.empty() ? Outcome::equal : Outcome::own_differences;
  }

  StreamComparison port_;
  const std::vector<const StreamComparison*> own_;
  const Rules rules_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<StreamVerdict> judge(const std::vector<Comparison>& own, Comparison port, const Rules& rules) {
  std::vector<StreamVerdict> verdicts;
  for (StreamComparison& stream : port) {
    std::vector<const StreamComparison*> same;
    for (const Comparison& comparison : own)
      for (const StreamComparison& candidate : comparison)
        if (candidate.key() == stream.key()) same.push_back(&candidate);
    verdicts.push_back(StreamJudge(std::move(stream), std::move(same), rules).run());
  }
  return verdicts;
}

bool is_different(const std::vector<StreamVerdict>& verdicts) {
  return std::any_of(verdicts.begin(), verdicts.end(),
                     [](const StreamVerdict& verdict) { return verdict.outcome == Outcome::different; });
}

const char* name(Cause cause) {
  switch (cause) {
    case Cause::not_published:
      return "not_published";
    case Cause::new_topic:
      return "new_topic";
    case Cause::type:
      return "type";
    case Cause::loss:
      return "loss";
    case Cause::extra:
      return "extra";
    case Cause::order:
      return "order";
    case Cause::content:
      return "content";
  }
  return "";
}

const char* name(Outcome outcome) {
  switch (outcome) {
    case Outcome::equal:
      return "equal";
    case Outcome::own_differences:
      return "own_differences";
    case Outcome::silent:
      return "silent";
    case Outcome::different:
      return "different";
  }
  return "";
}

}  // namespace tzc::compare
