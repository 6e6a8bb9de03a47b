"""The judge judged: each broken promise, forged, is found; a clean recording is not blamed.

    invariants_test.py LCM_GEN TYPES_FOLDER
"""

import pathlib
import struct
import sys
import tempfile
import unittest

import invariants
import messages
import recorder

LCM_GEN, TYPES_FOLDER = sys.argv.pop(1), sys.argv.pop(1)
TYPES = messages.Types(LCM_GEN, TYPES_FOLDER)
GENERATION = (0, 1000, 7)
A, B = (1, 0xA), (2, 0xB)  # (peer, incarnation)


class Forgery:
    """Messages as if recorded. LCM's numbers and the senders' sequences are right by themselves."""

    def __init__(self):
        self.number = {}
        self.sequence = {}
        self.recorded = []

    def header(self, sender, **changes):
        header = TYPES.module.peer_header_t()
        header.peer_id, header.incarnation = sender
        header.sequence = self.sequence[sender] = self.sequence.get(sender, 0) + 1
        header.generation_resets, header.generation_founded, header.generation_nonce = GENERATION
        for name, value in changes.items():
            setattr(header, name, value)
        return header

    def ball(self, id_=0, term=0, adopter=(0, 0), epoch=0, position=(1.0, 2.0, 3.0)):
        ball = TYPES.module.ball_state_t()
        ball.id, ball.term, ball.epoch = id_, term, epoch
        ball.adopter, ball.adopter_incarnation = adopter
        ball.position = position
        return ball

    def states(self, sender, at, *balls, **changes):
        content = TYPES.module.ball_states_t()
        self._fill(content, sender, at, balls, changes)

    def offer(self, sender, receiver, at, *balls, **changes):
        content = TYPES.module.offers_t()
        content.receiver, content.receiver_incarnation = receiver
        self._fill(content, sender, at, balls, changes)

    def _fill(self, content, sender, step, balls, changes):
        content.header = self.header(sender, **{"step": step, **changes})
        content.step = step
        content.balls, content.count = list(balls), len(balls)
        host = sender[0]
        number = self.number[host] = self.number.get(host, -1) + 1
        self.recorded.append(messages.Message(step / 60, host, number, "WELLS", 200,
                                              type(content).__name__, content))

    def found(self):
        """The kinds of violation."""
        checked = invariants.Invariants()
        for message in self.recorded:
            checked.see(message)
        checked.finish()
        return set(checked.found)


class Judge(unittest.TestCase):
    def setUp(self):
        self.forged = Forgery()

    def test_a_hand_over_and_an_adoption_are_welcome(self):
        f = self.forged
        f.states(A, 1, f.ball(0), f.ball(1))
        f.offer(A, B, 2, f.ball(0, epoch=1))
        f.offer(A, B, 2, f.ball(0, epoch=1), step=3)
        f.states(B, 2, f.ball(0, epoch=1))
        f.states(A, 4, f.ball(1))
        f.states(B, 200, f.ball(0, epoch=1), f.ball(1, term=1, adopter=B))
        self.assertEqual(f.found(), set())

    def test_two_owners_of_one_tenure(self):
        f = self.forged
        f.states(A, 1, f.ball())
        f.states(B, 1, f.ball())
        self.assertEqual(f.found(), {"two owners"})

    def test_two_receivers_of_one_tenure(self):
        f = self.forged
        f.states(A, 1, f.ball())
        f.offer(A, B, 2, f.ball(epoch=1))
        f.offer(A, (3, 0xC), 3, f.ball(epoch=1))
        self.assertIn("two owners", f.found())

    def test_an_owner_that_goes_on_after_its_offer(self):
        f = self.forged
        f.offer(A, B, 2, f.ball(epoch=1))
        f.states(A, 3, f.ball())
        self.assertEqual(f.found(), {"version went back"})

    def test_an_owner_that_goes_back_in_steps(self):
        f = self.forged
        f.states(A, 3, f.ball())
        f.states(A, 2, f.ball(), step=3)
        self.assertEqual(f.found(), {"version went back"})

    def test_a_ball_taken_without_an_offer(self):
        f = self.forged
        f.states(A, 1, f.ball())
        f.states(B, 2, f.ball(epoch=1))
        self.assertEqual(f.found(), {"taken without an offer"})

    def test_a_ball_given_by_a_stranger(self):
        f = self.forged
        f.states(A, 1, f.ball())
        f.offer((3, 0xC), B, 2, f.ball(epoch=1))
        self.assertEqual(f.found(), {"given by a stranger"})

    def test_an_adoption_in_the_name_of_another(self):
        f = self.forged
        f.states(B, 1, f.ball(term=1, adopter=(3, 0xC)))
        self.assertEqual(f.found(), {"adopted by another"})

    def test_two_founders(self):
        f = self.forged
        f.states(A, 1, f.ball(0))
        f.states(B, 1, f.ball(1))
        self.assertEqual(f.found(), {"two founders"})

    def test_numbers_that_are_not_finite(self):
        f = self.forged
        f.states(A, 1, f.ball(position=(0.0, float("nan"), 0.0)))
        self.assertEqual(f.found(), {"not finite"})

    def test_headers_that_go_back(self):
        f = self.forged
        f.states(A, 5, f.ball())
        f.states(A, 6, f.ball(), sequence=1, step=4, generation_founded=2000)
        self.assertEqual(f.found(), {"sequence does not rise", "generation went back",
                                     "version went back"})

    def test_a_message_that_was_not_recorded(self):
        f = self.forged
        f.states(A, 1, f.ball())
        f.number[1] += 1
        f.states(A, 2, f.ball())
        self.assertEqual(f.found(), {"not recorded"})

    def test_a_message_that_is_too_large(self):
        f = self.forged
        f.states(A, 1, f.ball())
        f.recorded[0] = f.recorded[0]._replace(size=1401)
        self.assertEqual(f.found(), {"too large"})


class Reader(unittest.TestCase):
    def read(self, data):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "recording"
            path.write_bytes(recorder.RECORD.pack(1.5, 2, len(data)) + data)
            return list(TYPES.read(path))

    def test_what_was_sent_comes_back(self):
        heartbeat = TYPES.module.heartbeat_t()
        heartbeat.header.peer_id = 9
        head = struct.pack(">II", messages.SHORT_MESSAGE, 77)
        [message] = self.read(head + b"WELLS_HEARTBEAT\0" + heartbeat.encode())
        self.assertEqual((message.time, message.host, message.number, message.type),
                         (1.5, 2, 77, "heartbeat_t"))
        self.assertEqual(message.content.header.peer_id, 9)

    def test_what_is_no_message_of_ours_is_told(self):
        head = struct.pack(">II", messages.SHORT_MESSAGE, 0) + b"WELLS_BALLS\0"
        whole = TYPES.module.ball_states_t().encode()
        for data in (b"", b"short", head, head + b"12345678rest", head + whole[:-3],
                     struct.pack(">II", 0x4C433033, 0) + b"a fragment\0"):
            with self.subTest(data), self.assertRaises(messages.Undecodable):
                self.read(data)


if __name__ == "__main__":
    unittest.main(verbosity=1)
