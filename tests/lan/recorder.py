"""Records what each host sends, on that host, before anything can be lost on the way.

    recorder.py FILE HOST...

Runs until it is terminated; says "ready" when it listens. A record is the time at which the kernel
got it (s, monotonic), the host, the size, and the datagram as it was. read() gives them back.
"""

import collections
import selectors
import signal
import socket
import struct
import sys
import time

from network import GROUP, PORT, address, on

# Linux's numbers; Python's socket module has no names for them.
SO_TIMESTAMPNS = 35
IP_ADD_SOURCE_MEMBERSHIP = 39
IP_MULTICAST_ALL = 49

TIMESPEC = struct.Struct("@ll")
RECORD = struct.Struct("<dHI")
LARGEST_DATAGRAM = 65535
FLUSH_INTERVAL = 0.1  # s; it may be read while it grows

Datagram = collections.namedtuple("Datagram", "time host data")


def listen(host):
    """A socket that hears only what the host itself sends to the group."""
    with on(host):
        heard = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    heard.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    heard.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)  # clipped to net.core.rmem_max
    heard.setsockopt(socket.SOL_SOCKET, SO_TIMESTAMPNS, 1)
    heard.setsockopt(socket.IPPROTO_IP, IP_MULTICAST_ALL, 0)
    own = socket.inet_aton(address(host))
    heard.setsockopt(socket.IPPROTO_IP, IP_ADD_SOURCE_MEMBERSHIP,
                     socket.inet_aton(GROUP) + own + own)
    heard.bind((GROUP, PORT))
    heard.setblocking(False)
    return heard


def record(file, hosts):
    is_over = []
    signal.signal(signal.SIGTERM, lambda *_: is_over.append(True))
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sockets = selectors.DefaultSelector()
    for host in hosts:
        sockets.register(listen(host), selectors.EVENT_READ, host)
    print("ready", flush=True)
    next_flush = 0
    since_epoch = time.time() - time.monotonic()
    while not is_over:
        for key, _ in sockets.select(timeout=0.1):
            try:
                while True:
                    data, notes, _, _ = key.fileobj.recvmsg(
                        LARGEST_DATAGRAM, socket.CMSG_SPACE(TIMESPEC.size))
                    seconds, nanoseconds = TIMESPEC.unpack(notes[0][2])
                    came = seconds - since_epoch + nanoseconds / 1e9
                    file.write(RECORD.pack(came, key.data, len(data)))
                    file.write(data)
            except BlockingIOError:
                pass
        if time.monotonic() >= next_flush:
            file.flush()
            next_flush = time.monotonic() + FLUSH_INTERVAL


def read(path):
    """The Datagrams of a recording in the order of their times, of one that still grows as far as it
    has come."""
    return sorted(stored(path), key=lambda datagram: datagram.time)


def stored(path):
    """Yields the Datagrams as they were stored: those of one host in their order."""
    with open(path, "rb") as file:
        while len(head := file.read(RECORD.size)) == RECORD.size:
            when, host, size = RECORD.unpack(head)
            data = file.read(size)
            if len(data) < size:
                return
            yield Datagram(when, host, data)


if __name__ == "__main__":
    with open(sys.argv[1], "wb", buffering=1 << 20) as file:
        record(file, list(map(int, sys.argv[2:])))
