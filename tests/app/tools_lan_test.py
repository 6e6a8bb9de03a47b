"""Does multicast pass between two machines? Asked on a LAN of network namespaces:
    tests/in_namespace.sh lan python3 tests/app/tools_lan_test.py PROGRAM
"""

import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "lan"))
import network
from peers import PROGRAM

HOSTS = (1, 2)


class Probing(unittest.TestCase):
    def setUp(self):
        self.lan = network.Lan(HOSTS)
        self.addCleanup(self.lan.close)
        self.lan.bridge()

    def ask(self, url=network.URL):
        """Status and words of both, which run at the same time."""
        runs = [subprocess.Popen([*network.within(host), PROGRAM, "peers", "--seconds", "4",
                                  "--lcm-url", url], stdout=subprocess.PIPE, text=True)
                for host in HOSTS]
        said = [process.communicate(timeout=60)[0] for process in runs]
        return [process.returncode for process in runs], said

    def test_passes(self):
        statuses, said = self.ask()
        self.assertEqual(statuses, [0, 0], said)
        for host, text in zip(HOSTS, said):
            self.assertIn(f"ttl 1 (reaches the LAN), by eth0 ({network.address(host)})\n", text)
            self.assertRegex(text, r"(9\d|100) % +yes, (9\d|100) % +[\d.]+ ms\n")
            self.assertIn("Multicast passes both ways.\n", text)

    def test_does_not_leave_with_ttl_0(self):
        statuses, said = self.ask(network.URL.replace("ttl=1", "ttl=0"))
        self.assertEqual(statuses, [1, 1])
        self.assertIn("ttl=0 stays on this machine. To reach the LAN:\n"
                      f"  --lcm-url '{network.URL}'\n", said[0])

    def test_passes_one_way(self):
        try:
            self.lan.filter()
        except OSError as error:
            self.skipTest(f"this machine cannot drop packets: {error}")
        self.lan.cut([1], [2])
        statuses, said = self.ask()
        self.assertEqual(statuses, [1, 1])
        self.assertRegex(said[0], r"(9\d|100) % +no +-\n")
        self.assertIn("Multicast comes from another machine, and does not get back to it.", said[0])
        self.assertIn("Nobody else was heard in 4 s.", said[1])


if __name__ == "__main__":
    unittest.main(verbosity=2)
