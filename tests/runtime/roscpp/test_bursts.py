# SPDX-License-Identifier: BSD-3-Clause
"""What is published while a subscriber does not get a processor arrives as it does over TCPROS."""
import signal

from topic_case import TopicCase, main

BEFORE = 30  # messages; the sockets' buffers grow with what passes


def most_socket_buffers():
    """To what the two buffers of a TCP connection may grow on this machine, in bytes, and what a channel has more (decision 509)."""
    total = 0
    for setting, usual in (("tcp_rmem", 6 << 20), ("tcp_wmem", 4 << 20)):
        try:
            with open(f"/proc/sys/net/ipv4/{setting}", encoding="ascii") as numbers:
                total += int(numbers.read().split()[2])
        except OSError:
            total += usual
    return total * 9 // 8 + (1 << 20)


class Bursts(TopicCase):
    def burst(self, count, **parameters):
        """Publishes `count` messages while neither subscriber runs; what each of them missed: the one on shared memory, the one
        on TCPROS."""
        listeners = self.listen(queue=10000), self.listen("plain", queue=10000)
        talker = self.start_talker(count=BEFORE + count, pause=BEFORE, linger=600, subscribers=2, shared=1, **parameters)
        for listener in listeners:
            self.wait_for_number(listener, BEFORE - 1)  # the newest one is never lost, older ones may be over TCPROS
            listener.process.popen.send_signal(signal.SIGSTOP)
        talker.popen.send_signal(signal.SIGUSR2)
        last = self.last_published(talker)
        for listener in listeners:
            listener.process.popen.send_signal(signal.SIGCONT)
            self.wait_for_number(listener, last)
        self.assertEqual(last, BEFORE + count - 1)
        # On shared memory what precedes the burst arrives, too; over TCPROS it may not.
        return [sorted(set(range(first, last)) - set(listener.numbers())) for first, listener in zip((0, BEFORE), listeners)]

    def assert_nothing_lost(self, size):
        shared, _ = self.burst(min(200, 2500000 // size), rate=500, queue=1, bytes=size)
        self.assertEqual(shared, [])  # TCPROS loses some where its sockets have not grown yet

    def test_small_ones_and_a_queue_of_one(self):
        self.assert_nothing_lost(1000)

    def test_a_queue_of_one(self):
        self.assert_nothing_lost(20000)

    def test_large_ones_and_a_queue_of_one(self):
        self.assert_nothing_lost(300000)

    def test_more_than_sockets_hold(self):
        count = int(1.3 * most_socket_buffers() / 300000)
        shared, plain = self.burst(count, rate=100, queue=2, bytes=300000)
        self.assertGreater(len(plain), 20)
        self.assertGreater(len(shared), 0)
        self.assertLessEqual(len(shared), len(plain))


if __name__ == "__main__":
    main()
