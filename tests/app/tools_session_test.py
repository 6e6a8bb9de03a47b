"""The operator's tools on a live session. Needs a network namespace with multicast on loopback:
    tests/in_namespace.sh loopback python3 tests/app/tools_session_test.py PROGRAM
"""

import os
import pathlib
import pty
import signal
import subprocess
import tempfile
import time
import unittest

from peers import PROGRAM, Peer, end_all, require_own_network, run

LEASE = 0.5  # s
WIDTH = 80


class Nobody(unittest.TestCase):
    def test_set_says_that_there_is_no_session(self):
        for arguments in (["Pause=true"], ["--list"]):
            with self.subTest(arguments=arguments):
                done = run("set", *arguments)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertIn("no session: no peer was heard; ./run.sh peers", done.stderr)

    def test_spy_says_that_nobody_is_heard(self):
        done = run("spy", "--text", "--interval", 0.5, "--count", 2)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"\Ano peer heard for [01] s \(how to check: ./run.sh peers\)\n"
                                      r"\nno peer heard for 1 s \(how to check: ./run.sh peers\)\n\Z")

    def test_peers_says_what_to_check(self):
        done = run("peers", "--seconds", 1)
        self.assertEqual(done.returncode, 1, done.stderr)
        for text in ("Nobody else was heard in 1 s.", "by lo (127.0.0.1)", "ttl=1", "firewall"):
            self.assertIn(text, done.stdout)


class Probing(unittest.TestCase):
    def test_two_that_run_at_the_same_time_hear_each_other(self):
        with subprocess.Popen([PROGRAM, "peers", "--seconds", "3"], stdout=subprocess.PIPE,
                              text=True) as other:
            done = run("peers", "--seconds", 1.5)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertRegex(done.stdout, r"\(another run on this machine\) +\d+ % +yes, \d+ % +[\d.]+ ms")
            said = other.communicate(timeout=30)[0]
            self.assertEqual(other.returncode, 0, said)

    def test_another_group_is_another_network(self):
        url = "udpm://239.255.76.67:9172?ttl=0"
        with subprocess.Popen([PROGRAM, "peers", "--seconds", "1.5", "--lcm-url", url],
                              stdout=subprocess.DEVNULL) as other:
            self.assertEqual(run("peers", "--seconds", 1).returncode, 1)
            other.wait(timeout=30)


