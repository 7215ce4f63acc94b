# SPDX-License-Identifier: BSD-3-Clause
"""The fuzzer's own promises: programs are reproducible, every pattern occurs, and what differs is noticed."""
import json
import os
import random
import re
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from copies import check_copies, mark_needless  # noqa: E402
from execution import differences, keep_counters_of, last_program  # noqa: E402
from grammar import absent, added, attacks, builders, changes, effects, keepers, later, libraries, messages, names  # noqa: E402
from grammar import outputs, owners, package, pointers, publishers, subscribers, times  # noqa: E402
from grammar.program import Program  # noqa: E402
from grammar.uses import Use  # noqa: E402
from port import check_levels, check_sites  # noqa: E402
from toolchain import Failure  # noqa: E402


class Programs(unittest.TestCase):
    def test_a_program_does_not_depend_on_its_neighbours(self):
        alone = package.make_program("7", 12)
        among_others = [package.make_program("7", index) for index in range(20)][12]
        self.assertEqual(alone.render(), among_others.render())

    def test_another_seed_makes_other_programs(self):
        self.assertNotEqual(package.make_program("7", 12).render(), package.make_program("8", 12).render())

    def test_every_pattern_occurs(self):
        seen = set()
        for index in range(500):
            seen.update(package.make_program("1", index).traits)
        ways = [*builders.WAYS, *publishers.HOMES, *libraries.SENSORS, *libraries.VISION, *libraries.CLOUDS]
        missing = {way.__name__ for way in ways} | {"relay: " + way.__name__ for way in subscribers.RELAYS}
        self.assertEqual(missing - seen, set())

    def test_every_attack_occurs(self):
        seen = set()
        for index in range(2000):
            seen.update(package.make_program("1", index, adversarial=True).traits)
        ways = [("owner", owners.OWNERS), ("store", pointers.STORES + keepers.STORES), ("transfer", owners.TRANSFERS),
                ("output", outputs.PLAIN + attacks.HIDDEN), ("time", [*times.ONCE, *times.ANEW, attacks.in_next_step]),
                ("home", names.HOMES), ("name", names.STANDS_FOR), ("use", names.DOES), ("change", changes.CHANGES + changes.WHOLE),
                ("later", later.WAYS), ("added", added.WAYS), ("owner", added.OWNERS), *attacks.REACHES.items()]
        self.assertEqual({f"{kind}: {way.__name__}" for kind, some in ways for way in some} - seen, set())

    def test_what_writes_when_it_ends_does_not_outlive_the_elements(self):
        late = {"store: " + store.__name__ for store in keepers.WRITE_AT_END}
        for index in range(1000):
            for topic in package.make_program("1", index, adversarial=True).topics:
                if late & set(topic.traits):
                    self.assertIn("transfer: unchanged", topic.traits, topic.name)

    def test_a_pointer_that_is_made_once_never_becomes_null(self):
        """The next step follows it."""
        made_once = 0
        for owner in owners.OWNERS:
            program = Program(random.Random(1), 1)
            owned = owner(program, messages.IMAGE)
            if f"{owned.argument} = boost::make_shared<sensor_msgs::Image>();" in program.setup:
                made_once += 1
                lines, _ = owners.by_swapped_pointer(messages.IMAGE, owned)
                self.assertEqual(lines, ["sensor_msgs::ImagePtr next = boost::make_shared<sensor_msgs::Image>();",
                                         f"next.swap({owned.argument});"])
        self.assertGreater(made_once, 0)

    def test_no_program_swaps_a_pointer_that_is_made_once_with_an_empty_one(self):
        for index in range(2000):
            program = package.make_program("1", index, adversarial=True)
            text = "\n".join("\n".join(part) for part in program.render())
            made_once = set(re.findall(r"(\w+) = boost::make_shared", "\n".join(program.setup)))
            for other, pointer in re.findall(r"(\w+)\.swap\((\w+)\);", text):
                if pointer in made_once and other not in made_once:
                    filled = rf"Ptr {other} = boost::make_shared<.*\n *{other}\.swap\({pointer}\)"
                    self.assertTrue(re.search(filled, text), f"{program.name}: {pointer}")

    def test_no_loop_waits_for_a_step_of_what_is_published(self):
        """An output may leave that out, as in_branch does."""
        for way in effects.WAYS + absent.MADE + absent.HELD:
            for seed in range(10):
                use = Use(Program(random.Random(seed), 1), messages.IMAGE, lambda program, message: Silent())
                text = "\n".join(way(use))
                if re.search(r"(for|while) \([^{]*\bat != [^;{]*(;\s*)?\) {", text):
                    self.assertRegex(text, r"\+\+at;|at\+\+;", way.__name__)


    def test_what_steps_stays_within_its_messages(self):
        """An output may publish its argument twice, as `twice` does; the loop has two turns."""
        for way in (effects.iterator_that_steps, effects.pointer_that_steps):
            program = Program(random.Random(1), 1)
            text = "\n".join(way(Use(program, messages.IMAGE, lambda program, message: Twice())))
            size = re.search(r"(?:resize\(|\[)(\d+)", "\n".join(program.state + program.setup))
            self.assertEqual(2 * text.count("at++"), int(size[1]), way.__name__)


