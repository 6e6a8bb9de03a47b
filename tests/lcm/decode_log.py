"""Decodes an LCM log with lcm-gen's Python bindings and checks every field of every type of ours.

    decode_log.py LCM_GEN TYPES_FOLDER LOG

The log holds what every_type.h says: every field, in the order of its declaration, the next number
of 1, 2, 3 ...
"""

import pathlib
import subprocess
import sys
import tempfile

import lcm


def values(message, counts):
    """All fields in the order of their declaration; counts of arrays go into `counts`."""
    fields = list(zip(message.__slots__, message.__dimensions__))
    are_counts = {size for _, dimensions in fields for size in dimensions or () if isinstance(size, str)}
    for name, dimensions in fields:
        value = getattr(message, name)
        if name in are_counts:
            continue
        if dimensions is None:
            yield from one(value, counts)
            continue
        if isinstance(dimensions[0], str):
            counts.append((getattr(message, dimensions[0]), value))
        for element in value:
            yield from one(element, counts)


def one(value, counts):
    if hasattr(value, "__slots__"):
        yield from values(value, counts)
    else:
        yield value


def expected(value, number):
    if isinstance(value, bool):
        return number % 2 == 1
    return str(number) if isinstance(value, str) else number


def check(type_name, message):
    counts = []
    fields = list(values(message, counts))
    if not fields:
        sys.exit(f"{type_name} has no fields")
    for number, value in enumerate(fields, start=1):
        if value != expected(value, number):
            sys.exit(f"{type_name}: field {number} is {value!r}")
    for count, array in counts:
        if count != len(array) or count == 0:
            sys.exit(f"{type_name}: count is {count}, and there are {len(array)}")
    return len(fields)


def main():
    lcm_gen, types_folder, log = sys.argv[1:]
    types = sorted(pathlib.Path(types_folder).glob("*.lcm"))
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([lcm_gen, "--python", "--ppath", folder, *types], check=True)
        sys.path.insert(0, folder)
        import gravity_wells

        missing = {path.stem for path in types}
        for event in lcm.EventLog(log):
            name = event.channel.removeprefix("WELLS_TEST_")
            if name not in missing:
                continue
            message = getattr(gravity_wells, name).decode(event.data)
            print(f"{name}: {check(name, message)} fields")
            missing.discard(name)
    if missing:
        sys.exit(f"not in the log: {sorted(missing)}")


main()
