#!/usr/bin/env python3
"""Copies parts of the engine with defects in them, each of which a test chooses at run time.

  plant.py DEFECTS ENGINE OUTPUT FILE...

DEFECTS is defects.txt; its head says what it looks like. Each FILE, relative to ENGINE, is copied
to OUTPUT/engine/FILE; where a defect is planted, the copy reads

  (::wells::planted::has(3) ? (the defect) : (the original))   for an expression
  if (::wells::planted::has(3)) {the defect} else {the original}   for statements

OUTPUT/defects.inc lists the defects for C++. The engine itself stays as it is. A defect whose
original is not found exactly once stops the build: the table cannot rot.
"""

import re
import sys
from pathlib import Path
from typing import NamedTuple, NoReturn

KEYS = ("name", "what", "file", "original", "defect")
OPTIONAL = ("faults",)
HEADER = '#include "planted/choice.h"\n'


class Defect(NamedTuple):
    number: int  # its place in the table, from 1; 0 chooses none
    line: int
    name: str
    what: str
    file: str
    original: str
    defect: str
    faults: str = ""


class Trouble(Exception):
    """With the table; says where and what."""


class Place(NamedTuple):
    """Characters of a file that one or more defects stand in for."""

    begin: int
    end: int


def fail(table: Path, line: int, text: str) -> NoReturn:
    raise Trouble(f"{table}:{line}: {text}")


def read_table(table: Path) -> list[Defect]:
    defects: list[Defect] = []
    fields: dict[str, str] = {}
    begin, last = 0, ""
    lines = table.read_text(encoding="utf-8").splitlines()
    for line, text in enumerate([*lines, ""], start=1):
        if text.startswith("#"):
            continue
        if text.strip() == "":
            if fields:
                missing = [key for key in KEYS if key not in fields]
                if missing:
                    fail(table, begin, f"the defect has no {missing[0]}")
                if any(fields["name"] == other.name for other in defects):
                    fail(table, begin, f"there is another defect {fields['name']}")
                defects.append(Defect(len(defects) + 1, begin, **fields))
                fields = {}
            continue
        if text.startswith(" "):
            if not fields:
                fail(table, line, "a continuation of nothing")
            fields[last] += "\n" + text.strip()
            continue
        key, colon, value = text.partition(":")
        if not colon or key not in KEYS + OPTIONAL:
            fail(table, line, f"'{key}' is not one of {', '.join(KEYS + OPTIONAL)}")
        if key in fields:
            fail(table, line, f"another {key}; defects are parted by an empty line")
        begin = begin if fields else line
        fields[key] = value.strip()
        last = key
    return defects


def anywhere(code: str) -> str:
    """A pattern for it, however it is broken into lines."""
    return r"\s+".join(re.escape(word) for word in re.split(r"\s+", code))


def place_of(table: Path, defect: Defect, source: str) -> Place:
    """White space in the original stands for any white space; what is not between @ is context."""
    before, at, rest = defect.original.partition("@")
    part, _, after = rest.partition("@") if at else (before, "", "")
    before = before if at else ""
    pattern = rf"{anywhere(before)}({anywhere(part)}){anywhere(after)}"
    found = [Place(*match.span(1)) for match in re.finditer(pattern, source)]
    if len(found) != 1:
        fail(table, defect.line,
             f"{defect.name}: {defect.file} has its original {len(found)} times, not once:\n"
             f"  {defect.original}")
    return found[0]


def is_statement(code: str) -> bool:
    return code.endswith((";", "}"))


def planted(table: Path, source: str, place: Place, defects: list[Defect]) -> str:
    text = source[place.begin:place.end]
    statement = is_statement(text)
    for defect in reversed(defects):
        chosen = f"::wells::planted::has({defect.number})"
        if statement:
            if defect.defect and not is_statement(defect.defect):
                fail(table, defect.line, f"{defect.name}: a statement becomes an expression")
            text = f"if ({chosen}) {{ {defect.defect} }} else {{ {text} }}"
        else:
            if not defect.defect or is_statement(defect.defect):
                fail(table, defect.line, f"{defect.name}: an expression becomes a statement")
            text = f"({chosen} ? ({defect.defect}) : ({text}))"
    return text


def copy_of(table: Path, source: str, defects: list[Defect]) -> str:
    places: dict[Place, list[Defect]] = {}
    for defect in defects:
        places.setdefault(place_of(table, defect, source), []).append(defect)
    text, end = "", 0
    for place in sorted(places):
        if place.begin < end:
            first = places[place][0]
            fail(table, first.line, f"{first.name}: its original overlaps another defect's")
        text += source[end:place.begin] + planted(table, source, place, places[place])
        end = place.end
    text += source[end:]
    return HEADER + text if places else text


def quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ") + '"'


def write(path: Path, text: str) -> None:
    """What has not changed is not touched, so that it is not compiled again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def main() -> None:
    table, engine, output = (Path(argument) for argument in sys.argv[1:4])
    files = sys.argv[4:]
    troubles: list[str] = []
    try:
        defects = read_table(table)
    except Trouble as trouble:
        sys.exit(str(trouble))
    for defect in defects:
        if defect.file not in files:
            troubles.append(f"{table}:{defect.line}: there is no {defect.file} to plant it in")
    for file in files:
        source = (engine / file).read_text(encoding="utf-8")
        own = [defect for defect in defects if defect.file == file]
        try:
            write(output / "engine" / file, copy_of(table, source, own))
        except Trouble as trouble:
            troubles.append(str(trouble))
    if troubles:
        sys.exit("\n".join(troubles))
    rows = (f"{{{d.number}, {quoted(d.name)}, {quoted(d.what)}, {quoted(d.file)}, "
            f"{quoted(d.faults)}}},\n"
            for d in defects)
    write(output / "defects.inc", "".join(rows))


if __name__ == "__main__":
    main()
