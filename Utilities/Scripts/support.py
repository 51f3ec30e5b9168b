#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what came out of a Debian suite into Documentation/support.json, and support.md out of that.

usage: support.py SUITE FOLDER   as script/debian calls it
       support.py --paraview SUITE FOLDER   the same of the ParaView plugin, as script/debian --paraview calls it
       support.py --version VERSION FILE   as script/vtk-versions calls it; FILE: pytest's JUnit output, if there is one
       support.py                only writes support.md anew

The folder holds facts (name=value lines) and tests.xml, ctest's JUnit output, or reason: why there is none; and
again.xml when the tests that had failed were run once more, one at a time.
"""
import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

DOCUMENTATION = pathlib.Path(__file__).resolve().parents[2] / "Documentation"
DATA, PAGE = DOCUMENTATION / "support.json", DOCUMENTATION / "support.md"
PAGE_TEMPLATE = pathlib.Path(__file__).with_name("support.md.in")
PARAVIEW_FACTS = ("paraview", "python", "mpi", "compiler", "mesa")
FAILED_LINES = 3  # of what a failed test said


def said_by(case):
    """The lines that a test wrote, without the empty ones."""
    return [line.strip() for line in (case.findtext("system-out") or "").splitlines() if line.strip()]


def cases_of(file):
    return ElementTree.parse(file).getroot().findall("testcase") if file.exists() else []


def read_results(folder):
    """One entry of support.json."""
    reason, facts = folder / "reason", folder / "facts"
    entry = dict(line.split("=", 1) for line in facts.read_text().splitlines()) if facts.exists() else {}
    if reason.exists():
        return {**entry, "reason": reason.read_text().strip()}
    cases = cases_of(folder / "tests.xml")
    again = {case.get("name"): case for case in cases_of(folder / "again.xml")}
    second = [case.get("name") for case in cases
              if case.get("status") == "fail" and case.get("name") in again and again[case.get("name")].get("status") == "run"]
    cases = [again.get(case.get("name"), case) for case in cases]
    by_status = {status: [case for case in cases if case.get("status") == status] for status in ("run", "fail", "notrun")}
    return {
        **entry,
        "passed": len(by_status["run"]),
        "second": {name: "passed when it was run again, alone" for name in second},
        "failed": {case.get("name"): " / ".join(said_by(case)[-FAILED_LINES:]) for case in by_status["fail"]},
        "skipped": {case.get("name"): " ".join(said_by(case)) or "without a word" for case in by_status["notrun"]},
    }


def row(suite, entry, names=("vtk", "python", "compiler", "mesa")):
    facts = [entry.get(name, "-") for name in names]
    if "reason" in entry:
        counts = ["not run: " + entry["reason"], "-", "-"]
    else:
        counts = [entry["passed"], len(entry["failed"]), len(entry["skipped"])]
    return "| " + " | ".join(map(str, [f"{entry.get('system', 'Debian')} (`{suite}`)", *facts, *counts])) + " |"


def in_order(results, name):
    """The suites, in the order of a version."""
    return dict(sorted(results.items(), key=lambda item: item[1].get(name, "")))


def listed(kind, *tables):
    """A list of the tests of a kind, by suite, or that there is none."""
    lines = [f"- `{suite}`: {name}: {reason}" for results in tables for suite, entry in results.items()
             for name, reason in entry.get(kind, {}).items()]
    return "\n".join(lines) or "None."


def read_version(file):
    """The entry of a VTK version: counts of pytest, or that the module could not be built."""
    if not file.exists():
        return {"reason": "the module could not be built, or no test ran"}
    suite = next(ElementTree.parse(file).getroot().iter("testsuite"))
    tests, failed, skipped = (int(suite.get(name)) for name in ("tests", "failures", "skipped"))
    failed += int(suite.get("errors"))
    return {"passed": tests - failed - skipped, "failed": failed, "skipped": skipped}


def version_row(version, entry):
    counts = [entry["reason"], "-", "-"] if "reason" in entry else [entry[name] for name in ("passed", "failed", "skipped")]
    return "| " + " | ".join(map(str, [version, *counts])) + " |"


def main():
    data = json.loads(DATA.read_text()) if DATA.exists() else {}
    versions, plugins = data.setdefault("versions", {}), data.setdefault("paraview", {})
    results = {name: entry for name, entry in data.items() if name not in ("versions", "paraview")}
    if len(sys.argv) == 4 and sys.argv[1] == "--version":
        versions[sys.argv[2]] = read_version(pathlib.Path(sys.argv[3]))
    elif len(sys.argv) == 4 and sys.argv[1] == "--paraview":
        plugins[sys.argv[2]] = read_results(pathlib.Path(sys.argv[3]))
    elif len(sys.argv) == 3:
        results[sys.argv[1]] = read_results(pathlib.Path(sys.argv[2]))
    elif len(sys.argv) != 1:
        sys.exit(__doc__)
    if len(sys.argv) != 1:
        DATA.write_text(json.dumps({**results, "versions": versions, "paraview": plugins}, indent=2, sort_keys=True) + "\n")
    results, plugins = in_order(results, "vtk"), in_order(plugins, "paraview")
    PAGE.write_text(PAGE_TEMPLATE.read_text().format(
        rows="\n".join(row(suite, entry) for suite, entry in results.items()),
        paraview_rows="\n".join(row(suite, entry, PARAVIEW_FACTS) for suite, entry in plugins.items()),
        versions="\n".join(version_row(version, versions[version]) for version in sorted(versions)),
        **{kind: listed(kind, results, plugins) for kind in ("skipped", "failed", "second")}))


if __name__ == "__main__":
    main()
