"""The work-precision benchmark: its files, what they hold, and bad options:
    python3 tests/app/accuracy_bench_test.py PROGRAM
"""

import csv
import math
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from peers import run

POINTS = ("case,engine,integrator,contacts,dt,steps,error,error_unit,energy_error,escaped,cpu_s,"
          "repeats,exact_share,substep_share,impacts,handed_over,direct_contacts,unsolved_islands,"
          "contacts_J,friction_J,drag_J,wells_J,push_out_J,flight_J,state_hash,commit,compiler,flags,cpu")
OVERVIEW = ("case,error,error_unit,ours_cpu_s,best_of_ours_cpu_s,best_of_ours,published_cpu_s,published,"
            "textbook_cpu_s,textbook,bullet_cpu_s,ratio_published,ratio_textbook,ratio_bullet")
REFERENCES = ("reference-euler", "reference-improved-euler", "reference-rk", "reference-heun",
              "reference-rk4")
DURATIONS = {"orbit": 20, "bounce": 10}
PNG = b"\x89PNG\r\n\x1a\n"


def rows_of(file):
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


def methods_of(rows):
    return {(row["engine"], row["integrator"], row["contacts"]) for row in rows}


class AccuracyBench(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.out = pathlib.Path(folder.name) / "a'new" / "folder"
        # Long enough for all ten step sizes on a slow machine.
        cls.done = run("bench", "accuracy", "--quick", "--longest-run", 10, "--cases",
                       "orbit,bounce", "--out", cls.out, timeout=250)
        assert cls.done.returncode == 0, cls.done.stderr
        cls.rows = {case: rows_of(cls.out / f"{case}.csv") for case in DURATIONS}

    def method(self, case, *names):
        return [row for row in self.rows[case]
                if (row["engine"], row["integrator"], row["contacts"])[:len(names)] == names]

    def test_all_files_are_there_and_nothing_else(self):
        names = {f"{stem}.{end}" for stem in (*DURATIONS, "overview") for end in ("csv", "gp", "png")}
        names |= {"overview.txt", "conditions.txt"}
        self.assertEqual({file.name for file in self.out.iterdir()}, names)
        for file in self.out.glob("*.png"):
            self.assertEqual(file.read_bytes()[:8], PNG, file)

    def test_tables_have_their_columns_and_every_method(self):
        for case, duration in DURATIONS.items():
            self.assertEqual((self.out / f"{case}.csv").read_text().splitlines()[0], POINTS)
            methods = methods_of(self.rows[case])
            for contacts in ("substep", "exact"):
                for integrator in ("symplectic-euler", "leapfrog", "heun", "rk4", "pefrl"):
                    self.assertIn(("ours", integrator, contacts), methods)
            self.assertIn(("ours", "pefrl", "auto"), methods)
            self.assertEqual({engine for engine, _, _ in methods},
                             {"ours", "bullet", *REFERENCES})
            for row in self.rows[case]:
                self.assertEqual((row["case"], row["error_unit"]), (case, "m"))
                self.assertAlmostEqual(float(row["dt"]) * int(row["steps"]), duration, places=9)
                self.assertGreater(float(row["cpu_s"]), 0)
                self.assertTrue(all(row[column] for column in ("commit", "compiler", "flags", "cpu")))
                self.assertRegex(row["state_hash"], "^[0-9a-f]{16}$")

    def test_every_method_runs_ever_smaller_steps(self):
        for case, rows in self.rows.items():
            for method in methods_of(rows):
                steps = [int(row["steps"]) for row in self.method(case, *method)]
                self.assertGreaterEqual(len(steps), 3, (case, method))
                self.assertTrue(all(2 * a == b for a, b in zip(steps, steps[1:])), (case, method))

    def test_leapfrog_is_of_second_order_on_the_orbit(self):
        points = [(math.log(float(row["dt"])), math.log(float(row["error"])))
                  for row in self.method("orbit", "ours", "leapfrog", "exact")
                  if float(row["dt"]) < 1 / 100]
        self.assertGreaterEqual(len(points), 3)
        for (dt, error), (finer_dt, finer_error) in zip(points, points[1:]):
            self.assertAlmostEqual((error - finer_error) / (dt - finer_dt), 2, delta=0.1)

    def test_the_bounce_is_exact_by_default_and_not_with_bullet(self):
        for row in self.method("bounce", "ours", "pefrl", "auto"):
            self.assertLess(float(row["error"]), 1e-9)
            self.assertLess(float(row["energy_error"]), 1e-12)
            self.assertEqual(row["impacts"], "5")
            self.assertLess(abs(float(row["contacts_J"])), 1e-9)
        self.assertGreater(min(float(row["error"]) for row in self.method("bounce", "bullet")),
                           1e-3)

    def test_overview_compares_at_three_errors(self):
        rows = rows_of(self.out / "overview.csv")
        self.assertEqual(",".join(rows[0]), OVERVIEW)
        self.assertEqual([(row["case"], row["error"]) for row in rows],
                         [(case, error) for case in DURATIONS
                          for error in ("0.001", "1e-06", "1e-09")])
        bounce = next(row for row in rows if row["case"] == "bounce")
        self.assertTrue(bounce["ratio_bullet"].endswith("(never reached)"))
        text = (self.out / "overview.txt").read_text()
        self.assertIn(bounce["ratio_bullet"], text)
        self.assertIn(text, self.done.stdout)

    def test_conditions_say_what_was_run_and_what_was_not(self):
        text = (self.out / "conditions.txt").read_text()
        row = self.rows["orbit"][0]
        for column in ("commit", "compiler", "flags", "cpu"):
            self.assertIn(row[column], text)
        self.assertIn("bench accuracy --quick --longest-run 10 --cases orbit,bounce", text)
        # Whatever ends before the tenth and last step size has its reason there.
        for case, rows in self.rows.items():
            for method in methods_of(rows):
                if len(self.method(case, *method)) < 10:
                    name = " ".join(method) if method[0] == "ours" else method[0]
                    self.assertIn(f"{case}, {name}: ", text)

    def test_runs_that_would_take_too_long_are_listed(self):
        with tempfile.TemporaryDirectory() as folder:
            run("bench", "accuracy", "--quick", "--longest-run", 0.001, "--cases", "bounce",
                "--engines", "bullet", "--out", folder)
            text = pathlib.Path(folder, "conditions.txt").read_text()
            self.assertRegex(text, r"bounce, bullet: dt = [0-9.e-]+ s and below: not run, [0-9]+ "
                                   r"steps would take [0-9.e-]+ s, and 0\.001 s is the most")
            self.assertLess(len(rows_of(f"{folder}/bounce.csv")), 10)

    def test_asked_for_step_sizes_are_run_and_no_others(self):
        bounds = {"bouncing": ("1", 1e-10), "666": ("m^2", 1e-5)}
        with tempfile.TemporaryDirectory() as folder:
            done = run("bench", "accuracy", "--quick", "--cases", ",".join(bounds), "--engines",
                       "ours,bullet", "--dt", "0.01,0.02", "--out", folder, timeout=250)
            self.assertEqual(done.returncode, 0, done.stderr)
            for case, (unit, bound) in bounds.items():
                rows = rows_of(f"{folder}/{case}.csv")
                for method in methods_of(rows):
                    ran = [row for row in rows
                           if (row["engine"], row["integrator"], row["contacts"]) == method]
                    self.assertEqual([row["dt"] for row in ran],
                                     ["0.02", "0.01"], (case, method))
                    self.assertEqual({row["error_unit"] for row in ran}, {unit})
                    if method == ("ours", "pefrl", "auto"):
                        self.assertLessEqual(float(ran[-1]["error"]), bound, case)
                    if method[0] == "bullet":
                        self.assertGreater(float(ran[-1]["error"]), 10 * bound, case)
                self.assertIn(f"({unit})", pathlib.Path(folder, f"{case}.gp").read_text())

    def test_anyone_can_draw_again(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("orbit.csv", "orbit.gp"):
                shutil.copy(self.out / name, folder)
            subprocess.run(["gnuplot", "orbit.gp"], cwd=folder, check=True, timeout=60)
            self.assertEqual((pathlib.Path(folder) / "orbit.png").read_bytes()[:8], PNG)

    def test_without_gnuplot_the_tables_stay(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("bench", "accuracy", "--quick", "--cases", "bounce", "--engines", "bullet",
                       "--out", folder, env={"PATH": "/nonexistent"})
            self.assertEqual(done.returncode, 1)
            self.assertIn("gnuplot: cannot be started", done.stderr)
            self.assertIn('"app/install.sh plots"', done.stderr)
            self.assertEqual({row["engine"] for row in rows_of(f"{folder}/bounce.csv")}, {"bullet"})
            self.assertIn("not run", pathlib.Path(folder, "overview.txt").read_text())

    def test_bad_options_are_refused(self):
        for arguments, says in (
                (("--cases", "orbit,bilard"),
                 "--cases bilard: no such name; did you mean billiard? allowed: bounce, "),
                (("--cases", "T1"), "--cases T1: no such name; allowed: bounce, "),
                (("--engines", "bulet"), "--engines bulet: no such name; did you mean bullet?"),
                (("--repeats", 0), "--repeats 0: out of range; allowed: a whole number 1 to 100"),
                (("--dt", "0.1,2"), "--dt 0.1,2: "),
                (("--dt", "0.1,2"), "allowed: numbers 1e-6 to 1, in s, with commas between them"),
                (("--longest-run", 0), "allowed: a number 0.001 to 3600, in s"),
                (("--case", "orbit"), "--case: no such option; did you mean --cases?"),
                (("--out", "/proc/nothing"), "--out /proc/nothing: cannot be made: ")):
            with self.subTest(arguments=arguments):
                done = run("bench", "accuracy", *arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(says, done.stderr)

    def test_list_names_the_cases(self):
        listed = [line.split()[0] for line in run("bench", "accuracy", "--list").stdout.splitlines()]
        self.assertLessEqual({"bounce", "slide-to-roll", "billiard", "orbit"}, set(listed))


if __name__ == "__main__":
    unittest.main(verbosity=2)
