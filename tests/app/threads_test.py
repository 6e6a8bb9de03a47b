"""The threads of a real peer, as the system shows them. Needs a network namespace with multicast on
loopback:
    tests/in_namespace.sh loopback python3 tests/app/threads_test.py PROGRAM
"""

import os
import pathlib
import tempfile
import time
import unittest

from peers import CONFIG, Peer, end_all, require_own_network, run


def threads_of(pid):
    """Name -> where it may run, as the kernel lists it."""
    found = {}
    for task in pathlib.Path(f"/proc/{pid}/task").iterdir():
        try:
            name = (task / "comm").read_text().strip()
            status = (task / "status").read_text()
        except (FileNotFoundError, ProcessLookupError):
            continue  # it has ended meanwhile
        found[name] = status.split("Cpus_allowed_list:")[1].split()[0]
    return found


class Threads(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_peer(self, *arguments):
        """Report of a short session of one, and its threads meanwhile."""
        peer = Peer(self.folder, 1, "--config", CONFIG / "template.txt", "--NumOfBalls", 2500,
                    "--Lease", 0.5, "--require-lcm", "--duration", 1, "--last-frame",
                    self.folder / "last.png", "--ScreenWidth", 64, "--ScreenHeight", 64, *arguments)
        self.addCleanup(end_all, [peer])
        threads = {}
        while peer.process.poll() is None:
            if pathlib.Path(f"/proc/{peer.process.pid}").exists():
                threads.update(threads_of(peer.process.pid))
            time.sleep(0.02)
        status, said = peer.wait(timeout=60)
        self.assertEqual(status, 0, said)
        return peer.report(), threads

    def test_are_named_and_kept_where_the_keys_say(self):
        cores = sorted(os.sched_getaffinity(0))
        first, last = str(cores[0]), str(cores[-1])
        report, threads = self.run_peer("--Threads", 2, "--SimulationCores", last,
                                        "--GraphicsCores", first, "--NetworkCores", last)
        for name, where in (("simulation", last), ("simulation 2", last), ("graphics", first),
                            ("network in", last), ("network out", last)):
            self.assertEqual(threads.get(name), where, (name, threads))
        self.assertEqual(report["threads"], 2)
        self.assertEqual(report["cores"], {"simulation": last, "graphics": first, "network": last,
                                           "why": "as the keys say"})

    def test_run_anywhere_when_that_is_asked_for(self):
        everywhere = threads_of(os.getpid())
        report, threads = self.run_peer("--Threads", 1, "--SimulationCores", "any")
        self.assertNotIn("simulation 2", threads)
        for name in ("simulation", "graphics", "network in", "network out"):
            self.assertIn(threads.get(name), everywhere.values(), (name, threads))
        self.assertEqual(report["threads"], 1)
        self.assertEqual(report["cores"], {"simulation": "any", "graphics": "any",
                                           "network": "any", "why": "as the keys say"})

    def test_a_core_that_is_not_there_starts_nothing(self):
        done = run("peer", "--solo", "--steps", 1, "--SimulationCores", "1023")
        self.assertEqual(done.returncode, 2)
        self.assertIn("SimulationCores=1023: this machine has no core 1023; allowed: ", done.stderr)

    def test_nor_does_one_that_the_process_may_not_use(self):
        cores = sorted(os.sched_getaffinity(0))
        if len(cores) < 2:
            self.skipTest("there is one core only")
        self.addCleanup(os.sched_setaffinity, 0, cores)
        os.sched_setaffinity(0, cores[:1])
        done = run("peer", "--solo", "--steps", 1, "--GraphicsCores", cores[1])
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"GraphicsCores={cores[1]}: this process may not run on core {cores[1]}",
                      done.stderr)


if __name__ == "__main__":
    require_own_network()
    unittest.main(argv=[__file__])
