"""A world whose physics is known without the engine: no gravity, and one fixed well that pulls all
balls together. The peers' own wells are off; they only say whose a ball should be."""

import math

DT = 1 / 60  # s
RADIUS = 0.5  # m
STRENGTH, SOFTENING = 600.0, 3.0  # m^3/s^2, m
CENTER = (0.0, 12.0, 0.0)  # m
OPTIONS = ("--Gravity", 0, "--Dt", DT, "--BallRadius", RADIUS, "--WellStrength", 0, "--Well",
           ",".join(map(str, (*CENTER, STRENGTH, SOFTENING))))

SUBSTEPS = 4  # of Runge and Kutta's fourth order, in a step of the world


def acceleration(x):
    """m/s^2."""
    d = [c - p for c, p in zip(CENTER, x)]
    factor = STRENGTH / (sum(e * e for e in d) + SOFTENING**2) ** 1.5
    return [factor * e for e in d]


def energy(ball):
    """J, of a ball of 1 kg: kinetic, spin's included, and potential."""
    spin = 0.4 * RADIUS**2
    d2 = sum((c - p) ** 2 for c, p in zip(CENTER, ball.position))
    return (0.5 * sum(v * v for v in ball.velocity) + 0.5 * spin * sum(w * w for w in ball.spin) -
            STRENGTH / math.sqrt(d2 + SOFTENING**2))


def flight(ball, steps):
    """Positions (m) after 0 .. steps steps of flight, and the last velocity."""
    x, v = list(ball.position), list(ball.velocity)
    h = DT / SUBSTEPS
    path = [tuple(x)]
    for _ in range(steps):
        for _ in range(SUBSTEPS):
            a1 = acceleration(x)
            v2 = [p + h / 2 * q for p, q in zip(v, a1)]
            a2 = acceleration([p + h / 2 * q for p, q in zip(x, v)])
            v3 = [p + h / 2 * q for p, q in zip(v, a2)]
            a3 = acceleration([p + h / 2 * q for p, q in zip(x, v2)])
            v4 = [p + h * q for p, q in zip(v, a3)]
            a4 = acceleration([p + h * q for p, q in zip(x, v3)])
            x = [p + h / 6 * (a + 2 * b + 2 * c + d) for p, a, b, c, d in zip(x, v, v2, v3, v4)]
            v = [p + h / 6 * (a + 2 * b + 2 * c + d) for p, a, b, c, d in zip(v, a1, a2, a3, a4)]
        path.append(tuple(x))
    return path, v


def places(published, start, end):
    """{ball: {step: position (m)}} for all steps of start .. end: flown from the last state that was
    published until then."""
    states = {}
    for p in published:
        if p.step <= end:
            states.setdefault(p.ball, {})[p.step] = p.state
    found = {}
    for ball, known in states.items():
        steps = sorted(known)
        nodes = [max(s for s in steps if s <= start), *(s for s in steps if s > start), end + 1]
        there = found[ball] = {}
        for node, until in zip(nodes, nodes[1:]):
            path, _ = flight(known[node], until - 1 - node)
            there.update((node + i, place) for i, place in enumerate(path))
    return found
