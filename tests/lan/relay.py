"""Carries multicast datagrams between the loose ends of a Lan's cables, late: each copy for each
receiver waits for a time of its own, so that some overtake others.

    relay.py DELAY SPREAD SEED HOST...     delays DELAY +- SPREAD s, evenly distributed

Runs until it is terminated; says "ready" when it listens, and at the end what it did, as JSON.
"""

import heapq
import json
import random
import selectors
import signal
import socket
import struct
import sys
import time

from network import GROUP, PORT, link

SO_BINDTODEVICE = 25
BUFFER = 4 << 20  # bytes, clipped to the kernel's largest


def membership(host):
    """struct ip_mreqn."""
    return struct.pack("=4s4si", socket.inet_aton(GROUP), b"\0" * 4,
                       socket.if_nametoindex(link(host)))


def end_of_cable(host):
    end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    end.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    end.setsockopt(socket.SOL_SOCKET, SO_BINDTODEVICE, link(host).encode() + b"\0")
    end.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER)
    end.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BUFFER)
    end.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership(host))
    end.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, membership(host))
    end.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 0)
    end.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1)
    end.bind((GROUP, PORT))
    end.setblocking(False)
    return end


class Relay:
    def __init__(self, delay, spread, seed, hosts):
        self.shortest, self.longest = delay - spread, delay + spread
        self.random = random.Random(seed)
        self.ends = {host: end_of_cable(host) for host in hosts}
        self.waiting = []  # heap of (due, number, receiver, datagram)
        self.number = 0
        self.newest_sent = {}  # number of the newest datagram sent, by receiver
        self.counts = {"received": 0, "sent": 0, "overtaken": 0, "refused": 0,
                       "most_waiting": 0, "latest_s": 0.0}

    def take(self, host):
        """Takes what has arrived from a host."""
        others = [other for other in self.ends if other != host]
        try:
            while True:
                data = self.ends[host].recv(65535)
                now = time.monotonic()
                self.counts["received"] += 1
                for other in others:
                    self.number += 1
                    due = now + self.random.uniform(self.shortest, self.longest)
                    heapq.heappush(self.waiting, (due, self.number, other, data))
        except BlockingIOError:
            self.counts["most_waiting"] = max(self.counts["most_waiting"], len(self.waiting))

    def pass_on(self):
        """Sends what is due. Returns the time until the next is, s."""
        now = time.monotonic()
        while self.waiting and self.waiting[0][0] <= now:
            due, number, host, data = heapq.heappop(self.waiting)
            self.counts["latest_s"] = max(self.counts["latest_s"], now - due)
            if number < self.newest_sent.get(host, 0):
                self.counts["overtaken"] += 1
            else:
                self.newest_sent[host] = number
            try:
                self.ends[host].sendto(data, (GROUP, PORT))
                self.counts["sent"] += 1
            except OSError:
                self.counts["refused"] += 1
        return self.waiting[0][0] - now if self.waiting else 0.1

    def run(self):
        is_over = []
        signal.signal(signal.SIGTERM, lambda *_: is_over.append(True))
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        arrivals = selectors.DefaultSelector()
        for host, end in self.ends.items():
            arrivals.register(end, selectors.EVENT_READ, host)
        print("ready", flush=True)
        while not is_over:
            for key, _ in arrivals.select(timeout=min(0.1, max(0.0, self.pass_on()))):
                self.take(key.data)
        print(json.dumps(self.counts), flush=True)


if __name__ == "__main__":
    delay, spread = map(float, sys.argv[1:3])
    Relay(delay, spread, int(sys.argv[3]), list(map(int, sys.argv[4:]))).run()