class Session(unittest.TestCase):
    """Three peers that go on until they are killed."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.peers = [Peer(pathlib.Path(folder.name), i, "--NumOfBalls", 60, "--Lease", LEASE,
                          "--require-lcm") for i in (1, 2, 3)]
        cls.addClassCleanup(end_all, cls.peers)

    def setUp(self):
        end = time.monotonic() + 30
        while "active peers 1, 2, 3" not in self.list_of_settings():
            self.assertLess(time.monotonic(), end, "three peers never became active")

    @staticmethod
    def list_of_settings():
        return run("set", "--list").stdout

    def set(self, *settings):
        done = run("set", *settings)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for line in done.stdout.splitlines():
            self.assertTrue(line.endswith("confirmed by peers 1, 2, 3"), line)
        return done.stdout

    def step(self):
        return int(self.list_of_settings().split("step ")[1].split(",")[0])

    def test_settings_hold_for_all_and_are_listed(self):
        self.assertRegex(self.set("Gravity=off", "Elasticity=0.5", "2.Well=repel"),
                         r"\AGravity: on -> off, from step \d+, .*\nElasticity: as configured -> 0.5, .*"
                         r"\n2.Well: as configured -> repel, .*\n\Z")
        time.sleep(1)
        listed = self.list_of_settings()
        for text in (r"  Pause = false", r"  Gravity = off, since step \d+, set by \S+@\S+\n",
                     r"  Elasticity = 0.5, since step \d+", r"  Friction = 0.3, as configured\n",
                     r"  2.Well = repel, since step \d+"):
            self.assertRegex(listed, text)
        table = run("spy", "--text", "--interval", 1.5, "--count", 1).stdout
        self.assertIn("Gravity = off, since step", table)

    def test_a_pause_stands_still_and_ends(self):
        self.set("Pause=true")
        time.sleep(0.5)
        first, second = self.step(), self.step()
        self.assertEqual(first, second)
        self.set("Pause=false")
        time.sleep(0.5)
        self.assertGreater(self.step(), second)

    def test_a_reset_starts_the_world_over(self):
        time.sleep(1)
        before = self.step()
        self.set("Reset=now")
        time.sleep(2)
        listed = self.list_of_settings()
        self.assertTrue(listed.startswith("Session 1-"), listed)
        self.assertLess(self.step(), before + 60 * 2)

    def test_wrong_settings_change_nothing(self):
        for setting, says, status in (
                ("Gravity=down", "Gravity is down; it must be on, off or reversed", 2),
                ("Gravty=off", "Gravty: no such setting; did you mean Gravity? allowed: Pause, ", 2),
                ("9.Well=off", "9.Well: the session has no peer 9; it has 1, 2, 3", 1)):
            with self.subTest(setting=setting):
                done = run("set", "Pause=true", setting)
                self.assertEqual((done.returncode, done.stdout), (status, ""))
                self.assertIn(says, done.stderr)
        self.assertIn("Pause = false", self.list_of_settings())

    def test_a_peer_that_does_not_answer_is_named(self):
        self.peers[2].process.send_signal(signal.SIGSTOP)
        done = run("set", "NetworkRate=60")
        self.peers[2].process.send_signal(signal.SIGCONT)
        # By the end of the setter's patience its lease is over, and it counts no more.
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertIn("confirmed by peers 1, 2", done.stdout)
        self.assertNotIn("confirmed by peers 1, 2, 3", done.stdout)

    def test_the_table_fits_and_shows_all_peers(self):
        table = run("spy", "--text", "--interval", 2.5, "--count", 2)
        self.assertEqual(table.returncode, 0)
        self.assertNotIn("\x1b", table.stdout)
        last = table.stdout.split("\n\n")[-1]
        for line in last.splitlines():
            self.assertLessEqual(len(line), WIDTH)
        for peer in (1, 2, 3):
            self.assertRegex(last, rf"(?m)^   {peer} active ")
        self.assertIn("of 60 balls owned", last)

    def test_on_a_terminal_the_table_is_redrawn_until_an_interrupt(self):
        terminal, its_end = pty.openpty()
        self.addCleanup(os.close, terminal)
        process = subprocess.Popen([PROGRAM, "spy", "--text", "--interval", "0.3"], stdout=its_end)
        os.close(its_end)
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=30), 0)
        said = os.read(terminal, 1 << 20).decode()
        self.assertTrue(said.startswith("\x1b[2J\x1b[H"), said[:100])
        self.assertGreaterEqual(said.count("\x1b[H"), 2)

    def test_peers_notices_those_of_the_session(self):
        done = run("peers", "--seconds", 2)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"peer 2 of a session +\d+ % +not asked")
        self.assertIn("run it on their machines at the same time", done.stdout)


class WrongWords(unittest.TestCase):
    def test_are_refused_before_anything_is_opened(self):
        for arguments, says in (
                (("spy",), "spy: --text is missing"),
                (("spy", "--text", "--interval", "0"), "--interval 0: out of range; allowed: a number "),
                (("spy", "--text", "--count", "0"), "--count 0: out of range; allowed: a whole number"),
                (("peers", "--seconds", "x"), "--seconds x: "),
                (("peers", "--lcm-url", "udpm://10.0.0.1"), "the group is \"10.0.0.1\""),
                (("set",), "set: nothing to set"),
                (("set", "Pause"), "Pause: no value; allowed: KEY=VALUE"),
                (("set", "--list", "Pause=true"), "contradict each other"),
                (("set", "Pause=true", "Pause=false"), "Pause stands twice")):
            with self.subTest(arguments=arguments):
                done = run(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(says, done.stderr)
        done = run("peers", env={"LCM_DEFAULT_URL": "memq://"})
        self.assertEqual(done.returncode, 2)
        self.assertIn("LCM_DEFAULT_URL=memq://: ", done.stderr)


if __name__ == "__main__":
    require_own_network()
    unittest.main(verbosity=2)
