# SPDX-License-Identifier: BSD-3-Clause
"""Guard mode: a port that writes too late is told where, and its subscribers see nothing of it; a right one hears nothing."""
import signal

from topic_case import TZC_RUN, TopicCase, main

GUARD = TZC_RUN + ["--guard"]
RIGHT = ("member", "fresh", "growing")


class Guard(TopicCase):
    def run_writer(self, mode, runner=GUARD, status=0, listeners=2, env=None, spinner="spin", **parameters):
        """(what it wrote to the terminal, its listeners)"""
        heard = [self.listen(name=f"listener_{mode}_{number}", spinner=spinner) for number in range(listeners)]
        writer = self.node("late_writer", f"writer_{mode}", dict(parameters, mode=mode, shared=listeners), runner=runner,
                           env=env)
        self.assertEqual(writer.wait(60), status, writer.tail())
        return writer.log(), heard

    def assert_late(self, mode, what, since, **how):
        output, listeners = self.run_writer(mode, **how)
        self.assertEqual(output.count("TZC guard: a"), 1, output)  # each place once, however many messages
        self.assertIn(what, output)
        self.assertIn(f"topic {self.name('image')}, ", output)
        self.assertIn("byte 0 of", output)
        publish, write = output.split(since)[1].split("here:")[:2]
        for stack in (publish, write):  # both lead into the program
            self.assertIn("late_writer(", stack)
        self.assertIn("20 late accesses from 1 places", output)
        for listener in listeners:
            self.assert_got(listener, range(20), shared=True)

    def test_a_write_after_publish(self):
        self.assert_late("published", "a write to a message after it was published", "published here:")

    def test_a_write_after_publish_to_a_small_payload(self):
        self.assert_late("published", "a write to a message after it was published", "published here:", bytes=100)

    def test_a_write_after_allocate(self):
        self.assert_late("replaced", "the old memory of an array that allocate has moved", "moved here:")

    def test_from_the_environment(self):
        self.assert_late("published", "a write to a message after it was published", "published here:", runner=(),
                         env={"TZC_GUARD": "1"})

    def test_the_number_is_that_of_the_header(self):
        output, listeners = self.run_writer("published", count=3)
        self.assertIn("message 0,", output)
        self.assert_seq_as_tcpros(listeners[0])

    def test_abort(self):
        output, listeners = self.run_writer("published", TZC_RUN + ["--guard=abort"], status=-signal.SIGABRT)
        self.assertEqual(output.count("TZC guard: a write"), 1, output)
        self.assert_got(listeners[0], range(1))

    def test_right_programs_hear_nothing(self):
        for mode in RIGHT:
            with self.subTest(mode):
                output, listeners = self.run_writer(mode)
                self.assertNotIn("TZC guard: a", output)
                self.assertRegex(output, r"[1-9]\d* blocks of published messages were watched, no late access")
                for listener in listeners:
                    self.assert_got(listener, range(20), shared=True)
                self.ros.stop_since(self.before)

    def test_off_is_silent_and_shows_what_guard_mode_hides(self):
        # Callbacks that come after all late writes: who reads earlier may be faster than the write.
        output, listeners = self.run_writer("published", runner=(), spinner="afterwards")
        self.assertNotIn("TZC guard", output)
        for listener in listeners:
            self.wait_for(listener, 20)
            self.assertFalse(any(message["right"] for message in listener.messages()))


class Options(TopicCase):
    def test_a_program_behind_the_option(self):
        self.assertEqual(self.ros.run(GUARD + ["rostopic", "list"])[0], 0)

    def test_wrong_ones(self):
        self.assertEqual(self.ros.run(GUARD)[0], 2)
        status, output = self.ros.run(TZC_RUN + ["--gard", "true"])
        self.assertEqual(status, 2)
        self.assertIn("--gard", output)


if __name__ == "__main__":
    main()
