# SPDX-License-Identifier: BSD-3-Clause
"""Where shared memory ends: other machines, other users; and where it does not: a mount namespace."""
import os
import subprocess
import time

from topic_case import TopicCase, main


def must_be_root():
    if os.geteuid() != 0:
        raise AssertionError("this test makes network namespaces and other users' processes: run it as root")


class OtherUser(TopicCase):
    def setUp(self):
        must_be_root()
        super().setUp()
        os.chmod(self.scratch, 0o777)

    def as_nobody(self):
        return ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"]

    def nobodys(self):
        return {"ROS_HOME": f"{self.scratch}/nobody", "ROS_LOG_DIR": f"{self.scratch}/nobody", "HOME": self.scratch}

    def test_subscriber_of_another_user_stays_on_tcpros(self):
        other, own = self.listen(runner=self.as_nobody(), env=self.nobodys()), self.listen()
        self.talk(count=50, queue=200, subscribers=2, shared=1)
        self.assert_got(other, range(50), shared=False)
        self.assert_got(own, range(50), shared=True)

    def test_publisher_of_another_user_stays_on_tcpros(self):
        listener = self.listen()
        talker = self.start_talker(count=50, queue=200, shared=0, runner=self.as_nobody(), env=self.nobodys())
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(listener, range(50), shared=False)

    def test_it_is_decided_so_and_not_tried_again(self):
        """Either side may see it; no warning."""
        config = os.path.join(self.scratch, "rosconsole.config")
        with open(config, "w", encoding="ascii") as text:
            text.write("log4j.logger.ros=INFO\nlog4j.logger.ros.tzc=DEBUG\n")
        for on_either_side in ({"runner": self.as_nobody(), "env": self.nobodys()}, {}), \
                              ({}, {"runner": self.as_nobody(), "env": self.nobodys()}):
            subscribers, publishers = on_either_side
            self.listen(**subscribers)
            talker = self.start_talker(**dict(publishers, count=0, settle=0, env=dict(
                publishers.get("env", {}), ROSCONSOLE_CONFIG_FILE=config, ROSCONSOLE_STDOUT_LINE_BUFFERED="1")))
            self.ros.wait_until(lambda: "another user" in talker.log(), 20, "the decision")
            tries = talker.log().count(", try ")
            time.sleep(1.5)
            self.assertEqual((talker.log().count(", try "), talker.log().count("WARN")), (tries, 0), talker.log())
            self.ros.stop_since(self.before)

    def test_both_of_another_user_share(self):
        listener = self.listen(runner=self.as_nobody(), env=self.nobodys())
        talker = self.start_talker(count=50, queue=200, runner=self.as_nobody(), env=self.nobodys())
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(listener, range(50), shared=True)


class MountNamespace(TopicCase):
    """Like a container with the host's network: other files, other /dev/shm and /tmp."""

    def test_shared_across_mount_namespaces(self):
        must_be_root()
        inside = ["unshare", "--mount", "sh", "-c", 'mount -t tmpfs none /dev/shm && exec "$@"', "sh"]
        listener = self.listen()
        talker = self.start_talker(count=50, queue=200, runner=inside)
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(listener, range(50), shared=True)

    def test_pid_and_ipc_namespaces_too(self):
        must_be_root()
        inside = ["unshare", "--mount", "--pid", "--ipc", "--fork", "--kill-child", "--mount-proc"]
        listener = self.listen()
        talker = self.start_talker(count=50, queue=200, runner=inside)
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(listener, range(50), shared=True)


class OtherMachine(TopicCase):
    """Two network namespaces, each with its own address, joined by a virtual cable."""

    @classmethod
    def setUpClass(cls):
        must_be_root()
        number = os.getpid() % 250
        cls.machine = f"tzc{os.getpid()}"
        cls.here, cls.there = f"10.213.{number}.1", f"10.213.{number}.2"
        for command in (f"ip netns add {cls.machine}",
                        f"ip link add {cls.machine}a type veth peer name {cls.machine}b",
                        f"ip link set {cls.machine}b netns {cls.machine}",
                        f"ip addr add {cls.here}/24 dev {cls.machine}a",
                        f"ip link set {cls.machine}a up",
                        f"ip netns exec {cls.machine} ip addr add {cls.there}/24 dev {cls.machine}b",
                        f"ip netns exec {cls.machine} ip link set {cls.machine}b up",
                        f"ip netns exec {cls.machine} ip link set lo up"):
            subprocess.run(command.split(), check=True)
            if command.startswith("ip netns add"):
                cls.addClassCleanup(subprocess.run, ["ip", "netns", "del", cls.machine], check=False)
        cls.session_env = {"ROS_IP": cls.here}
        super().setUpClass()
        cls.master_uri = f"http://{cls.here}:{cls.ros.port}"

    def on_other_machine(self):
        return {"runner": ["ip", "netns", "exec", self.machine],
                "env": {"ROS_IP": self.there, "ROS_MASTER_URI": self.master_uri}}

    def on_this_machine(self):
        return {"env": {"ROS_IP": self.here, "ROS_MASTER_URI": self.master_uri}}

    def test_remote_subscriber_falls_back_to_tcpros_by_itself(self):
        remote = self.listen(**self.on_other_machine())
        local = self.listen(**self.on_this_machine())
        self.talk(count=50, queue=200, subscribers=2, shared=1, **self.on_this_machine())
        self.assert_got(remote, range(50), shared=False)
        self.assert_got(local, range(50), shared=True)
        self.assert_seq_as_tcpros(remote)

    def test_remote_publisher(self):
        local = self.listen(**self.on_this_machine())
        remote = self.listen(**self.on_other_machine())
        talker = self.start_talker(count=50, queue=200, subscribers=2, shared=1, **self.on_other_machine())
        self.assertEqual(talker.wait(30), 0, talker.tail())
        self.assert_got(local, range(50), shared=False)
        self.assert_got(remote, range(50), shared=True)


if __name__ == "__main__":
    main()
