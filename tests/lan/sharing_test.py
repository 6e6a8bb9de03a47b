"""Four peers on a LAN share a world: on a good network, on one that loses a fifth of the datagrams,
and while peers come and go."""

import scenario


class GoodNetwork(scenario.Scenario):
    def test_balls_change_hands_and_views_agree(self):
        peers = [self.start(host, "--duration", 6) for host in self.HOSTS]
        self.end(peers)
        self.assert_agreement(peers)
        self.judge()
        reports = [peer.report() for peer in peers]
        self.assertGreaterEqual(sum(report["handovers"] for report in reports), self.BALLS / 2)


class LossyNetwork(scenario.Scenario):
    def test_nothing_breaks_when_a_fifth_of_all_datagrams_is_lost(self):
        self.use_filter()
        self.lan.lose(20)
        peers = [self.start(host, "--duration", 6) for host in self.HOSTS]
        self.end(peers)
        self.assertGreater(self.lan.dropped("lost"), 1000)
        self.assert_agreement(peers)
        self.judge()


if __name__ == "__main__":
    scenario.main()
