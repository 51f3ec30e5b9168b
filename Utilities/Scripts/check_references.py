#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that Documentation/references.md lists every source that the code cites.

A citation is the text from "Source:" to the end of its comment's sentence: names, and years from 1700 to 2099. For each
year, the references must have a row with this year and with a name that stands before it.
"""
import pathlib
import re
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SUFFIXES = {".c", ".h", ".cxx", ".glsl", ".py"}
CITATION = re.compile(r"Sources?: ((?:(?!Sources?: ).){0,400})")
YEAR = re.compile(r"\b(1[7-9]\d\d|20\d\d)\b")
NAME = re.compile(r"[^\W\d_a-zà-ÿ][\w'’-]*[a-zà-ÿ]|[A-Z]{2,}")


def citations(text):
    """Every citation of a file's comments, each as one line."""
    text = re.sub(r"\n[ \t]*(?://+|\*|#)?[ \t]*", " ", text)
    return [found.group(1) for found in CITATION.finditer(text)]


def missing_of(citation, rows):
    """The years of a citation that no row has together with one of the last names before them."""
    citation = re.split(r"(?<=\d{4})[^;]*?\. (?=[A-Z])", citation.replace("et al.", ""))[0]  # its first sentence
    found = []
    years = set()
    begin = 0
    for year in YEAR.finditer(citation):
        if year.group(1) in years:  # of a conference
            continue
        years.add(year.group(1))
        names = NAME.findall(citation[begin:year.start()])[-8:]
        if not any(year.group(1) in row and any(re.search(rf"\b{name}\b", row.split("(")[0]) for name in names)
                   for row in rows):
            found.append(f"{' '.join(names)} {year.group(1)}")
        begin = year.end()
    return found


def self_test():
    """Does it find what it is to find?"""
    text = ("// what it does. Source: Porter and Duff, 1984; Samet\n// et al. 1985. Measured in 2026.\n"
            "// Source: Alpha 1984. Foo.\n// Source: Ångström 1985.")
    rows = ["| Porter, T., Duff, T. (1984): ...", "| Samet, H. (1984): ..."]
    found = [missing_of(citation, rows) for citation in citations(text)]
    print(f"self-test: {found}")
    return 0 if found == [["Samet 1985"], ["Alpha 1984"], ["Ångström 1985"]] else 1


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    rows = [line for line in (PROJECT / "Documentation/references.md").read_text(encoding="utf-8").splitlines()
            if line.startswith("| ")]
    count = 0
    missing = []
    for folder in ("Module", "Examples", "Utilities", "ParaView"):
        for path in sorted((PROJECT / folder).rglob("*")):
            if path.suffix in SUFFIXES and path != pathlib.Path(__file__).resolve():
                for citation in citations(path.read_text(encoding="utf-8", errors="replace")):
                    count += 1
                    missing += [f"{path.relative_to(PROJECT)}: {name}" for name in missing_of(citation, rows)]
    print("\n".join(missing))
    print(f"check_references: {count} citations, {len(missing)} sources that Documentation/references.md lacks")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
