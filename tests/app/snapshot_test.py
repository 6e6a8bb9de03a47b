"""Snapshots as a user meets them: saved, restored, damaged.
    tests/in_namespace.sh isolated python3 tests/app/snapshot_test.py PROGRAM
"""

import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from peers import CONFIG, PROGRAM, require_own_network, run

# Its well goes round, and 300 balls collapse: what the engine remembers counts.
MOVING = ("--config", CONFIG / "repeller.txt", "--WellPath", "circle,20,15")


def limit_file_size():
    """Files of this process end after 1000 bytes: as on a full disk, writing fails."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))


class Snapshots(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.snapshot = self.folder / "world.snap"

    def solo(self, *arguments, **options):
        return run("peer", "--solo", "--quiet", *arguments, **options)

    def done(self, *arguments, **options):
        done = self.solo(*arguments, **options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def contents(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir()}

    def assert_refused(self, says, *arguments, status=2, **options):
        """Nothing in the folder changes, and the message says why."""
        before = self.contents()
        done = self.solo(*arguments, **options)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertIn(says, done.stderr)
        self.assertEqual(self.contents(), before)

    def assert_goes_on(self, first, rest, *world, options=()):
        """A run of first + rest steps, and the same in two halves."""
        whole, parts = self.folder / "whole.csv", self.folder / "parts.csv"
        whole_snapshot = self.folder / "whole.snap"
        self.done(*world, *options, "--steps", first + rest, "--state-out", whole, "--save-snapshot",
                  whole_snapshot)
        self.done(*world, *options, "--steps", first, "--save-snapshot", self.snapshot)
        # In another folder and without the config: the snapshot is enough.
        self.done("--restore", self.snapshot, "--steps", rest, "--state-out", parts,
                  "--save-snapshot", self.snapshot, cwd="/")
        self.assertEqual(whole.read_text(), parts.read_text())
        self.assertEqual(whole_snapshot.read_bytes(), self.snapshot.read_bytes())

    def test_every_contact_method_goes_on(self):
        for method in ("substep", "exact", "auto"):
            with self.subTest(method=method):
                self.assert_goes_on(130, 110, *MOVING, "--ContactMethod", method)

    def test_the_reference_engines_go_on(self):
        for engine in ("euler", "improved-euler", "rk", "heun", "rk4"):
            with self.subTest(engine=engine):
                self.assert_goes_on(40, 60, *MOVING, "--TimeScale", "1.5", "--engine",
                                    f"reference-{engine}")

    def test_a_well_goes_on_along_its_file(self):
        path = self.folder / "path.csv"
        path.write_text("t,x,y,z,strength\n0,10,1,0,100\n2,-10,1,0,50\n")
        relative = os.path.relpath(path)
        self.assert_goes_on(50, 130, "--NumOfBalls", 60, "--WellPath", relative)

    def test_steps_and_duration_count_from_there(self):
        for more in (("--steps", 60), ("--duration", 1)):
            self.done("--steps", 30, "--save-snapshot", self.snapshot)
            self.assertIn("step 90, 1.50 s of simulated time",
                          run("peer", "--solo", "--restore", self.snapshot, *more).stdout)

    def test_keys_may_be_given_again_but_not_changed(self):
        self.done(*MOVING, "--steps", 10, "--save-snapshot", self.snapshot)
        restore = ("--restore", self.snapshot, "--steps", 1)
        self.done(*MOVING, *restore)
        self.done(*restore, "--GraphicsRate", 10, "--engine", "ours")
        for key, value, saved in (("Gravity", "0", "-9.81"), ("NumOfBalls", "7", "300"),
                                  ("PeerID", "2", "1"), ("WellPath", "still", "circle,20,15"),
                                  ("Well", "1,2,3,4,5", "0,"), ("BallsFile", "b.csv", "no BallsFile")):
            with self.subTest(key=key):
                self.assert_refused(f"--{key} {value}: contradicts the snapshot; allowed with "
                                    f"--restore: {saved}", *restore, f"--{key}", value)
        config = self.folder / "world.txt"
        config.write_text("// other\nElasticity=0.125\n")
        self.assert_refused(f"{config}:2: Elasticity=0.125: contradicts", *restore, "--config", config)
        self.assert_refused("--engine reference-rk: contradicts the snapshot; allowed with "
                            "--restore: ours", *restore, "--engine", "reference-rk")

    def test_damaged_files_are_refused(self):
        self.done("--steps", 5, "--save-snapshot", self.snapshot)
        whole = self.snapshot.read_bytes()
        state = self.folder / "state.csv"
        altered = bytearray(whole)
        altered[len(whole) // 2] ^= 4
        newer = whole[:8] + b"\x04" + whole[9:]
        for content, says in (
                (whole[:-1], f"cut: has {len(whole) - 1} of {len(whole)} bytes"),
                (whole[:5], "cut: has 5 bytes"), (b"", "cut: has 0 bytes"),
                (altered, "altered: its checksum is"), (whole + b"x", "altered: has"),
                (newer, "is of format version 4; this program reads 3"),
                (b"id,x,y,z\n", "not a snapshot of a world")):
            with self.subTest(says=says):
                self.snapshot.write_bytes(content)
                self.assert_refused(f"{self.snapshot}: {says}", "--restore", self.snapshot, "--steps",
                                    1, "--state-out", state, "--save-snapshot", self.snapshot)
        self.snapshot.unlink()
        self.assert_refused("cannot be read: No such file", "--restore", self.snapshot)
        self.assert_refused("is no regular file", "--restore", self.folder)

    def test_where_a_snapshot_makes_no_sense(self):
        save = ("--save-snapshot", self.snapshot, "--steps", 1)
        self.assert_refused("--save-snapshot: engine bullet keeps what cannot be saved; allowed: ",
                            *save, "--engine", "bullet")
        self.assert_refused("--save-snapshot-every: no file is named", "--save-snapshot-every", 1)
        self.assert_refused("--save-snapshot /proc/absent/a: cannot be written", "--save-snapshot",
                            "/proc/absent/a")
        self.done(*save)
        for option in ("--save-snapshot", "--restore"):
            done = run("peer", option, self.snapshot, "--steps", 1)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"{option}: a session has no world of one peer", done.stderr)

    def test_a_failed_write_leaves_the_old_file(self):
        self.done("--steps", 5, "--save-snapshot", self.snapshot)
        for every in ((), ("--save-snapshot-every", 0.1)):
            with self.subTest(every=every):
                self.assert_refused(f"{self.snapshot}: cannot be written: File too large", "--steps",
                                    60, "--save-snapshot", self.snapshot, *every, status=1,
                                    preexec_fn=limit_file_size)
        self.done("--restore", self.snapshot, "--steps", 1)

    def test_a_killed_run_goes_on_from_its_last_save(self):
        whole, parts = self.folder / "whole.csv", self.folder / "parts.csv"
        process = subprocess.Popen([PROGRAM, "peer", "--solo", "--quiet", *map(str, MOVING),
                                    "--save-snapshot", self.snapshot, "--save-snapshot-every", "0.01"])
        deadline = time.monotonic() + 60
        while not self.snapshot.exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        time.sleep(0.3)  # in the middle of something
        process.kill()
        process.wait()
        said = run("peer", "--solo", "--restore", self.snapshot, "--steps", 30, "--state-out",
                   parts).stdout
        steps = int(said.split("step ")[1].split(",")[0])
        self.assertGreater(steps, 30)
        self.done(*MOVING, "--steps", steps, "--state-out", whole)
        self.assertEqual(whole.read_text(), parts.read_text())

    def test_an_interrupt_saves(self):
        process = subprocess.Popen([PROGRAM, "peer", "--solo", "--quiet", "--SimulationRate", "60",
                                    "--save-snapshot", self.snapshot])
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=30), 0)
        self.done("--restore", self.snapshot, "--steps", 1)


if __name__ == "__main__":
    require_own_network()
    unittest.main(verbosity=2)
