"""The hardest network of the field's teaching labs: a relay delays every datagram by 100 +- 50 ms,
so that many overtake others, and each link loses a fifth of them.

Before unittest's own: --seconds N of simulated time (15), --results FILE for the table.
"""

import argparse
import sys

import scenario
from table import table_of

OPTIONS = argparse.ArgumentParser()
OPTIONS.add_argument("--seconds", type=float, default=15)
OPTIONS.add_argument("--results")
OPTIONS.add_argument("--delay", type=float, default=0.1)
OPTIONS.add_argument("--spread", type=float, default=0.05)
OPTIONS.add_argument("--loss", type=int, default=20)
OPTIONS.add_argument("--balls", type=int, default=1000)


class LateAndLossyNetwork(scenario.Scenario):
    LEASE = 2.0
    BALLS = 1000

    def plug_in(self):
        self.relay = scenario.Helper("relay.py", options.delay, options.spread, 1, *self.HOSTS)
        self.addCleanup(self.relay.end)

    def test_all_invariants_hold(self):
        self.use_filter()
        self.lan.lose(options.loss)
        peers = [self.start(host, "--duration", options.seconds) for host in self.HOSTS]
        for peer in peers: print(peer.wait(60 + 3 * options.seconds)[1])
        self.recorder.end()
        relayed = self.relay.end()
        lost = self.lan.dropped("lost")
        reports = [peer.report() for peer in peers]
        table = table_of(self.types.read(self.recording), reports, relayed, lost)
        print(table)
        if options.results:
            with open(options.results, "w") as file:
                file.write(table)
        self.judge()
        self.assert_agreement(peers)


if __name__ == "__main__":
    options, sys.argv[1:] = OPTIONS.parse_known_args()
    LateAndLossyNetwork.BALLS = options.balls
    scenario.main()
