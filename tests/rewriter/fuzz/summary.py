# SPDX-License-Identifier: BSD-3-Clause
"""What a run of the fuzzer says at its end: which levels were reached, with which patterns, and at which price."""
import collections
import resource


def table(sites):
    """kind -> level -> count"""
    levels = collections.defaultdict(collections.Counter)
    for site in sites:
        levels[site["kind"]][site["level"]] += 1
    return "\n".join(f"  {kind:10}" + ", ".join(f"{count} {level}" for level, count in levels[kind].most_common())
                     for kind in sorted(levels))


def share(counts):
    return f"{counts['zero_copy']}/{sum(counts.values()) - counts['not_needed']}"


def levels_by_trait(levels):
    """How many sites of each pattern were ported to zero_copy: an attack on what is not ported tests nothing."""
    kinds = collections.defaultdict(list)
    for trait in sorted(levels):
        kind, name = trait.split(": ")
        kinds[kind].append(f"{name} {share(levels[trait])}")
    return "\n".join(f"  {kind:10}" + ", ".join(names) for kind, names in kinds.items())


def zero_copy_share(sites):
    counts = collections.Counter(site["level"] for site in sites if site["kind"] == "publish")
    needed = sum(counts.values()) - counts["not_needed"]
    return f"  zero_copy {counts['zero_copy']} of {needed} publish sites" + (
        f": {100 * counts['zero_copy'] // needed} %" if needed else "")


def remarks(sites):
    codes = collections.Counter(site["code"] for site in sites if site["kind"] == "publish" and site["code"])
    needless = collections.Counter(site["code"] or "no code" for site in sites if site["needless"])
    return "\n".join(f"  {what}" + ", ".join(f"{count} {code}" for code, count in counts.most_common())
                     for what, counts in (("remarks   ", codes), ("needless  ", needless)))


def processor_seconds():
    """Of all processes that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Summary:
    """Adds up what batches did."""

    def __init__(self):
        self.sites, self.traits, self.levels = [], collections.Counter(), collections.defaultdict(collections.Counter)
        self.programs = self.messages = self.shared = 0
        self.seconds = collections.Counter()

    def add(self, batch, sites, messages, shared):
        self.sites += sites
        self.messages, self.shared = self.messages + messages, self.shared + shared
        self.programs += len(batch.programs)
        self.traits += batch.traits()
        for trait, counts in batch.levels(sites).items():
            self.levels[trait] += counts

    def __str__(self):
        lines = [f"{self.programs} programs, {self.messages} messages compared, {self.shared} received through shared "
                 "memory", table(self.sites), zero_copy_share(self.sites), remarks(self.sites)]
        if self.levels:
            lines.append(levels_by_trait(self.levels))
        lines.append("  patterns  " + ", ".join(f"{count} {trait}" for trait, count in self.traits.most_common()))
        lines.append("  phases    " + ", ".join(f"{what} {used:.0f} s" for what, used in self.seconds.items()))
        used = processor_seconds()
        return "\n".join(lines + [f"  processor {used:.0f} s" + (
            f", {used / self.programs:.1f} s a program" if self.programs else "")])
