"""One of four peers on a LAN is killed while all balls fall towards each other, or stands still for
longer than its lease."""

import math
import signal
import time

import collapse
import scenario
from ownership import owners_at, publications

VICTIM = 3


class KilledOwner(scenario.Scenario):
    WORLD = collapse.OPTIONS
    CLEAR = 3 * collapse.RADIUS  # m between centres: no contact
    NEAR = 1e-4  # m, m/s; close to the well the world's integrator errs by 1e-6 to 1e-5
    LIFTED = 0.02  # m above the ground, where all lay: no contact

    def test_its_balls_go_on_in_other_hands(self):
        peers = {host: self.start(host, "--duration", 6) for host in self.HOSTS}
        self.await_active(self.HOSTS)
        time.sleep(3)
        peers[VICTIM].process.send_signal(signal.SIGKILL)
        killed = time.monotonic()
        del peers[VICTIM]
        self.end(peers.values())
        recorded = self.judge()
        self.assert_agreement(list(peers.values()))

        orphans = {ball for ball, (peer, _) in owners_at(recorded, killed).items()
                   if peer == VICTIM}
        self.assertGreaterEqual(len(orphans), 20, "the victim had too little to lose")
        before, first, after = {}, {}, {}
        for p in publications(recorded):
            if p.time <= killed:
                before[p.ball] = p
            elif p.peer != VICTIM:
                first.setdefault(p.ball, p)
        self.assertEqual(len(before), self.BALLS)
        self.assertEqual(set(first), set(before), "a ball is lost")
        last = max(first[ball].time for ball in orphans) - killed
        print(f"{len(orphans)} orphans, all owned again after {last:.2f} s")
        self.assertLessEqual(last, 2 * self.LEASE)

        # Each ball at the time at which the last orphan was owned again.
        for p in publications(recorded):
            if p.time <= killed + last and p.peer != VICTIM:
                after[p.ball] = p
        had = sum(collapse.energy(p.state) for p in before.values())
        has = sum(collapse.energy(p.state) for p in after.values())
        kinetic = sum(sum(v * v for v in p.state.velocity) / 2 for p in before.values())
        print(f"energy {had:.1f} J at the kill ({kinetic:.1f} J kinetic), {has:.1f} J after")
        self.assertLessEqual(has, had + 1e-3 * kinetic)
        self.assert_flew_on(orphans, before, first, publications(recorded))

    def assert_flew_on(self, orphans, before, first, published):
        """Orphans that met nobody are where flight alone has brought them."""
        start = min(before[ball].step for ball in orphans)
        end = max(first[ball].step for ball in orphans)
        places = collapse.places(published, start, end)
        lone = 0
        for ball in orphans:
            steps = range(before[ball].step, first[ball].step + 1)
            if any(self.is_close_to_anything(ball, places, step) for step in steps):
                continue
            lone += 1
            path, velocity = collapse.flight(before[ball].state, len(steps) - 1)
            self.assertLessEqual(math.dist(path[-1], first[ball].state.position), self.NEAR)
            self.assertLessEqual(math.dist(velocity, first[ball].state.velocity), self.NEAR)
        print(f"{lone} of them met nobody and flew on as computed")
        self.assertGreaterEqual(lone, 10)

    def is_close_to_anything(self, ball, places, step):
        place = places[ball][step]
        return place[1] < collapse.RADIUS + self.LIFTED or any(
            math.dist(place, there[step]) < self.CLEAR
            for other, there in places.items() if other != ball)


class StoppedOwner(scenario.Scenario):
    STOP = 5.0  # s

    def test_it_comes_back_as_another_and_all_agree(self):
        peers = {host: self.start(host, "--duration", 9) for host in self.HOSTS}
        self.await_active(self.HOSTS)
        time.sleep(1.5)
        peers[VICTIM].process.send_signal(signal.SIGSTOP)
        time.sleep(self.STOP)
        woken = time.monotonic()
        peers[VICTIM].process.send_signal(signal.SIGCONT)
        self.end(peers.values())
        recorded = self.judge()
        self.assert_agreement(list(peers.values()))

        senders = {}
        for message in recorded:
            if message.host == VICTIM and message.type:
                senders.setdefault(message.content.header.incarnation, []).append(message.time)
        self.assertEqual(len(senders), 2, "it has not come back as another")
        old, new = sorted(senders.values())
        self.assertGreater(min(new), woken)
        self.assertLess(max(old), woken, "what waited to be sent has left after it woke")
        orphans = sum(p.peer != VICTIM and p.tenure.term > 0 for p in publications(recorded))
        self.assertGreater(orphans, 0, "its balls were not adopted")


if __name__ == "__main__":
    scenario.main()
