# SPDX-License-Identifier: BSD-3-Clause
"""Tell whether a PLY file has all of its data. If it is cut off, VTK's reader shows what is left, or crashes.
It also crashes if a number of elements or corners is negative, or if faces have no list of corners.

    missing_of(path)    # "" if nothing is missing, otherwise what is wrong

Source: Turk 1994, "The PLY Polygon File Format".
"""
import numpy as np

__all__ = ["missing_of"]

SIZES = {"char": 1, "int8": 1, "uchar": 1, "uint8": 1, "short": 2, "int16": 2, "ushort": 2, "uint16": 2, "int": 4,
         "int32": 4, "uint": 4, "uint32": 4, "float": 4, "float32": 4, "double": 8, "float64": 8}
WHOLE = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
         "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4"}


def missing_of(path):
    """What is missing at the end of a PLY file; empty if nothing is, or if this is no such file."""
    with open(path, "rb") as file:
        data = file.read()
    if not data.startswith(b"ply"):
        return ""  # the reader says so
    end = data.find(b"end_header")
    begin = data.find(b"\n", end) + 1
    if end < 0 or not begin:
        return "the header has no end"
    try:
        header = data[:end].decode("ascii", "replace")
        kind, elements = parsed(header)
        if not has_corners(header, elements):
            return "its faces have no property vertex_indices"
        has_all = has_lines(data[begin:], elements) if kind == "ascii" else ends_within(data, begin, elements, kind)
    except (KeyError, ValueError, IndexError):
        return "the file is damaged"
    return "" if has_all else f"the file is cut off; its header names {named(elements)}"


def named(elements):
    return ", ".join(f"{count} of the element '{name}'" for name, count, _ in elements)


def parsed(header):
    """The format, and each element's name, count and properties: the types of a list's length and items, or one type."""
    kind, elements = "ascii", []
    for line in header.splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            kind = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
            if elements[-1][1] < 0:  # VTK's reader crashes
                raise ValueError
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[2:4] if words[1] == "list" else words[1:2])
    return kind, elements


def has_corners(header, elements):
    """Is there a list of corners that VTK's reader knows, if there are faces? Without it the reader crashes."""
    names = [line.split()[-1] for line in header.splitlines() if line.split()[:2] == ["property", "list"]]
    return not any(name == "face" and count for name, count, _ in elements) or "vertex_indices" in names or "vertex_index" in names


def has_lines(text, elements):
    """Are there a line for each of the elements, and all numbers in the last one?"""
    lines = [line for line in text.splitlines() if line.strip()]
    wanted = sum(count for _, count, _ in elements)
    if len(lines) < wanted or not wanted:
        return not wanted
    begin = 0
    for _, count, kinds in elements:
        if kinds and len(kinds[0]) == 2 and any(line.lstrip().startswith(b"-") for line in lines[begin:begin + count]):
            raise ValueError  # a list of a negative length: VTK's reader crashes
        begin += count
    numbers, at = lines[wanted - 1].split(), 0
    for kinds in next(kinds for _, count, kinds in reversed(elements) if count):
        at += 1 + (int(numbers[at]) if len(kinds) == 2 and at < len(numbers) else 0)
    return len(numbers) >= at


def ends_within(data, at, elements, kind):
    """Do the bytes of all elements fit into the file?"""
    order = ">" if kind == "binary_big_endian" else "<"
    for _, count, properties in elements:
        if any(len(kinds) == 2 for kinds in properties):
            at = end_of_lists(data, at, count, properties, order)
        else:
            at += count * sum(SIZES[kinds[0]] for kinds in properties)
        if at > len(data):
            return False
    return True


def end_of_lists(data, at, count, properties, order):
    """Where elements with lists end; a position beyond the end of the data if the data end earlier."""
    if len(properties) == 1 and count and at < len(data):  # mostly they are all of one length
        length, item = (order + WHOLE[properties[0][0]], SIZES[properties[0][1]])
        size = np.dtype(length).itemsize
        if at + size <= len(data):
            row = size + item * int(np.frombuffer(data, length, 1, at)[0])
            if row < size:
                raise ValueError
            if at + count * row <= len(data):
                rows = np.frombuffer(data, np.uint8, count * row, at).reshape(count, row)
                if (rows[:, :size] == rows[0, :size]).all():
                    return at + count * row
    for _ in range(count):
        for kinds in properties:
            if len(kinds) == 2:
                length = order + WHOLE[kinds[0]]
                size = np.dtype(length).itemsize
                if at + size > len(data):
                    return len(data) + 1
                number = int(np.frombuffer(data, length, 1, at)[0])
                if number < 0:
                    raise ValueError
                at += size + SIZES[kinds[1]] * number
            else:
                at += SIZES[kinds[0]]
    return at
