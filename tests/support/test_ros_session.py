# SPDX-License-Identifier: BSD-3-Clause
"""What a session's processes find in their environment."""
import os
import tempfile
import unittest

from ros_session import RosSession


class Environment(unittest.TestCase):
    def session(self, **env):
        return RosSession(tempfile.gettempdir(), env)

    def test_the_sessions_master_wins_over_the_one_that_a_workspace_names(self):
        session = self.session(ROS_MASTER_URI="http://localhost:11311", ROS_HOME="/nowhere", ROS_LOG_DIR="/nowhere")
        self.assertEqual(session.env["ROS_MASTER_URI"], session.uri)
        self.assertEqual(session.env["ROS_HOME"], tempfile.gettempdir())
        self.assertTrue(session.env["ROS_LOG_DIR"].startswith(tempfile.gettempdir()))

    def test_what_else_is_asked_for_is_given(self):
        session = self.session(ROS_IP="127.0.0.2", TZC_DISABLE="1")
        self.assertEqual((session.env["ROS_IP"], session.env["TZC_DISABLE"]), ("127.0.0.2", "1"))

    def test_a_host_name_of_the_machine_does_not_get_in(self):
        os.environ["ROS_HOSTNAME"] = "elsewhere"
        try:
            self.assertNotIn("ROS_HOSTNAME", self.session().env)
        finally:
            del os.environ["ROS_HOSTNAME"]


if __name__ == "__main__":
    unittest.main()
