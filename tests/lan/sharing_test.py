"""Four peers on a LAN share a world: on a good network, on one that loses a fifth of the datagrams,
and while peers come and go."""

import signal
import time

import scenario
from ownership import publications, stale, until_good_bye


class GoodNetwork(scenario.Scenario):
    def test_balls_change_hands_and_views_agree(self):
        peers = [self.start(host, "--duration", 3) for host in self.HOSTS]
        self.end(peers)
        published = publications(until_good_bye(self.judge()))
        self.assert_agreement(peers)
        reports = [peer.report() for peer in peers]
        self.assertEqual(sum(report["adoptions"] for report in reports), 0)
        self.assertEqual(list(stale(published)), [], "a ball with two owners at a time")
        self.assertGreaterEqual(sum(report["handovers"] for report in reports), self.BALLS / 2)


class LossyNetwork(scenario.Scenario):
    LEASE = 2.0  # s; whoever has lost states has two of them to settle

    def test_nothing_breaks_when_a_fifth_of_all_datagrams_is_lost(self):
        self.use_filter()
        self.lan.lose(20)
        peers = [self.start(host, "--duration", 2) for host in self.HOSTS]
        self.end(peers)
        self.assertGreater(self.lan.dropped("lost"), 500)
        self.judge()
        self.assert_agreement(peers)


class ComingAndGoing(scenario.Scenario):
    def test_one_joins_late_and_one_leaves(self):
        early = {host: self.start(host, "--duration", 7) for host in (1, 2, 3)}
        self.await_active(early)
        time.sleep(1)
        started = time.monotonic()
        late = self.start(4, "--duration", 7)
        joined = self.await_active([4]) - started
        time.sleep(1)
        left = time.monotonic()
        early[2].process.send_signal(signal.SIGINT)
        stay = [early[1], early[3], late]
        self.end([early[2], *stay])
        recorded = list(publications(self.judge()))
        self.assert_agreement(stay)

        self.assertLessEqual(joined, 2 * self.LEASE + 3, "listening, and 3 s to gather states")
        self.assertGreater(sum(p.peer == 4 for p in recorded), 0, "the late one was given nothing")
        last = {}  # before it left
        again = {}  # by somebody else since
        for p in recorded:
            if p.peer != 2 and p.time > left:
                again.setdefault(p.ball, p.time - left)
            elif p.time <= left:
                last[p.ball] = p.peer
        own = [ball for ball, peer in last.items() if peer == 2]
        self.assertGreaterEqual(len(own), 20)
        print(f"joined after {joined:.2f} s; {len(own)} balls of the one who left owned again after "
              f"{max(again[ball] for ball in own):.2f} s")
        self.assertLessEqual(max(again[ball] for ball in own), self.LEASE)


if __name__ == "__main__":
    scenario.main()
