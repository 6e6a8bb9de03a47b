"""How a session on a bad network went, as a text table."""

import os
import pathlib
import platform
import re
import subprocess

from ownership import publications, stale, until_good_bye

FOLDER = pathlib.Path(__file__).resolve().parent

ROW = "{:<30}" + 5 * "{:>11}"


def processor():
    text = pathlib.Path("/proc/cpuinfo").read_text()
    names = re.findall(r"model name\s*: (.*)", text)
    return f"{os.cpu_count()} x {names[0] if names else platform.machine()}"


def commit():
    told = subprocess.run(["git", "-C", FOLDER, "describe", "--always", "--dirty"],
                          capture_output=True, text=True)
    return told.stdout.strip() or "unknown"


def number(value):
    return f"{value:.3g}" if isinstance(value, float) and value < 1000 else f"{value:.0f}"


def longest_silence(published, until):
    """s; the longest time between two states of one ball, of anybody's."""
    last, longest = {}, 0.0
    for p in published:
        longest = max(longest, p.time - last.get(p.ball, p.time))
        last[p.ball] = p.time
    return max([longest, *(until - time for time in last.values())])


def peer_rows(reports, statistics):
    """One column a peer, and their sum where it means something."""
    run = [report["wall_time_s"] for report in reports]

    def row(name, values, total=None):
        cells = [number(value) for value in values]
        return ROW.format(name, *cells, "" if total is None else number(total(values)))

    def each(name, field, total=None):
        return row(name, [report[field] for report in reports], total)

    def a_second(name, field):
        return row(name, [report[field] / time for report, time in zip(reports, run)], sum)

    def last(name, field, total=sum):
        return row(name, [getattr(content, field) for content in statistics], total)

    return [
        ROW.format("", *(f"peer {report['peer']}" for report in reports), "all"),
        row("simulation rate, Hz", [r["rates"]["simulation"]["actual_Hz"] for r in reports]),
        row("  target", [r["rates"]["simulation"]["target_Hz"] for r in reports]),
        row("network rate, Hz", [r["rates"]["network"]["actual_Hz"] for r in reports]),
        row("  target", [r["rates"]["network"]["target_Hz"] for r in reports]),
        a_second("messages sent, 1/s", "messages_sent"),
        a_second("messages accepted, 1/s", "messages_received"),
        a_second("bytes sent, 1/s", "bytes_sent"),
        a_second("bytes received, 1/s", "bytes_received"),
        a_second("hand-overs given, 1/s", "handovers"),
        each("hand-overs given", "handovers", sum),
        each("hand-overs taken", "handovers_taken", sum),
        each("adoptions", "adoptions", sum),
        last("starts after standing still", "fences"),
        last("refused by checks", "dropped_by_checks"),
        last("dropped in queues", "dropped_in_queue"),
        last("dropped by the kernel", "dropped_by_kernel"),
        each("balls owned at the end", "balls_owned", sum),
        each("view difference at most, m", "view_difference_max_m", max),
        each("worst overlap, m", "max_overlap_m", max),
    ]


def table_of(title, recorded, reports, relayed, lost, violations):
    """`relayed`: what the relay counted. `lost`: datagrams that the links dropped."""
    statistics = {}
    for message in recorded:
        if message.type == "statistics_t":
            statistics[message.content.header.peer_id] = message.content
    shared = list(until_good_bye(recorded))
    published = list(publications(shared))
    generations = {p.tenure.generation for p in published}
    doubled = list(stale(p for p in published if p.tenure.generation == max(generations)))
    span = recorded[-1].time - recorded[0].time
    whole = [
        ("recorded", f"{len(recorded)} messages in {span:.1f} s, {len(published)} states"),
        ("violations of the invariants", str(len(violations))),
        ("lost on the links", f"{lost} of {relayed['sent']} datagrams, "
                              f"{100 * lost / max(1, relayed['sent']):.1f} %"),
        ("overtaken on the way", f"{relayed['overtaken']} datagrams, "
                                 f"{100 * relayed['overtaken'] / max(1, relayed['sent']):.1f} %"),
        ("sessions founded", f"{len(generations)}, of which one has won"),
        ("states of balls already taken", str(len(doubled))),
        ("longest without a ball's state", f"{longest_silence(published, shared[-1].time):.2f} s"),
        ("state at the end", ", ".join(sorted({r["state_hash"] for r in reports}))),
        ("commit, processor", f"{commit()}, {processor()}"),
    ]
    lines = [title, "", *peer_rows(reports, [statistics[r["peer"]] for r in reports]), "",
             *(f"{name + ':':<32}{text}" for name, text in whole)]
    return "\n".join(line.rstrip() for line in lines) + "\n"
