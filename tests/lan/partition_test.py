"""Four peers on a LAN that falls apart for a while: two and two that hear nothing of each other, and
two who hear the others without being heard."""

import time

import scenario
from ownership import digests_at_the_end, publications, stale


class Partition(scenario.Scenario):
    APART = 3.0  # s
    LEFT, RIGHT = (1, 2), (3, 4)

    def test_both_halves_carry_on_and_agree_after_healing(self):
        recorded, cut, healed = self.part(both_ways=True)
        apart = [p for p in publications(recorded) if cut < p.time < healed]
        for half in (self.LEFT, self.RIGHT):
            balls = {p.ball for p in apart if p.peer in half}
            self.assertEqual(len(balls), self.BALLS, f"{half} have not carried on with all balls")
        self.assert_one_owner_each(recorded, healed)

    def test_those_who_are_not_heard_give_up_their_balls(self):
        recorded, _, healed = self.part(both_ways=False)
        self.assert_one_owner_each(recorded, healed)

    def part(self, both_ways):
        """Runs a session that is cut between LEFT and RIGHT for a while, or in which RIGHT hears
        nothing of LEFT. Returns the recording, and when it was cut and healed (s)."""
        self.use_filter()
        peers = [self.start(host, "--duration", 7) for host in self.HOSTS]
        self.await_active(self.HOSTS)
        time.sleep(1)
        self.lan.cut(self.LEFT, self.RIGHT)
        if both_ways:
            self.lan.cut(self.RIGHT, self.LEFT)
        cut = time.monotonic()
        time.sleep(self.APART)
        dropped = self.lan.dropped("cut")
        self.lan.heal(self.LEFT, self.RIGHT)
        if both_ways:
            self.lan.heal(self.RIGHT, self.LEFT)
        healed = time.monotonic()
        self.end(peers)
        self.assertGreater(dropped, 100)
        recorded = self.judge()
        self.assert_agreement(peers)
        return recorded, cut, healed

    def assert_one_owner_each(self, recorded, healed):
        doubled = list(stale(publications(recorded)))
        last = max([healed, *(p.time for p in doubled)]) - healed
        print(f"{len(doubled)} states of balls that another had taken, none later than {last:.2f} s "
              "after healing")
        self.assertLessEqual(last, 2 * self.LEASE)
        records = digests_at_the_end(recorded)
        self.assertEqual(set(records), set(self.HOSTS))
        for known in records.values():
            self.assertEqual(known, records[1])
        self.assertEqual(sum(counted for counted, _ in records[1].values()), self.BALLS, records)


if __name__ == "__main__":
    scenario.main()
