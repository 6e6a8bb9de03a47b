"""Real peer processes for tests: starts them, ends them, reads what they wrote."""

import csv
import json
import pathlib
import subprocess
import sys

PROGRAM = pathlib.Path(sys.argv.pop(1))  # the executable under test; unittest sees the rest
SOURCE = pathlib.Path(__file__).resolve().parents[2]
CONFIG = SOURCE / "config"


def require_own_network():
    """Ends the program where a peer could reach the machine's real network."""
    routes = pathlib.Path("/proc/net/route").read_text().splitlines()[1:]
    if any(route.split()[0] != "lo" for route in routes):
        sys.exit("refused: start this through tests/in_namespace.sh, in a network of its own")


def run(*arguments, timeout=120, **options):
    """Runs the program to its end."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=timeout, **options)


class Peer:
    """One process. Its files are peer-<id>.json and peer-<id>.csv in `folder`. `within` is put
    before its command."""

    def __init__(self, folder, peer_id, *arguments, within=()):
        self.peer_id = peer_id
        self.report_file = folder / f"peer-{peer_id}.json"
        self.state_file = folder / f"peer-{peer_id}.csv"
        self.process = subprocess.Popen(
            [*within, PROGRAM, "peer", "--peer-id", str(peer_id), "--report", self.report_file,
             "--state-out", self.state_file, *map(str, arguments)],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def wait(self, timeout):
        """The exit status and what it said."""
        said, _ = self.process.communicate(timeout=timeout)
        return self.process.returncode, said

    def report(self):
        return json.loads(self.report_file.read_text())

    def positions(self):
        with open(self.state_file, newline="") as file:
            return {row["id"]: tuple(float(row[k]) for k in "xyz") for row in csv.DictReader(file)}


def end_all(peers):
    """Kills what still runs."""
    for peer in peers:
        if peer.process.poll() is None:
            peer.process.kill()
        peer.process.stdout.close()
        peer.process.wait()


def largest_difference(a, b):
    """m, over all balls."""
    assert a.keys() == b.keys()
    return max(sum((x - y) ** 2 for x, y in zip(a[i], b[i])) ** 0.5 for i in a)
