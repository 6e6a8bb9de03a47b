"""What must hold whatever the network does, checked from outside on everything that was sent."""

import collections

import messages

# Of a ball: at most one owner ever holds it under one of these.
Tenure = collections.namedtuple("Tenure",
                                "generation ball term adopter adopter_incarnation epoch")


def generation_of(header):
    """Comparable: the greater wins."""
    return header.generation_resets, -header.generation_founded, header.generation_nonce


def tenure_of(header, ball):
    return Tenure(generation_of(header), ball.id, ball.term, ball.adopter,
                  ball.adopter_incarnation, ball.epoch)


class Invariants:
    """Shown every message in the order of recording, it keeps `violations`, sentences, the first
    few of each kind, and counts them all in `found`."""

    MOST_TOLD = 3  # of one kind

    def __init__(self):
        self.violations = []
        self.found = collections.Counter()
        self.seen = collections.Counter()  # messages by type
        self.bytes = 0
        self._last_number = {}  # LCM's, by host
        self._last_header = {}  # by sender's incarnation
        self._last_version = {}  # by (sender's incarnation, ball)
        self._owner = {}  # by Tenure: (peer, incarnation), published or named
        self._published = set()  # Tenures
        self._offerers = collections.defaultdict(set)  # by Tenure: who said that it was given
        self._founder = {}  # by generation

    def see(self, message):
        self.seen[message.type] += 1
        self.bytes += message.size
        self._check_number(message)
        if message.type is None:
            return
        if message.size > messages.LARGEST_MESSAGE:
            self._tell("too large", f"{message.type} of {message.size} bytes")
        if not messages.is_finite(message.content):
            self._tell("not finite", f"{message.type} of host {message.host}")
        header = getattr(message.content, "header", None)
        if header is None:
            return
        self._check_header(message, header)
        if message.type == "ball_states_t":
            self._see_states(message.content)
        elif message.type == "offers_t":
            self._see_offers(message.content)

    def finish(self):
        """After the last message: what can be said only of the whole. Returns the violations."""
        for tenure in self._published:
            self._check_grant(tenure)
        for tenure, offerers in self._offerers.items():
            if self._owner_before(tenure) not in offerers:
                self._tell("given by a stranger", f"{tenure}, said only by {offerers}")
        return self.violations

    @property
    def tenures(self):
        """How many there were, of all balls."""
        return len(self._owner)

    def _tell(self, kind, text):
        self.found[kind] += 1
        if self.found[kind] <= self.MOST_TOLD:
            self.violations.append(f"{kind}: {text}")

    # LCM counts the messages of a process from 0: a gap is one that the recorder missed.
    def _check_number(self, message):
        last = self._last_number.get(message.host)
        if last is not None and message.number not in (last + 1, 0):
            self._tell("not recorded", f"{message.number - last - 1} messages of host "
                                       f"{message.host} before its number {message.number}")
        self._last_number[message.host] = message.number

    def _check_header(self, message, header):
        last = self._last_header.get(header.incarnation)
        self._last_header[header.incarnation] = header
        if last is None:
            return
        sender = f"peer {header.peer_id} ({header.incarnation:x})"
        if header.peer_id != last.peer_id:
            self._tell("shared incarnation", f"{sender} was peer {last.peer_id}")
        if header.sequence <= last.sequence:
            self._tell("sequence does not rise",
                       f"{sender}: {header.sequence} after {last.sequence}")
        if generation_of(header) < generation_of(last) and last.generation_founded != 0:
            self._tell("generation went back", sender)
        if generation_of(header) == generation_of(last) and header.step < last.step:
            self._tell("step went back", f"{sender}: {header.step} after {last.step}, "
                                         f"{message.type}")

    def _see_states(self, content):
        header = content.header
        owner = (header.peer_id, header.incarnation)
        for ball in content.balls:
            tenure = tenure_of(header, ball)
            self._published.add(tenure)
            self._see_version(header, tenure, owner, content.step)

    def _see_offers(self, content):
        header = content.header
        receiver = (content.receiver, content.receiver_incarnation)
        for ball in content.balls:
            tenure = tenure_of(header, ball)
            self._offerers[tenure].add((header.peer_id, header.incarnation))
            self._see_version(header, tenure, receiver, content.step)

    def _see_version(self, header, tenure, owner, step):
        known = self._owner.setdefault(tenure, owner)
        if known != owner:
            self._tell("two owners", f"{tenure}: {known} and {owner}")
        version = (*tenure, *owner, step)
        last = self._last_version.get((header.incarnation, tenure.ball))
        if last is not None and version < last:
            self._tell("version went back", f"peer {header.peer_id}: {version} after {last}")
        self._last_version[header.incarnation, tenure.ball] = version

    # Whose it was to give: the owner may have given it away before it ever published it.
    def _owner_before(self, tenure):
        before = tenure._replace(epoch=tenure.epoch - 1)
        if before.epoch > 0:
            return self._owner.get(before)
        if before.term > 0:
            return before.adopter, before.adopter_incarnation
        return self._founder.get(before.generation)

    # Nobody publishes a ball that it has not founded, adopted or been given.
    def _check_grant(self, tenure):
        owner = self._owner[tenure]
        if tenure.epoch > 0:
            if tenure not in self._offerers:
                self._tell("taken without an offer", f"{tenure} by {owner}")
        elif tenure.term > 0:
            if owner != (tenure.adopter, tenure.adopter_incarnation):
                self._tell("adopted by another", f"{tenure} by {owner}")
        elif self._founder.setdefault(tenure.generation, owner) != owner:
            self._tell("two founders", f"{tenure} by {owner}")
