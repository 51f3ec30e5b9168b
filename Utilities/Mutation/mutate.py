#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Changes signs and comparisons of the core, one at a time, and sees whether the unit tests notice.

Each mutant is compiled alone, linked with the unchanged rest into a shared library, and the tests,
built once, are run with that: those that include the file's header, the one of its own name first,
then those that caught most so far. What none of them catches is tried again under the address and
undefined behaviour sanitizers, as the preset sanitize would run them, and then with all tests. See
script/mutation.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import threading

from operators import mutants_of

PROJECT = pathlib.Path(__file__).resolve().parents[2]
CORE = PROJECT / "Module/Core"
TESTS = PROJECT / "Testing/Core"
HERE = pathlib.Path(__file__).resolve().parent
LEAST_CAUGHT = 0.95
TIMEOUT_S = 20  # of one test; the longest takes half a second

COMMON = ["cc", "-std=c11", "-ffp-contract=off", "-fPIC", "-w"]
KINDS = {  # how the core and its tests are compiled
    "plain": ["-O0"],
    "sanitized": ["-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
}


def run(command, **more):
    """Runs a command; whether it succeeded in time."""
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              check=False, **more).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def must(command):
    """Runs a command that has to succeed."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")


def including(header, *folders):
    """Names of the sources in the folders that include a header, directly or not."""
    files = [path for folder in folders for path in folder.glob("*.[ch]")]
    found = {header}
    while True:
        pattern = re.compile("|".join(rf'#include "{re.escape(name)}"' for name in found))
        more = {path.name for path in files if pattern.search(path.read_text())}
        if more <= found:
            return {name for name in found if name.endswith(".c")}
        found |= more


class Build:
    """The core as it is, with its tests, compiled in one of the KINDS."""

    def __init__(self, folder, kind):
        self.flags = KINDS[kind]
        self.core = folder / "core"
        self.bin = folder / "tests"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(CORE, self.core)
        self.bin.mkdir()
        self.sources = sorted(path.name for path in self.core.glob("*.c"))
        self.tests = sorted(path.stem[5:] for path in TESTS.glob("test_*.c")
                            if path.stem != "test_header")
        for name in self.sources:
            must(self.compile(self.core, name))
        must(self.link(self.core))
        for noun in self.tests:
            must(self.build_test(self.core, noun, self.bin))
        failing = [noun for noun in self.tests if not self.passes(self.core, self.bin / noun)]
        if failing:
            sys.exit(f"without any mutant these tests fail ({kind}): {failing}")

    def compile(self, core, name):
        return [*COMMON, *self.flags, "-c", core / name, "-o", core / (name + ".o")]

    def link(self, core):
        objects = [core / (name + ".o") for name in self.sources]
        return ["cc", *self.flags, "-shared", *objects, "-lm", "-o", core / "libwater_core.so"]

    def build_test(self, core, noun, folder):
        return [*COMMON, *self.flags, "-I", core, "-I", PROJECT / "Module/GLSL",
                TESTS / f"test_{noun}.c", "-o", folder / noun, "-L", core, "-lwater_core",
                "-lcmocka", "-lm"]

    @staticmethod
    def passes(core, program):
        """Whether a test passes with the library of a folder."""
        environment = dict(os.environ, LD_LIBRARY_PATH=str(core), ASAN_OPTIONS="detect_leaks=0")
        return run([program], timeout=TIMEOUT_S, env=environment)


class Bench:
    """A copy of a build in which one file at a time is changed."""

    def __init__(self, folder, build):
        self.build = build
        self.core = folder / "core"
        self.bin = folder / "tests"  # those that a changed header has a part in
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(build.core, self.core)
        self.bin.mkdir()
        self.changed = None  # the file whose objects are not those of the original

    def _compile(self, name):
        sources = {name}
        if name.endswith(".h"):
            sources = including(name, self.core) & set(self.build.sources)
        return all(run(self.build.compile(self.core, source)) for source in sources)

    def _judge(self, name, order):
        programs = {noun: self.build.bin / noun for noun in self.build.tests}
        if name.endswith(".h"):
            # functions in headers are in the tests themselves: most need no other core to fail
            tests = [noun for noun in order
                     if f"test_{noun}.c" in including(name, TESTS, self.core)]
            for noun in tests:
                programs[noun] = self.bin / noun
                if not run(self.build.build_test(self.core, noun, self.bin)):
                    return "compiler"
                if not self.build.passes(self.core, programs[noun]):
                    return noun
        self.changed = name
        if not self._compile(name) or not run(self.build.link(self.core)):
            return "compiler"
        return next((noun for noun in order if not self.build.passes(self.core, programs[noun])),
                    None)

    def killer(self, mutant, order):
        """The first test that fails with a mutant, "compiler", or None: it survives."""
        if self.changed is not None and not (
                self.changed == mutant.file and mutant.file.endswith(".c")):
            if not self._compile(self.changed) or not run(self.build.link(self.core)):
                sys.exit(f"{self.changed} no longer builds")
            self.changed = None
        path = self.core / mutant.file
        text = path.read_text()
        path.write_text(text[:mutant.start] + mutant.new + text[mutant.end:])
        try:
            return self._judge(mutant.file, order)
        finally:
            path.write_text(text)


class Judge:
    """Hands mutants to benches, one per thread, and remembers which tests catch most."""

    def __init__(self, folder, kind, is_whole):
        self.is_whole = is_whole
        self.folder = folder / kind
        self.build = Build(self.folder / "original", kind)
        self.local = threading.local()
        self.kills = collections.Counter()

    def judge(self, mutant):
        if not hasattr(self.local, "bench"):
            self.local.bench = Bench(self.folder / threading.current_thread().name, self.build)
        own = mutant.file.split(".")[0].replace("water_", "")
        nouns = self.build.tests
        if not self.is_whole:
            header = f'#include "water_{own}.h"'
            nouns = [noun for noun in nouns if noun == own or
                     header in (TESTS / f"test_{noun}.c").read_text()]
        order = sorted(nouns, key=lambda noun: (noun != own, -self.kills[mutant.file, noun]))
        killer = self.local.bench.killer(mutant, order)
        if killer:
            self.kills[mutant.file, killer] += 1
        return killer


def read_equivalents():
    """Key -> reason, of Utilities/Mutation/equivalent.txt: a key a line, its reason indented below."""
    reasons = {}
    keys = []
    for line in (HERE / "equivalent.txt").read_text().splitlines():
        if line.startswith("#") or not line.strip():
            keys = keys if line.startswith("#") else []
        elif line[0] != " ":
            keys.append(line)
            reasons[line] = ""
        else:
            for key in keys:
                reasons[key] = (reasons[key] + " " + line.strip()).strip()
    return reasons


def judged(mutants, folder, kind, jobs, is_whole=False):
    """(mutant, killer) of each, in order; progress to stderr. is_whole: by all tests."""
    if not mutants:
        return []
    judge = Judge(folder, kind, is_whole)
    killers = []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for number, killer in enumerate(pool.map(judge.judge, mutants), 1):
            killers.append(killer)
            if not killer:
                print(f"{kind}: alive: {mutants[number - 1].key}", file=sys.stderr)
            if number % 50 == 0 or number == len(mutants):
                print(f"{kind}: {number} of {len(mutants)}, {killers.count(None)} alive",
                      file=sys.stderr, flush=True)
    return list(zip(mutants, killers))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="*", help="of Module/Core; without any: all")
    parser.add_argument("--folder", type=pathlib.Path, default=PROJECT / "build/mutation")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--again", action="store_true",
                        help="believe the last run's table what was caught; only try the rest")
    arguments = parser.parse_args()

    paths = [CORE / name for name in arguments.files] or sorted(CORE.glob("*.[ch]"))
    mutants = [mutant for path in paths for mutant in mutants_of(path.name, path.read_text())]
    equivalents = read_equivalents()
    table_path = arguments.folder / "mutants.tsv"
    known = {}  # of all files
    if table_path.exists():
        known = dict(line.split("\t") for line in table_path.read_text().splitlines())
    last = {}
    if arguments.again:
        last = {key: verdict for key, verdict in known.items()
                if verdict not in ("equivalent", "ALIVE")}
    results = {mutant.key: last.get(mutant.key) for mutant in mutants}
    results.update((mutant.key, killer) for mutant, killer in judged(
        [mutant for mutant in mutants if mutant.key not in last],
        arguments.folder, "plain", arguments.jobs))
    for kind, is_whole, how in (("sanitized", False, " under the sanitizers"), ("plain", True, "")):
        alive = [mutant for mutant in mutants
                 if not results[mutant.key] and mutant.key not in equivalents]
        results.update((mutant.key, killer + how if killer else None) for mutant, killer in
                       judged(alive, arguments.folder, kind, arguments.jobs, is_whole))

    arguments.folder.mkdir(parents=True, exist_ok=True)
    known = {key: verdict for key, verdict in known.items()
             if arguments.files and key.split(":")[0] not in arguments.files}
    known.update((key, killer or ("equivalent" if key in equivalents else "ALIVE"))
                 for key, killer in results.items())
    with open(table_path, "w", encoding="utf-8") as table:
        table.writelines(f"{key}\t{verdict}\n" for key, verdict in sorted(known.items()))

    wrong = 0
    for key in equivalents:
        is_known = key in results
        if (is_known and results[key]) or (not is_known and not arguments.files):
            wrong += 1
            print(f"called equivalent, but {'caught by ' + results[key] if is_known else 'gone'}:"
                  f" {key}")
    for mutant in mutants:
        if not results[mutant.key] and mutant.key not in equivalents:
            print(f"alive: line {mutant.line} of {mutant.key}")
    same = sum(1 for key, killer in results.items() if not killer and key in equivalents)
    caught = sum(1 for killer in results.values() if killer)
    share = caught / max(len(results) - same, 1)
    print(f"{len(results)} mutants, {same} of them equivalent; of the others {caught} caught, "
          f"{len(results) - same - caught} alive: {100.0 * share:.1f} %")
    return 0 if share >= LEAST_CAUGHT and not wrong else 1


if __name__ == "__main__":
    sys.exit(main())
