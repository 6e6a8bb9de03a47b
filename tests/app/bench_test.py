"""The benchmark's rows, and the same bits in each run:
    python3 tests/app/bench_test.py PROGRAM
"""

import csv
import pathlib
import tempfile
import unittest

from peers import run

HEADER = ("scene,engine,integrator,contacts,balls,dt,steps,threads,ms_per_step,ms_per_step_last100,"
          "max_overlap_m,ball_overlap_m,ground_overlap_m,wall_overlap_m,energy_start_J,energy_end_J,"
          "kinetic_start_J,kinetic_end_J,escaped,settled_s,"
          "moved_m,kinetic_rise_J,asleep,exact_share,substep_share,impacts,handed_over,direct_contacts,unsolved_islands,contacts_J,friction_J,drag_J,wells_J,push_out_J,flight_J,memory_MiB,"
          "state_hash,commit,compiler,flags,cpu")
SOURCES = ("contacts_J", "friction_J", "drag_J", "wells_J", "push_out_J", "flight_J")
ENGINES = ("ours", "reference-euler", "reference-improved-euler", "reference-rk", "bullet")


class Bench(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.csv = pathlib.Path(folder.name) / "rows.csv"

    def rows(self, *arguments):
        done = run("bench", "--csv", self.csv, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
        with open(self.csv, newline="") as file:
            return list(csv.DictReader(file))

    def test_every_scene_runs_with_every_engine(self):
        scenes = [line.split()[0] for line in run("bench", "--list").stdout.splitlines()]
        self.assertGreaterEqual(len(scenes), 9)
        count = 0
        for scene in scenes:
            balls = ("--balls", 50) if scene in ("T1", "T2", "T3", "flat-gas", "template") else ()
            for engine in ENGINES:
                with self.subTest(scene=scene, engine=engine):
                    rows = self.rows("--scene", scene, *balls, "--steps", 20, "--engine", engine)
                    count += 1
                    self.assertEqual(len(rows), count, "one row is appended")
                    self.assertEqual((rows[-1]["scene"], rows[-1]["engine"]), (scene, engine))
                    self.assertEqual(rows[-1]["steps"], "20")
                    # The published integrators press 1 kg under 1000 t through the ground.
                    if not (scene.startswith("heavy-") and engine.startswith("reference")):
                        self.assertEqual(rows[-1]["escaped"], "0")
        self.assertEqual(self.csv.read_text().splitlines()[0], HEADER)

    def test_heaps_have_the_same_bits_in_each_run_and_for_any_number_of_threads(self):
        for threads in (1, 1, 2, 4):
            rows = self.rows("--scene", "T1", "--balls", 10000, "--steps", 300, "--engine", "ours",
                             "--no-books", "--threads", threads)
        self.assertEqual([row["threads"] for row in rows], ["1", "1", "2", "4"])
        self.assertEqual(len({row["state_hash"] for row in rows}), 1)
        self.assertEqual({row["escaped"] for row in rows}, {"0"})

    def test_a_curve_has_a_point_for_each_setting_and_one_for_bullet(self):
        folder = self.csv.parent / "curve"
        done = run("bench", "curve", "--balls", 50, "--steps", 5, "--repeats", 2, "--substeps", "1,4",
                   "--iterations", "2,8", "--out", folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(folder / "curve.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["engine"], row["substeps"], row["iterations"]) for row in rows],
                         [("bullet", "1", "")] + [("ours", s, i) for s in "14" for i in "28"])
        self.assertEqual(float(rows[0]["times_bullet"]), 1)
        self.assertEqual({row["escaped"] for row in rows}, {"0"})
        self.assertEqual((folder / "curve.png").read_bytes()[:4], b"\x89PNG")
        self.assertEqual(sorted(path.name for path in folder.iterdir()),
                         ["curve.csv", "curve.gp", "curve.png", "curve.txt"])
        # A row is what the same settings give alone.
        alone = self.rows("--balls", 50, "--steps", 5, "--substeps", 4, "--iterations", 8)
        self.assertEqual(rows[-1]["state_hash"], alone[-1]["state_hash"])

    def read(self, file):
        with open(file, newline="") as lines:
            return list(csv.DictReader(lines))

    def test_speed_has_a_row_for_each_method_beside_bullet(self):
        folder = self.csv.parent / "speed"
        done = run("bench", "speed", "--scenes", "T1-25,T3-10000", "--steps", 5, "--repeats", 2,
                   "--threads", "1,2", "--out", folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rows = self.read(folder / "speed.csv")
        methods = ["stock Bullet", "ours", "ours on 2 threads", "ours substep", "ours exact"]
        self.assertEqual([(row["scene"], row["method"]) for row in rows],
                         [("T1-25", method) for method in methods + ["ours substep 1x4 leapfrog"]] +
                         [("T3-10000", method) for method in methods])
        self.assertEqual({row["escaped"] for row in rows}, {"0"})
        self.assertEqual(rows[1]["rounds"], "2")
        self.assertEqual(rows[0]["times_bullet"], "1")
        # A ball's state is 88 bytes; ours and Bullet both hold more, but not hundreds of times that.
        for row in rows[6:]:
            self.assertGreater(float(row["bytes_a_ball"]), 88, row["method"])
            self.assertLess(float(row["bytes_a_ball"]), 20000, row["method"])
        # A row is what the same settings give alone, and physics is the same for any threads.
        alone = self.rows("--balls", 25, "--steps", 5)
        self.assertEqual(rows[1]["state_hash"], alone[-1]["state_hash"])
        self.assertEqual(rows[2]["state_hash"], rows[1]["state_hash"])
        for row in self.read(folder / "stages.csv"):
            stages = [float(row[key]) for key in row if key.endswith("_ms")
                      and key not in ("step_ms", "sum_ms")]
            self.assertAlmostEqual(sum(stages), float(row["sum_ms"]), delta=1e-5 * sum(stages))
            self.assertLessEqual(float(row["sum_ms"]), 1.00001 * float(row["step_ms"]))
        waking = self.read(folder / "waking.csv")
        self.assertEqual([row["thrown"] for row in waking], ["0", "1", "10", "100", "1000"])
        self.assertEqual(float(waking[0]["awake_mean"]), 0)
        self.assertGreaterEqual(float(waking[-1]["awake_mean"]), 1000)
        self.assertEqual((folder / "speed.png").read_bytes()[:4], b"\x89PNG")
        self.assertEqual(sorted(path.name for path in folder.iterdir()),
                         ["speed.csv", "speed.gp", "speed.png", "speed.txt", "stages.csv", "waking.csv"])

    def test_speed_says_which_rows_keep_their_bounds(self):
        folder = self.csv.parent / "speed"
        done = run("bench", "speed", "--scenes", "T1-10000", "--repeats", 1, "--threads", 1,
                   "--steps", 5, "--out", folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        bullet, *ours = self.read(folder / "speed.csv")
        self.assertEqual((bullet["ball_bound_m"], bullet["verdict"]), ("", ""))
        bounds = {"ours 3x3 leapfrog": 0.086, "ours 4x3 leapfrog": 0.049}
        self.assertEqual([row["method"] for row in ours], ["ours", "ours substep", "ours exact", *bounds])
        for row in ours:
            bound = bounds.get(row["method"], float(bullet["ball_overlap_m"]))
            self.assertEqual(float(row["ball_bound_m"]), bound, row["method"])
            keeps = (float(row["ball_overlap_m"]) <= bound and float(row["escaped"]) == 0 and
                     max(float(row["ground_overlap_m"]), float(row["wall_overlap_m"])) <= 0.012)
            self.assertEqual(row["verdict"], "pass" if keeps else "FAIL", row["method"])

    def test_speed_leaves_out_what_it_has_no_time_for(self):
        folder = self.csv.parent / "speed"
        done = run("bench", "speed", "--scenes", "T1-25,T1-100000", "--repeats", 1, "--threads", 1,
                   "--minutes", 0.2, "--out", folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("T1-100000: left out", done.stdout)
        self.assertEqual({row["scene"] for row in self.read(folder / "speed.csv")}, {"T1-25"})

    def test_features_are_compared_in_turn(self):
        folder = self.csv.parent / "features"
        done = run("bench", "features", "--repeats", 1, "--steps", 2, "--out", folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rows = self.read(folder / "features.csv")
        self.assertEqual([row["feature"] for row in rows],
                         ["nothing", "friction", "rolling resistance", "wells", "drag", "gravity",
                          "unequal balls", "sleep", "ghosts", "books and measures", "view", "session"])
        for row in rows:
            if row["feature"] in ("drag", "gravity"):  # with a value that does nothing, absent
                self.assertEqual((row["unused_to_absent"], row["verdict"]), ("", ""))
            else:
                self.assertEqual(row["verdict"],
                                 "pass" if float(row["unused_to_absent"]) <= 1.02 else "FAIL")
            self.assertGreater(float(row["used_to_absent"]), 0)
        self.assertEqual(sorted(path.name for path in folder.iterdir()), ["features.csv", "features.txt"])

    def test_runs_are_repeated_with_the_same_bits(self):
        once, again = self.rows("--balls", 25, "--steps", 20), self.rows("--balls", 25, "--steps", 20,
                                                                         "--runs", 3)
        self.assertEqual(once[-1]["state_hash"], again[-1]["state_hash"])

    def test_contacts_solved_directly_are_counted_in_each_substep(self):
        row = self.rows("--scene", "pile-stands", "--steps", 20)[-1]
        contacts, substeps = 6, 4
        self.assertEqual(int(row["direct_contacts"]), contacts * substeps * 20)
        self.assertEqual(row["unsolved_islands"], "0")

    def test_a_target_error_chooses_for_the_scene(self):
        done = run("bench", "--csv", self.csv, "--scene", "orbit-short", "--target-error", "1e-6")
        self.assertEqual(done.returncode, 0)
        with open(self.csv, newline="") as file:
            row = list(csv.DictReader(file))[-1]
        self.assertIn(f"Dt={row['dt'].rstrip('0')}"[:12], done.stderr)
        self.assertIn(f"Integrator={row['integrator']}\n", done.stderr)
        self.assertAlmostEqual(float(row["dt"]) * int(row["steps"]), 2, places=9)
        refused = run("bench", "--target-error", "1e-6", "--dt", "0.01")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--target-error and --dt: they exclude each other; allowed: one of them", refused.stderr)

    def test_the_booked_energy_is_what_was_gained(self):
        world = ("--scene", "T1", "--balls", 50, "--steps", 200)
        row = self.rows(*world)[-1]
        gained = float(row["energy_end_J"]) - float(row["energy_start_J"])
        booked = sum(float(row[source]) for source in SOURCES)
        self.assertLess(gained, -1000)
        self.assertAlmostEqual(booked, gained, delta=1e-8 * abs(gained))
        self.assertLess(max(float(row["contacts_J"]), float(row["friction_J"])), 0)
        for unbooked in (("--no-books",), ("--engine", "bullet")):
            row = self.rows(*world, *unbooked)[-1]
            self.assertEqual({row[source] for source in SOURCES}, {""}, unbooked)

    def test_from_settled_begins_where_the_world_has_come_to_rest(self):
        # zeno-rest: released at rest 5 m up, peak 9.81 * 5 J. Its bounces rise to 5 e^(2n) m, below
        # a thousandth of the peak from n = 5 on; that impact is at sqrt(2 h / g) (1 + 2 (e + .. +
        # e^4)) = 2.903 s, before which it is slow only near the top.
        row = self.rows("--scene", "zeno-rest", "--from", "settled", "--steps", 30)[-1]
        self.assertAlmostEqual(float(row["settled_s"]), 2.903 + 2, delta=0.05)
        for column in ("moved_m", "kinetic_rise_J", "kinetic_start_J", "kinetic_end_J", "contacts_J"):
            self.assertEqual(float(row[column]), 0, column)
        self.assertEqual(float(row["max_overlap_m"]), 0)
        row = self.rows("--scene", "zeno-rest", "--steps", 30)[-1]
        self.assertEqual((row["settled_s"], row["moved_m"], row["kinetic_rise_J"]), ("", "", ""))
        # The books are those of the same steps.
        row = self.rows("--scene", "T1", "--balls", 50, "--from", "settled", "--steps", 60)[-1]
        gained = float(row["energy_end_J"]) - float(row["energy_start_J"])
        booked = sum(float(row[source]) for source in SOURCES)
        self.assertAlmostEqual(booked, gained, delta=1e-8 * abs(float(row["energy_end_J"])))

    def test_a_heap_that_has_fallen_asleep_moves_no_more(self):
        row = self.rows("--scene", "T1", "--balls", 250, "--from", "asleep", "--steps", 2000)[-1]
        self.assertEqual(row["asleep"], "250")
        for column in ("moved_m", "kinetic_rise_J", "kinetic_end_J", "contacts_J", "push_out_J"):
            self.assertEqual(float(row[column]), 0, column)
        self.assertLess(float(row["max_overlap_m"]), 1e-3)
        self.assertEqual(self.rows("--scene", "T1", "--balls", 250, "--steps", 900)[-1]["asleep"], "0")
        done = run("bench", "--from", "asleep", "--engine", "bullet")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--from asleep: bullet does not say who sleeps", done.stderr)

    def test_a_world_that_never_settles_is_given_up(self):
        done = run("bench", "--scene", "bounce", "--from", "settled")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the world has not settled within 600 s: its kinetic energy is ", done.stderr)

    def test_another_seed_has_another_hash(self):
        rows = self.rows("--scene", "T1", "--balls", 100, "--steps", 10, "--seed", 1)
        rows = self.rows("--scene", "T1", "--balls", 100, "--steps", 10, "--seed", 2)
        self.assertNotEqual(rows[0]["state_hash"], rows[1]["state_hash"])

    def test_bad_options_are_refused_before_anything_runs(self):
        self.csv.write_text("another,header\n")
        for arguments, says in (
                (("--csv", self.csv), "--csv"),
                (("--scene", "T9"), "--scene T9: scene 'T9' is unknown; allowed: T1, T2"),
                (("--engine", "magic"), "--engine magic"),
                (("--balls", 0), "--balls 0: out of range; allowed: a whole number 1 to"),
                (("--balls", 4, "--scene", "billiard"), "scene 'billiard' is made for 3 ball(s)"),
                (("--dt", 2), "--dt 2"),
                (("--integrator", "magic"), "allowed: symplectic-euler, leapfrog, heun, rk4, pefrl"),
                (("--from", "rest"), "--from rest: no such moment; allowed: start, settled, asleep"),
                (("curve", "--substeps", "4,0"), "--substeps 4,0: "),
                (("--runs", 2, "--from", "asleep"), "--runs 2: runs from asleep cannot be repeated"),
                (("speed", "--scenes", "T1-26"), "--scenes T1-26: no such name; did you mean T1-25?"),
                (("speed", "--threads", "1,0"), "--threads 1,0: "),
                (("speed", "--minutes", "0"), "--minutes 0: "),
                (("features", "--features", "spin"), "--features spin: no such name;"),
                (("curve", "--scene", "T9"), "--scene T9: scene 'T9' is unknown"),
                (("--steps", "many"), "--steps many")):
            with self.subTest(arguments=arguments):
                done = run("bench", *arguments)
                self.assertEqual(done.returncode, 2)
                self.assertIn(says, done.stderr)
                self.assertEqual(done.stdout, "")
        self.assertEqual(self.csv.read_text(), "another,header\n")


if __name__ == "__main__":
    unittest.main(verbosity=2)