class Silent:
    def publish(self, argument, pointer=False):
        return []


class Twice:
    def publish(self, argument, pointer=False):
        return [f"publish({argument});"] * 2


class Comparison(unittest.TestCase):
    BEFORE = {("recorder.log", "/p001/topic1"): ["10:aa", "12:bb"], ("listener.log", "/p001/topic1"): ["10:aa",
                                                                                                       "12:bb"]}

    def test_equal(self):
        self.assertEqual(differences(self.BEFORE, dict(self.BEFORE)), [])

    def test_another_message_is_named(self):
        after = {**self.BEFORE, ("listener.log", "/p001/topic1"): ["10:aa", "12:bc"]}
        self.assertIn("/p001/topic1 (listener.log): 2 messages before, 2 after; message 1",
                      differences(self.BEFORE, after)[0])

    def test_a_missing_message_is_named(self):
        after = {**self.BEFORE, ("recorder.log", "/p001/topic1"): ["10:aa"]}
        self.assertIn("2 messages before, 1 after; message 1", differences(self.BEFORE, after)[0])

    def test_a_missing_topic_is_named(self):
        self.assertEqual(len(differences(self.BEFORE, {})), 2)


class Copies(unittest.TestCase):
    def check(self, level, messages, copied):
        site = {"kind": "publish", "topic": "/p001/topic1", "level": level}
        with tempfile.TemporaryDirectory() as folder:
            with open(f"{folder}/recorder.log", "w") as file:
                file.writelines(f"/p001/topic1 100 {i:x} 00- copied\n" for i in range(8))
            for name, part in (("counters_half", 4), ("counters", 4 + messages)):
                topic = {"topic": "/p001/topic1", "messages": part, "copied_bytes": 4000 + (copied if part > 4 else 0)}
                with open(f"{folder}/{name}.json", "w") as file:
                    json.dump({"nodes": [{"topics": [topic]}]}, file)
            check_copies([site], folder)
            mark_needless([site], folder)
            return site["needless"]

    def test_a_level_that_is_not_true_is_noticed(self):
        with self.assertRaisesRegex(Failure, "/p001/topic1: 420 bytes of its last 6 messages"):
            self.check("zero_copy", 6, 420)

    def test_the_first_message_may_be_copied(self):
        self.check("zero_copy", 6, 70)

    def test_who_says_that_it_copies_may(self):
        self.check("one_copy", 6, 420)


    def test_a_level_that_is_lost_for_nothing_is_marked(self):
        for level, copied, needless in (("one_copy", 0, True), ("one_copy", 70, False), ("zero_copy", 0, False)):
            with self.subTest(level=level, copied=copied):
                self.assertEqual(self.check(level, 6, copied), needless)


class Talker(unittest.TestCase):
    def test_counters_of_other_runs_do_not_count(self):
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/counters.json"
            with open(path, "w") as file:
                json.dump({"nodes": [{"pid": 7, "topics": []}, {"pid": 8, "topics": ["ours"]}]}, file)
            keep_counters_of(8, path)
            with open(path) as file:
                self.assertEqual(json.load(file), {"nodes": [{"pid": 8, "topics": ["ours"]}]})

    def test_the_program_that_ends_it_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(last_program(folder), "before the first step")
            with open(f"{folder}/talker.running", "w") as file:
                file.write("p184\n")
            self.assertEqual(last_program(folder), "in p184")

    def test_each_step_is_announced(self):
        text = package.main_text([package.make_program("1", index) for index in range(2)])
        self.assertRegex(text, r'fuzz::running\("p000"\);\n *p000::step\(k\);[^}]*running\("p001"\);\n *p001::step')


class Sites(unittest.TestCase):
    def test_a_site_that_the_report_misses_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            package.write_packages(folder, [package.make_program("1", index) for index in range(6)])
            with self.assertRaisesRegex(Failure, "publish sites are written, 0 are in the report"):
                check_sites(folder, {"sites": []})

    def test_a_site_that_stays_plain_is_noticed(self):
        site = {"kind": "publish", "file": "src/a.cpp", "line": 7, "level": "plain", "code": "TZC1017", "reason": "lost"}
        with self.assertRaisesRegex(Failure, "src/a.cpp:7 publish plain TZC1017 lost"):
            check_levels({"sites": [site]})
        check_levels({"sites": [{**site, "level": "one_copy"}]})
        check_levels({"sites": [site]}, may_be_plain=True)

    def test_a_port_that_would_not_compile_is_noticed(self):
        site = {"kind": "publish", "file": "src/a.cpp", "line": 7, "level": "one_copy", "code": "TZC1009", "reason": "no"}
        with self.assertRaisesRegex(Failure, "src/a.cpp:7 publish one_copy TZC1009 no"):
            check_levels({"sites": [site]})
        check_levels({"sites": [{**site, "reason": "ported, no matching function for call to 'fill'"}]})


if __name__ == "__main__":
    unittest.main()
