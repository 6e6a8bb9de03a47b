"""What was recorded, decoded: by the types that lcm-gen makes for Python from lcm_types, so that
nothing of the engine's own codec has a part in it."""

import collections
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

import recorder

LARGEST_MESSAGE = 1400  # bytes; fits one Ethernet frame
SHORT_MESSAGE = 0x4C433032  # "LC02": LCM's datagram that holds a whole message
HEAD = struct.Struct(">II")  # that, and the sender's number of the message

# `number`: LCM's, rises by one with each message of a process. `size`: of the message, bytes.
Message = collections.namedtuple("Message", "time host number channel size type content")


class Undecodable(Exception):
    """Says what was recorded instead of a message of ours."""


class Types:
    """The classes of all types in `folder`, made by lcm-gen."""

    def __init__(self, lcm_gen, folder):
        self._made = tempfile.TemporaryDirectory()
        subprocess.run([lcm_gen, "--python", "--ppath", self._made.name,
                        *sorted(pathlib.Path(folder).glob("*.lcm"))], check=True)
        sys.path.insert(0, self._made.name)
        import gravity_wells

        self.module = gravity_wells
        named = [getattr(gravity_wells, path.stem) for path in pathlib.Path(folder).glob("*.lcm")]
        self._by_fingerprint = {type_._get_packed_fingerprint(): type_ for type_ in named}

    def decode(self, datagram):
        """The Message in a recorder.Datagram; nothing if LCM or a peer's start-up test sent it."""
        data = datagram.data
        if data.startswith(b"WELLS_PROBE"):
            return None
        magic, number = HEAD.unpack_from(data)
        end = data.index(b"\0", HEAD.size)
        channel = data[HEAD.size:end].decode()
        payload = data[end + 1:]
        if magic != SHORT_MESSAGE:
            raise Undecodable("a fragment of a message")
        if channel == "LCM_SELF_TEST":
            return Message(datagram.time, datagram.host, number, channel, len(payload), None, None)
        type_ = self._by_fingerprint.get(payload[:8])
        if type_ is None:
            raise Undecodable(f"an unknown type on {channel}")
        content = type_.decode(payload)
        return Message(datagram.time, datagram.host, number, channel, len(payload),
                       type_.__name__, content)

    def read(self, path):
        """Yields the Messages of a recording. Undecodable, with the time and the host."""
        for datagram in recorder.read(path):
            try:
                message = self.decode(datagram)
            except (Undecodable, ValueError, struct.error, UnicodeDecodeError) as error:
                raise Undecodable(f"host {datagram.host} sent {len(datagram.data)} bytes that are "
                                  f"no message of ours: {error}") from error
            if message is not None:
                yield message


def is_finite(content):
    """True when all numbers of a message are."""
    for name in content.__slots__:
        value = getattr(content, name)
        if isinstance(value, float):
            if not math.isfinite(value):
                return False
        elif isinstance(value, (list, tuple)):
            for element in value:
                if not (math.isfinite(element) if isinstance(element, (int, float))
                        else is_finite(element)):
                    return False
        elif hasattr(value, "__slots__") and not is_finite(value):
            return False
    return True
