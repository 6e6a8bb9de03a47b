"""Peers on hosts of their own, recorded and judged: what all scenarios share.

    tests/in_namespace.sh lan python3 tests/lan/<scenario>_test.py PROGRAM LCM_GEN TYPES_FOLDER
"""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent / "app"))

from peers import CONFIG, Peer, end_all, largest_difference  # noqa: E402  takes PROGRAM

import invariants  # noqa: E402
import messages  # noqa: E402
import network  # noqa: E402
import recorder  # noqa: E402

LCM_GEN, TYPES_FOLDER = sys.argv.pop(1), sys.argv.pop(1)
SKIPPED = 77  # CTest's

ACTIVE = 2  # heartbeat_t's phase


class Helper:
    """A program of this folder that runs beside the peers."""

    def __init__(self, name, *arguments):
        self.process = subprocess.Popen([sys.executable, "-B", FOLDER / name,
                                         *map(str, arguments)], stdout=subprocess.PIPE, text=True)
        if self.process.stdout.readline() != "ready\n":
            raise OSError(f"{name} has not started")

    def end(self):
        """What it said last."""
        if self.process.poll() is None:
            self.process.terminate()
        said, _ = self.process.communicate(timeout=30)
        return said


class Scenario(unittest.TestCase):
    """Four hosts on a bridge, unless a class says otherwise."""

    HOSTS = (1, 2, 3, 4)
    LEASE = 1.0  # s
    BALLS = 200
    WORLD = ()  # more options of every peer

    @classmethod
    def setUpClass(cls):
        cls.types = messages.Types(LCM_GEN, TYPES_FOLDER)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.lan = network.Lan(self.HOSTS)
        self.addCleanup(self.lan.close)
        self.plug_in()
        self.recording = self.folder / "recording"
        self.recorder = Helper("recorder.py", self.recording, *self.HOSTS)
        self.addCleanup(self.recorder.end)

    def plug_in(self):
        self.lan.bridge()

    def use_filter(self):
        try:
            self.lan.filter()
        except OSError as error:
            self.skipTest(f"this machine cannot drop packets with nftables: {error}")

    def start(self, host, *arguments):
        peer = Peer(self.folder, host, "--config", CONFIG / "template.txt", "--NumOfBalls",
                    self.BALLS, "--Lease", self.LEASE, "--lcm-url", network.URL, "--require-lcm",
                    *self.WORLD, *arguments, within=network.within(host))
        self.addCleanup(end_all, [peer])
        return peer

    def await_active(self, hosts, timeout=30):
        """Until a heartbeat of each of these hosts says that its peer is active. Returns the time
        of the last one's first (s, monotonic)."""
        until = time.monotonic() + timeout
        while time.monotonic() < until:
            since = {}
            for datagram in recorder.stored(self.recording):
                if b"WELLS_HEARTBEAT\0" not in datagram.data[:32]:
                    continue
                message = self.types.decode(datagram)
                if message.content.phase == ACTIVE:
                    since.setdefault(message.host, message.time)
            if set(hosts) <= since.keys():
                return max(since[host] for host in hosts)
            time.sleep(0.1)
        self.fail(f"hosts {sorted(set(hosts) - since.keys())} have not become active")

    def end(self, peers, timeout=60):
        """Waits for the peers; they must have ended well. Then nothing is recorded any more."""
        for peer in peers:
            status, said = peer.wait(timeout)
            self.assertEqual(status, 0, said)
        self.recorder.end()

    def check(self):
        """All of the recording, and in what it breaks the invariants."""
        checked = invariants.Invariants()
        recorded = []
        for message in self.types.read(self.recording):
            checked.see(message)
            recorded.append(message)
        self.assertGreater(checked.seen["ball_states_t"], 0)
        return recorded, checked.finish()

    def judge(self):
        """All of the recording, which breaks none of the invariants."""
        recorded, violations = self.check()
        self.assertEqual(violations, [])
        return recorded

    def assert_agreement(self, peers):
        """Each ball has one owner, the same for all; all views are equal at the same step."""
        reports = [peer.report() for peer in peers]
        living = sorted(peer.peer_id for peer in peers)
        for report in reports:
            self.assertTrue(report["complete"], report)
            self.assertEqual(report["peers"], living)
            self.assertEqual(report["owners"], reports[0]["owners"])
            self.assertEqual(report["balls_owned"], report["owners"].get(str(report["peer"]), 0))
            self.assertEqual(report["steps"], reports[0]["steps"])
            self.assertEqual(report["generation"], reports[0]["generation"])
            self.assertEqual(report["escaped"], 0)
            self.assertEqual(report["quarantined"], [])
        self.assertEqual(sum(reports[0]["owners"].values()), self.BALLS)
        self.assertLessEqual(set(map(int, reports[0]["owners"])), set(living))
        for peer in peers[1:]:
            self.assertLessEqual(largest_difference(peers[0].positions(), peer.positions()), 1e-9)


def main():
    """Runs the scenarios of a file. Ends with SKIPPED when one could not run and none failed."""
    network.require_own_namespaces()
    program = unittest.main(module="__main__", verbosity=2, exit=False)
    if not program.result.wasSuccessful():
        sys.exit(1)
    sys.exit(SKIPPED if program.result.skipped else 0)
