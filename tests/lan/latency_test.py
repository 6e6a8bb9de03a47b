"""The hardest network of the field's teaching labs: a relay delays every datagram by 100 +- 50 ms,
so that many overtake others, and each link loses a fifth of them.

Options of its own: --help. The kept table is made by
    tests/in_namespace.sh lan python3 tests/lan/latency_test.py PROGRAM LCM_GEN TYPES_FOLDER \\
      --seconds 60 --results tests/lan/results/latency.txt
"""

import argparse
import json
import pathlib
import sys

import scenario
from table import table_of

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--seconds", type=float, default=5, help="of simulated time")
parser.add_argument("--balls", type=int, default=1000)
parser.add_argument("--delay", type=float, default=0.1, help="s")
parser.add_argument("--spread", type=float, default=0.05, help="s, either way")
parser.add_argument("--loss", type=int, default=20, help="%% of the datagrams on each link")
parser.add_argument("--results", type=pathlib.Path, help="file for the table")


class LateAndLossyNetwork(scenario.Scenario):
    LEASE = 2.0  # s; whoever has lost states has two of them to settle

    def plug_in(self):
        self.relay = scenario.Helper("relay.py", options.delay, options.spread, 1, *self.HOSTS)
        self.addCleanup(self.relay.end)

    def test_all_invariants_hold(self):
        self.use_filter()
        self.lan.lose(options.loss)
        peers = [self.start(host, "--duration", options.seconds) for host in self.HOSTS]
        self.end(peers, timeout=30 + 3 * options.seconds)
        relayed = json.loads(self.relay.end())
        recorded, violations = self.check()
        table = table_of(
            f"{len(peers)} peers, {options.balls} balls, {options.seconds:g} s; each datagram "
            f"{1000 * options.delay:g} +- {1000 * options.spread:g} ms late, {options.loss} % lost "
            "on each link", recorded, [peer.report() for peer in peers], relayed,
            self.lan.dropped("lost"), violations)
        print(f"\n{table}")
        if options.results:
            options.results.write_text(table)
        self.assertEqual(violations, [])
        self.assert_agreement(peers)


if __name__ == "__main__":
    options, sys.argv[1:] = parser.parse_known_args()
    LateAndLossyNetwork.BALLS = options.balls
    scenario.main()
