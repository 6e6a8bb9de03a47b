"""The table and the rows of `bench stress`:
    python3 tests/stress/bench_stress_test.py PROGRAM
"""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


def bench(*arguments):
    return subprocess.run([PROGRAM, "bench", "stress", *map(str, arguments)], text=True,
                          capture_output=True, timeout=120)


class BenchStress(unittest.TestCase):
    def test_engines_of_both_executables_share_table_and_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "stress.csv"
            done = bench("--cases", "overlap-pair,not-finite", "--engines", "ours,bullet", "--csv",
                         file)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(file, newline="") as opened:
                rows = list(csv.DictReader(opened))
        self.assertEqual([(row["case"], row["engine"]) for row in rows],
                         [("overlap-pair", "ours"), ("overlap-pair", "bullet"),
                          ("not-finite", "ours"), ("not-finite", "bullet")])
        self.assertEqual([row["worlds"] for row in rows], ["6", "6", "6", "6"])
        self.assertEqual([row["verdict"] for row in rows if row["engine"] == "ours"],
                         ["held", "held"])
        self.assertIn("infected", rows[3]["verdict"])
        for row in rows:
            self.assertTrue(row["commit"] and row["cpu"])
            self.assertIn(row["verdict"], done.stdout)

    def test_every_case_is_listed_with_its_worlds(self):
        lines = bench("--list").stdout.splitlines()
        self.assertGreaterEqual(len(lines), 19)
        for line in lines:
            self.assertRegex(line, r"^[a-z-]+ +\d+ world\(s\) of +\d+ steps  \S")
            self.assertLessEqual(len(line), 110)

    def test_wrong_names_are_refused_before_anything_runs(self):
        for arguments, says in ((("--cases", "fast-bal"), "did you mean fast-ball?"),
                                (("--engines", "magic"), "allowed: ours, "),
                                (("--contacts", "best"), "allowed: substep, exact, auto"),
                                (("--limit", "0"), "--limit 0"),
                                (("--csv", "/no/such/folder/file"), "--csv")):
            with self.subTest(arguments=arguments):
                done = bench(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(says, done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
