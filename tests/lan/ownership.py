"""Who published which ball when, from a recording."""

import collections

from invariants import tenure_of

# What an owner said of a ball: `state` is the message's ball_state_t.
Publication = collections.namedtuple("Publication", "time peer incarnation ball tenure step state")


def publications(recorded):
    """All of a recording, in its order."""
    for message in recorded:
        if message.type != "ball_states_t":
            continue
        header = message.content.header
        for state in message.content.balls:
            yield Publication(message.time, header.peer_id, header.incarnation, state.id,
                              tenure_of(header, state), message.content.step, state)


def stale(published):
    """The publications of balls that somebody had published under a greater tenure before: what two
    halves of a network do, and an owner that has not heard yet that it was given up."""
    greatest = {}
    for p in published:
        if p.tenure < greatest.get(p.ball, p.tenure):
            yield p
        else:
            greatest[p.ball] = p.tenure


def owners_at(recorded, time):
    """Of each ball: (peer, incarnation), by the greatest tenure that was published or offered."""
    greatest = {}
    for message in recorded:
        if message.time > time:
            break
        if message.type not in ("ball_states_t", "offers_t"):
            continue
        content, header = message.content, message.content.header
        if message.type == "offers_t":
            owner = content.receiver, content.receiver_incarnation
        else:
            owner = header.peer_id, header.incarnation
        for ball in content.balls:
            tenure = tenure_of(header, ball)
            if ball.id not in greatest or tenure > greatest[ball.id][0]:
                greatest[ball.id] = tenure, owner
    return {ball: owner for ball, (_, owner) in greatest.items()}


def until_good_bye(recorded):
    """What was recorded before the first peer left: the others adopt its balls, two at a time may."""
    for message in recorded:
        if message.type == "heartbeat_t" and message.content.phase == message.content.LEAVING:
            return
        yield message


def digests_at_the_end(recorded):
    """{host: {bucket: (balls counted, sum)}}, as last told before the first good-bye."""
    told = {}
    for message in until_good_bye(recorded):
        if message.type != "heartbeat_t":
            continue
        heartbeat = message.content
        for i, digest in enumerate(heartbeat.digests):
            counted = int.from_bytes(digest.known, "little").bit_count()
            told.setdefault(message.host, {})[heartbeat.first_bucket + i] = counted, digest.sum
    return told
