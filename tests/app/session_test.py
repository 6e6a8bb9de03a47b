"""Real peers share a world over LCM multicast. Needs a network namespace with multicast on loopback:
    tests/in_namespace.sh loopback python3 tests/app/session_test.py PROGRAM
"""

import pathlib
import signal
import tempfile
import time
import unittest

from peers import CONFIG, Peer, end_all, largest_difference, require_own_network, run

BALLS = 200
LEASE = 2.0  # s
# Each well moves, on a circle and with a period of its own.
PATHS = {1: "circle,20,40", 2: "circle,14,-30", 3: "circle,26,60"}


class SharedWorld(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *arguments):
        peers = [Peer(self.folder, i, "--config", CONFIG / "template.txt", "--NumOfBalls", BALLS,
                      "--WellPath", path, "--Lease", LEASE, "--require-lcm", *arguments)
                 for i, path in PATHS.items()]
        self.addCleanup(end_all, peers)
        return peers

    def assert_ended_well(self, peers):
        for peer in peers:
            status, said = peer.wait(timeout=90)
            self.assertEqual(status, 0, said)

    def assert_agreement(self, peers):
        """Each ball has one owner, the same for all; all views are equal at the same step."""
        reports = [peer.report() for peer in peers]
        for report in reports:
            self.assertTrue(report["complete"], report)
            self.assertEqual(report["owners"], reports[0]["owners"])
            self.assertEqual(report["balls_owned"], report["owners"].get(str(report["peer"]), 0))
            self.assertEqual(report["steps"], reports[0]["steps"])
            self.assertEqual(report["escaped"], 0)
        self.assertEqual(sum(reports[0]["owners"].values()), BALLS)
        self.assertEqual(sum(report["balls_owned"] for report in reports), BALLS)
        for peer in peers[1:]:
            self.assertLessEqual(largest_difference(peers[0].positions(), peer.positions()), 1e-9)

    def test_balls_change_hands_and_views_agree(self):
        peers = self.start("--duration", 12)
        self.assert_ended_well(peers)
        self.assert_agreement(peers)
        reports = [peer.report() for peer in peers]
        self.assertGreaterEqual(sum(report["handovers"] for report in reports), 20)
        for report in reports:
            self.assertGreaterEqual(report["balls_owned_max"], 1)
            self.assertTrue(report["transport"].startswith("lcm udpm://"), report["transport"])
            self.assertEqual(report["peers"], [1, 2, 3])

    def test_a_killed_peers_balls_are_owned_again_within_two_leases(self):
        peers = self.start()
        # Two leases of listening, one second of margin for starting, and five of the shared world.
        time.sleep(2 * LEASE + 6)
        peers[2].process.send_signal(signal.SIGKILL)
        time.sleep(2 * LEASE)
        for peer in peers[:2]:
            peer.process.send_signal(signal.SIGINT)
        self.assert_ended_well(peers[:2])
        reports = [peer.report() for peer in peers[:2]]
        for report in reports:
            self.assertNotIn("3", report["owners"], "owned by nobody who lives")
            self.assertEqual(sum(report["owners"].values()), BALLS)
        self.assertGreaterEqual(sum(report["adoptions"] for report in reports), 1)

    def test_survivors_agree_after_an_adoption(self):
        peers = self.start("--duration", 14)
        time.sleep(2 * LEASE + 6)
        peers[2].process.send_signal(signal.SIGKILL)
        self.assert_ended_well(peers[:2])
        self.assert_agreement(peers[:2])
        reports = [peer.report() for peer in peers[:2]]
        self.assertGreaterEqual(sum(report["adoptions"] for report in reports), 1)
        self.assertEqual(reports[0]["peers"], [1, 2])


class Identity(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, peer_id, *arguments):
        peer = Peer(self.folder, peer_id, "--Lease", 0.5, "--require-lcm", *arguments)
        self.addCleanup(end_all, [peer])
        return peer

    def test_an_id_that_is_taken_ends_the_one_who_insists_on_it(self):
        first = self.start(1, "--duration", 8)
        time.sleep(2)
        second = run("peer", "--peer-id", 1, "--Lease", 0.5, "--require-lcm", "--duration", 8)
        self.assertEqual(second.returncode, 2, second.stderr)
        self.assertIn("1", second.stderr)
        self.assertEqual(first.wait(timeout=60)[0], 0)

    def test_peers_of_one_template_get_ids_of_their_own(self):
        first = self.start(1, "--duration", 8)
        time.sleep(2)
        report = self.folder / "second.json"
        config = self.folder / "template.txt"
        config.write_text("PeerID=1\nLease=0.5\n")
        second = run("peer", "--config", config, "--require-lcm", "--duration", 8, "--report", report)
        self.assertEqual(second.returncode, 0, second.stderr)
        self.assertIn('"peer": 2,', report.read_text())
        self.assertEqual(first.wait(timeout=60)[0], 0)

    def test_another_world_is_refused_with_the_key_that_differs(self):
        first = self.start(1, "--duration", 8)
        time.sleep(2)
        second = run("peer", "--peer-id", 2, "--Lease", 0.5, "--require-lcm", "--duration", 8,
                     "--BallRadius", 0.6)
        self.assertEqual(second.returncode, 2, second.stderr)
        self.assertIn("BallRadius", second.stderr)
        self.assertEqual(first.wait(timeout=60)[0], 0)


class Demonstration(unittest.TestCase):
    def test_two_peers_draw_and_agree(self):
        with tempfile.TemporaryDirectory() as folder:
            demo = run("demo", "--config", CONFIG / "template.txt", "--out", folder, "--duration", 3,
                       "--require-lcm")
            self.assertEqual(demo.returncode, 0, demo.stderr)
            self.assertIn("2 peers shared 25 balls for 3.00 s", demo.stdout)
            self.assertRegex(demo.stdout, r"views at step 180: 0 m")
            for i in (1, 2):
                video = pathlib.Path(folder) / f"peer-{i}.mp4"
                picture = pathlib.Path(folder) / f"peer-{i}.png"
                self.assertEqual(video.read_bytes()[4:8], b"ftyp")
                self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    require_own_network()
    unittest.main(verbosity=2)
