"""The program as a user meets it, on a machine where multicast does not pass:
    tests/in_namespace.sh isolated python3 tests/app/program_test.py PROGRAM
"""

import json
import os
import pathlib
import pty
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from peers import CONFIG, PROGRAM, require_own_network, run


def limit_file_size():
    """Files of this process end after 1000 bytes: as on a full disk, writing fails."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def solo(self, *arguments):
        return run("peer", "--solo", "--quiet", *arguments)

    def test_solo_writes_state_and_report(self):
        state, report = self.folder / "state.csv", self.folder / "report.json"
        done = self.solo("--config", CONFIG / "template.txt", "--steps", 60, "--state-out", state,
                         "--report", report)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(state.read_text().splitlines()), 26)
        values = json.loads(report.read_text())
        for name in ("steps sim_time_s wall_time_s energy_start_J energy_end_J max_overlap_m escaped "
                     "state_hash transport balls_owned handovers view_difference_max_m messages_sent "
                     "messages_received messages_dropped rates").split():
            self.assertIn(name, values)
        self.assertEqual((values["steps"], values["escaped"], values["transport"]), (60, 0, "none"))
        self.assertEqual(values["messages_sent"], 0)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["report.json", "state.csv"], "no temporary file is left")

    def test_a_run_goes_on_from_its_state_file(self):
        # The circle of billiard balls has no memory but its state: two halves are the whole.
        config = self.folder / "world.txt"
        whole, half, rest = (self.folder / name for name in ("whole.csv", "half.csv", "rest.csv"))
        config.write_text("NumOfBalls=40\nGravity=0\nElasticity=1\nFriction=0\nWell=0,20,0,500,5\n"
                          "WellStrength=0\n")
        for steps, out, more in ((240, whole, ()), (120, half, ()),
                                 (120, rest, ("--BallsFile", half))):
            done = self.solo("--config", config, "--steps", steps, "--state-out", out, *more)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(whole.read_text(), rest.read_text())

    def test_every_engine_runs_the_template(self):
        for engine in ("ours", "reference-euler", "reference-improved-euler", "reference-rk",
                       "reference-heun", "reference-rk4", "bullet"):
            with self.subTest(engine=engine):
                report = self.folder / "report.json"
                done = self.solo("--config", CONFIG / "template.txt", "--steps", 120, "--engine",
                                 engine, "--report", report)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(json.loads(report.read_text())["engine"], engine)

    def test_the_lines_of_target_error_make_the_same_run(self):
        config, report = self.folder / "world.txt", self.folder / "report.json"
        world = ("NumOfBalls=3\nSurfaceRadius=10\nElasticity=1\nFriction=0\nWellStrength=30\n"
                 "WellPosition=1,3,0\nWellPath=circle,4,20\n")
        config.write_text(world)
        done = run("peer", "--solo", "--config", config, "--duration", 1, "--target-error", "1e-6",
                   "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        chosen = json.loads(report.read_text())
        self.assertAlmostEqual(chosen["sim_time_s"], 1, places=9)
        self.assertEqual(chosen["target_error"]["asked_m"], 1e-6)
        self.assertLessEqual(chosen["target_error"]["trial_error_m"], 1e-6)
        lines = done.stdout.split("as lines of a config:\n")[1].splitlines()[:4]
        self.assertEqual([line.split("=")[0] for line in lines],
                         ["Dt", "Integrator", "ContactMethod", "Substeps"])
        self.assertEqual(float(lines[0].split("=")[1]), chosen["dt"])
        config.write_text(world + "\n".join(lines) + "\n")
        done = self.solo("--config", config, "--duration", 1, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        again = json.loads(report.read_text())
        self.assertEqual(again["state_hash"], chosen["state_hash"])
        self.assertNotIn("target_error", again)

    def test_frames_are_due_in_simulated_time(self):
        frames = self.folder / "frames"
        done = self.solo("--steps", 60, "--GraphicsRate", 10, "--frames", frames, "--ScreenWidth", 160,
                         "--ScreenHeight", 120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(path.name for path in frames.iterdir()),
                         [f"frame_{k:06}.png" for k in range(11)])

    def test_bad_input_starts_nothing(self):
        state = self.folder / "state.csv"
        bad = self.folder / "bad.txt"
        bad.write_text("// look\nElasticity=1.5\n")
        balls = self.folder / "balls.csv"
        balls.write_text("id,x,y,z,vx,vy,vz,wx,wy,wz,radius,mass\n0,1,2,3,0,0,0,0,0,0,-1,1\n")
        path = self.folder / "path.csv"
        path.write_text("t,x,y,z,strength\n")
        for arguments, says in (
                (("--config", bad), f"{bad}:2: Elasticity=1.5: out of range; allowed: "),
                (("--BallsFile", balls), f"{balls}:2: radius=-1: out of range; allowed: "),
                (("--WellPath", path), f"{path}: no keyframe; allowed: "),
                (("--BallRadius", "50"), "BallRadius=50: "),
                (("--engine", "none"), "--engine none: no such engine; allowed: "),
                (("--NoSuchKey", "1"), "--NoSuchKey: no such option; allowed: ")):
            with self.subTest(arguments=arguments):
                done = self.solo("--steps", 1, "--state-out", state, *arguments)
                self.assertEqual(done.returncode, 2)
                self.assertIn(says, done.stderr)
                self.assertFalse(state.exists())

    def test_a_video_needs_ffmpeg(self):
        done = run("peer", "--solo", "--steps", 1, "--video", self.folder / "a.mp4",
                   env={"PATH": str(self.folder)})
        self.assertEqual(done.returncode, 1)
        self.assertIn("ffmpeg", done.stderr)

    def test_an_interrupt_ends_cleanly(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                state, video = self.folder / "state.csv", self.folder / "video.mp4"
                process = subprocess.Popen([PROGRAM, "peer", "--solo", "--state-out", state, "--video",
                                            video, "--SimulationRate", "60"])
                time.sleep(1.5)
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=30), 0)
                self.assertEqual(len(state.read_text().splitlines()), 26)
                self.assertIn(b"moov", video.read_bytes(), "the video is complete")
                state.unlink()

    def test_where_multicast_does_not_pass_a_peer_stays_alone(self):
        report = self.folder / "report.json"
        done = run("peer", "--duration", 1, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("ip route add 224.0.0.0/4", done.stderr)
        self.assertEqual(json.loads(report.read_text())["transport"], "memory")
        refused = run("peer", "--duration", 1, "--require-lcm")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("--require-lcm: ", refused.stderr)

    def test_where_multicast_does_not_pass_the_demonstration_has_one_peer(self):
        demo = run("demo", "--config", CONFIG / "template.txt", "--out", self.folder / "out",
                   "--duration", 1)
        self.assertEqual(demo.returncode, 0, demo.stderr)
        self.assertIn("ip route add 224.0.0.0/4", demo.stdout)
        self.assertIn("One peer, alone, shared 25 balls for 1.00 s of simulated time by memory",
                      demo.stdout)
        refused = run("demo", "--config", CONFIG / "template.txt", "--out", self.folder / "out",
                      "--duration", 1, "--require-lcm")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("--require-lcm", refused.stderr)

    def test_a_folder_that_cannot_be_made_is_refused(self):
        for arguments in (("demo", "--out", "/proc/absent"),
                          ("peer", "--solo", "--steps", 1, "--frames", "/proc/absent/frames"),
                          ("peer", "--solo", "--steps", 1, "--report", "/proc/absent/report.json")):
            with self.subTest(arguments=arguments):
                done = run(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, r"--\w+ /proc/absent.*; allowed: ")

    def test_a_full_disk_is_a_failure(self):
        for option, name in (("--state-out", "a.csv"), ("--video", "a.mp4"), ("--last-frame", "a.png")):
            with self.subTest(option=option):
                done = subprocess.run(
                    [PROGRAM, "peer", "--solo", "--quiet", "--steps", "60", option, self.folder / name],
                    capture_output=True, text=True, timeout=60, preexec_fn=limit_file_size)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(name, done.stderr)

    def test_notices_and_progress_share_the_terminal(self):
        terminal, its_end = pty.openpty()
        self.addCleanup(os.close, terminal)
        done = subprocess.run([PROGRAM, "peer", "--duration", "0.1"], stderr=its_end,
                              stdout=subprocess.DEVNULL, timeout=60)
        os.close(its_end)
        self.assertEqual(done.returncode, 0)
        said = os.read(terminal, 65536).decode()
        self.assertIn("\r\x1b[Kpeer 1: heard nobody and founded a session\r\n", said)
        self.assertTrue(said.endswith("\r\x1b[K"), said)

    def test_help_names_every_option_with_unit_and_default(self):
        text = " ".join(run("peer", "--help").stdout.split())  # without line breaks
        for words in ("--SurfaceRadius VALUE", "above 0 to 1e6, in m. Default: 40 --",
                      "--PeerID,--peer-id VALUE", "--state-out FILE", "bullet. Default: ours --"):
            self.assertIn(words, text)
        self.assertEqual(run("no-such-command").returncode, 2)
        self.assertEqual(run().stderr, "gravity-wells: no command; allowed: peer, demo, bench, spy, "
                                       "peers, set, keys, help\n")

    def test_where_multicast_does_not_pass_an_operators_tool_says_how_to_let_it(self):
        for arguments in (("spy", "--text"), ("peers",), ("set", "--list"), ("set", "Pause=true")):
            with self.subTest(arguments=arguments):
                done = run(*arguments)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertIn("sudo ip route add 224.0.0.0/4 dev <interface>", done.stderr)


if __name__ == "__main__":
    require_own_network()
    unittest.main(verbosity=2)
