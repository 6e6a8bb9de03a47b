"""A local network made of network namespaces: hosts, a cable from each to a switch, and what goes
wrong in between. Nothing of it is outside the namespaces that tests/in_namespace.sh makes, and it
vanishes with them.

    the process's own namespace: the switch        host1 ... host4: a namespace each
      link1 ------------------------------------------ eth0, 10.77.1.1
      link2 ------------------------------------------ eth0, 10.77.2.1
"""

import contextlib
import ctypes
import os
import pathlib
import re
import socket
import subprocess
import sys

GROUP, PORT = "239.255.76.67", 9171
URL = f"udpm://{GROUP}:{PORT}?ttl=1&recv_buf_size=2097152"
NAMES = pathlib.Path("/run/netns")  # where `ip netns` keeps them


def address(host):
    """Of the host's end of its cable."""
    return f"10.77.{host}.1"


def link(host):
    """The switch's end of the host's cable."""
    return f"link{host}"


def within(host):
    """Put before a command, it runs the command on the host."""
    return ["nsenter", f"--net={NAMES / f'host{host}'}"]


@contextlib.contextmanager
def on(host):
    """Sockets that this thread opens in here belong to the host."""
    libc = ctypes.CDLL(None, use_errno=True)

    def enter(namespace):
        if libc.setns(namespace.fileno(), 0) != 0:
            raise OSError(ctypes.get_errno(), f"entering {namespace.name}")

    with open("/proc/thread-self/ns/net") as before, open(NAMES / f"host{host}") as there:
        enter(there)
        try:
            yield
        finally:
            enter(before)


def require_own_namespaces():
    """Ends the program where it could touch the machine's network or mounts: it needs a user
    namespace of its own, which owns neither, and a network namespace in which nothing is."""
    mapped = pathlib.Path("/proc/self/uid_map").read_text().split()
    interfaces = {name for _, name in socket.if_nameindex()}
    if mapped[2:] != ["1"] or interfaces != {"lo"}:
        sys.exit("refused: start this through tests/in_namespace.sh lan, in namespaces of its own")


def command(*words, **options):
    """Runs it to its end; its words on failure."""
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=30,
                          **options)
    if done.returncode != 0:
        raise OSError(f"{' '.join(map(str, words))}: {done.stderr.strip()}")
    return done.stdout


class Lan:
    """Hosts with a cable each. The switch's ends are left loose: plug them into a bridge, or let a
    relay (relay.py) carry what arrives there."""

    _has_names = False  # /run is ours

    def __init__(self, hosts):
        require_own_namespaces()
        self.hosts = list(hosts)
        if not Lan._has_names:
            command("mount", "-t", "tmpfs", "lan", "/run")  # seen by us and our children only
            Lan._has_names = True
        command("ip", "link", "set", "lo", "up")
        for host in self.hosts:
            self._add(host)

    def _add(self, host):
        name = f"host{host}"
        command("ip", "netns", "add", name)
        command("ip", "link", "add", link(host), "type", "veth", "peer", "name", "eth0",
                "netns", name)
        command("ip", "address", "add", f"10.77.{host}.254/24", "dev", link(host))
        command("ip", "link", "set", link(host), "up")
        # One prefix for all, so that a source on another host's cable is not a stranger.
        for words in (["address", "add", f"{address(host)}/16", "dev", "eth0"],
                      ["link", "set", "lo", "up"], ["link", "set", "eth0", "up"],
                      ["route", "add", "224.0.0.0/4", "dev", "eth0"]):
            command("ip", "-netns", name, *words)

    def close(self):
        """Unplugs and removes everything, so that another one can be made."""
        for name in ["bridge", *map(link, self.hosts)]:
            subprocess.run(["ip", "link", "delete", name], capture_output=True)
        for host in self.hosts:
            command("ip", "netns", "delete", f"host{host}")

    def bridge(self):
        """Plugs all cables into one bridge, which floods multicast to every port."""
        command("ip", "link", "add", "bridge", "type", "bridge", "mcast_snooping", "0")
        command("ip", "link", "set", "bridge", "up")
        for host in self.hosts:
            command("ip", "link", "set", link(host), "master", "bridge")

    def filter(self):
        """Prepares lose() and cut(). OSError where the kernel cannot drop packets so."""
        for host in self.hosts:
            self._nft(host, f"""
                table netdev lan {{
                  set unheard {{ type ipv4_addr; }}
                  counter cut {{}}
                  counter lost {{}}
                  chain loss {{}}
                  chain arriving {{
                    type filter hook ingress device "eth0" priority 0;
                    ip saddr {address(host)} accept  # the loop of its own multicasts
                    ip saddr @unheard counter name cut drop
                    ip protocol udp jump loss
                  }}
                }}""")

    def lose(self, percent):
        """Drops so many of a hundred datagrams that arrive at each host, at random."""
        for host in self.hosts:
            self._nft(host, f"""
                flush chain netdev lan loss
                add rule netdev lan loss numgen random mod 100 < {percent} counter name lost drop""")

    def cut(self, senders, receivers):
        """From now on nothing from `senders` arrives at `receivers`. One way."""
        self._change("add", senders, receivers)

    def heal(self, senders, receivers):
        """Ends such a cut()."""
        self._change("delete", senders, receivers)

    def dropped(self, counter):
        """Datagrams at all hosts: "cut" or "lost"."""
        told = [command(*within(host), "nft", "list", "counter", "netdev", "lan", counter)
                for host in self.hosts]
        return sum(int(re.search(r"packets (\d+)", text).group(1)) for text in told)

    def _change(self, verb, senders, receivers):
        addresses = ", ".join(map(address, senders))
        for host in receivers:
            self._nft(host, f"{verb} element netdev lan unheard {{ {addresses} }}")

    @staticmethod
    def _nft(host, rules):
        path = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
        command(*within(host), "nft", "-f", "-", input=rules, env={**os.environ, "PATH": path})
