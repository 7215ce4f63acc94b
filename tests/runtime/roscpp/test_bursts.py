# SPDX-License-Identifier: BSD-3-Clause
"""What is published while a subscriber does not get a processor arrives as it does over TCPROS."""
import signal

from topic_case import TopicCase, main


class Bursts(TopicCase):
    def burst(self, count, **parameters):
        """Numbers of the messages that were published while both did not run, and what each of them missed: the one on
        shared memory, the one on TCPROS."""
        shared, plain = self.listen(queue=10000), self.listen("plain", queue=10000)
        witness = self.listen(queue=10000)
        talker = self.start_talker(count=0, subscribers=3, shared=2, **parameters)
        for listener in (shared, plain):
            self.wait_for(listener, 30)
        for listener in (shared, plain):
            listener.process.popen.send_signal(signal.SIGSTOP)
        begin = witness.numbers()[-1]
        self.wait_for(witness, len(witness.numbers()) + count)
        end = witness.numbers()[-1]
        for listener in (shared, plain):
            listener.process.popen.send_signal(signal.SIGCONT)
        self.wait_for_number(shared, end + 20)
        self.wait_for_number(plain, end + 20)
        self.finish(talker)
        self.assertEqual({m["shared"] for m in plain.messages()}, {False})
        return [sorted(set(range(begin, end)) - set(listener.numbers())) for listener in (shared, plain)]

    def wait_for_number(self, listener, number):
        self.ros.wait_until(lambda: listener.numbers()[-1] >= number, 20, f"number {number}")

    def test_a_queue_of_one(self):
        for size in (1000, 20000, 300000):
            with self.subTest(size=size):
                self.setUp()
                shared, _ = self.burst(min(200, 2500000 // size), rate=500, queue=1, bytes=size)
                self.assertEqual(shared, [])  # TCPROS loses some where its sockets have not grown yet
                self.tearDown()

    def test_more_than_sockets_hold(self):
        shared, plain = self.burst(60, rate=100, queue=2, bytes=300000)
        self.assertGreater(len(plain), 20)
        self.assertGreater(len(shared), 0)
        self.assertLessEqual(len(shared), len(plain))


if __name__ == "__main__":
    main()
