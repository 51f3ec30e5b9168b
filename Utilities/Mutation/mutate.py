#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Changes signs and comparisons of the core, one at a time, and sees whether the unit tests notice.

Each mutant is compiled alone, linked with the unchanged rest into a shared library, and the tests,
built once, are run with that: those that include the file's header, the one of its own name first,
then those that caught most so far, then the shortest. Only tests that some mutant needs are built.
Mutants that survive are tried under the address and undefined behaviour sanitizers, as the preset
sanitize would run them, and then with all other tests. A test that never ends is known by the time
it computes, which no load on the machine lengthens. See script/mutation.
"""
import argparse
import collections
import concurrent.futures
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

from operators import mutants_of

PROJECT = pathlib.Path(__file__).resolve().parents[2]
CORE = PROJECT / "Module/Core"
TESTS = PROJECT / "Testing/Core"
HERE = pathlib.Path(__file__).resolve().parent
TABLE = "mutants.tsv"
LEAST_CAUGHT = 0.97  # the aim, for a run of all
LEAST_OF_SAMPLE = 0.97  # what holds today, less three standard deviations of 400; it only ever rises
LEAST_CPU_S = 1  # of a test that does not end; the longest takes 0.6 s

NO_END = ", without end"

CACHE = ["ccache"] if shutil.which("ccache") else []  # of the unchanged files and tests
COMMON = ["cc", "-std=c11", "-ffp-contract=off", "-fPIC", "-w"]
KINDS = {  # how the core and its tests are compiled
    "plain": ["-O0"],
    "sanitized": ["-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
}


def run(command, **more):
    """Runs a command; its exit status."""
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False, **more).returncode


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


def tests_for(name, tests, texts):
    """Which tests a mutant of a file is shown first: its own and those that include its header.

    A source without a header of its own implements the one that it includes first.
    """
    if not name.endswith((".c", ".h")):
        return tests  # a shader's text is asked for by several
    own = name.split(".")[0]
    if not any(CORE.glob(f"*/{own}.h")):
        source = next(CORE.glob(f"*/{name}"))
        own = re.search(r'#include "(\w+)\.h"', source.read_text()).group(1)
    return [noun for noun in tests if noun == own.replace("water_", "")
            or f'#include "{own}.h"' in (texts / f"test_{noun}.c").read_text()]


class Build:
    """The core as it is, with the tests of some files, or all, compiled in one of the KINDS."""

    def __init__(self, folder, kind, jobs, files=None):
        self.flags = KINDS[kind]
        self.core = folder / "core"
        self.bin = folder / "tests"
        self.texts = folder / "texts"  # of the tests, which may be edited while this runs
        shutil.rmtree(folder, ignore_errors=True)
        self.core.mkdir(parents=True)
        for path in [*CORE.glob("*/*.[ch]"), *CORE.glob("*/*.glsl")]:  # base names are unique
            shutil.copy(path, self.core)
        self.texts.mkdir()
        for path in TESTS.glob("*.[ch]"):
            shutil.copy(path, self.texts)
        self.bin.mkdir()
        self.sources = sorted(path.name for path in self.core.glob("*.c"))
        self.tests = sorted(path.stem[5:] for path in self.texts.glob("test_*.c")
                            if path.stem != "test_header")
        if files is not None:
            needed = {noun for name in files
                      for noun in tests_for(name, self.tests, self.texts)}
            self.tests = [noun for noun in self.tests if noun in needed]
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(must, [CACHE + self.compile(self.core, name) for name in self.sources]))
            must(self.link(self.core))
            list(pool.map(must, [self.build_test(self.core, noun, self.bin)
                                 for noun in self.tests]))
        self.seconds = {}
        for noun in self.tests:
            began = time.monotonic()
            if self.catch(self.core, self.bin / noun, 100):
                sys.exit(f"without any mutant test_{noun} fails ({kind})")
            self.seconds[noun] = time.monotonic() - began
        self.most_cpu_s = LEAST_CPU_S + math.ceil(4 * max(self.seconds.values(), default=0))

    def compile(self, core, name):
        return [*COMMON, *self.flags, "-c", core / name, "-o", core / (name + ".o")]

    def link(self, core):
        objects = [core / (name + ".o") for name in self.sources]
        return ["cc", *self.flags, "-shared", *objects, "-lm", "-o", core / "libwater_core.so"]

    def build_test(self, core, noun, folder):
        return [*COMMON, *self.flags, "-I", core,
                self.texts / f"test_{noun}.c", "-o", folder / noun, "-L", core, "-lwater_core",
                "-lcmocka", "-lm"]

    def catch(self, core, program, most_cpu_s=None):
        """What a test says of the library of a folder: nothing when it passes."""
        environment = dict(os.environ, LD_LIBRARY_PATH=str(core), ASAN_OPTIONS="detect_leaks=0")
        status = run(["prlimit", f"--cpu={most_cpu_s or self.most_cpu_s}", program],
                     env=environment)
        if status == -signal.SIGKILL:
            return program.name + NO_END
        return program.name if status else None


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
        if not name.endswith(".c"):
            sources = including(name, self.core) & set(self.build.sources)
        return all(run(self.build.compile(self.core, source)) == 0 for source in sources)

    def _judge(self, name, order):
        programs = {noun: self.build.bin / noun for noun in self.build.tests}
        if name.endswith(".h"):
            # functions in headers are in the tests themselves: most need no other core to fail
            tests = [noun for noun in order
                     if f"test_{noun}.c" in including(name, self.build.texts, self.core)]
            for noun in tests:
                programs[noun] = self.bin / noun
                if run(self.build.build_test(self.core, noun, self.bin)):
                    return "compiler"
                catch = self.build.catch(self.core, programs[noun])
                if catch:
                    return catch
        self.changed = name
        if not self._compile(name) or run(self.build.link(self.core)):
            return "compiler"
        catches = (self.build.catch(self.core, programs[noun]) for noun in order)
        return next((catch for catch in catches if catch), None)

    def killer(self, mutant, order):
        """The first test that fails with a mutant, "compiler", or None: it survives."""
        if self.changed is not None and not (
                self.changed == mutant.file and mutant.file.endswith(".c")):
            if not self._compile(self.changed) or run(self.build.link(self.core)):
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

    def __init__(self, folder, kind, jobs, files):
        self.is_whole = files is None
        self.folder = folder / kind
        self.build = Build(self.folder / "original", kind, jobs, files)
        self.local = threading.local()
        self.kills = collections.Counter()

    def judge(self, mutant):
        if not hasattr(self.local, "bench"):
            self.local.bench = Bench(self.folder / threading.current_thread().name, self.build)
        own = mutant.file.split(".")[0].replace("water_", "")
        nouns = tests_for(mutant.file, self.build.tests, self.build.texts)
        if self.is_whole:  # those have been asked before
            nouns = [noun for noun in self.build.tests if noun not in nouns]
        order = sorted(nouns, key=lambda noun: (noun != own, -self.kills[mutant.file, noun],
                                                self.build.seconds[noun]))
        killer = self.local.bench.killer(mutant, order)
        if killer:
            self.kills[mutant.file, killer.removesuffix(NO_END)] += 1
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


def judged(mutants, folder, kind, jobs, how="", is_whole=False):
    """(mutant, killer and how) of each, in order; progress to stderr. is_whole: by all other tests.

    What is caught goes to the table at once, so that --again can take up a run that was ended.
    """
    if not mutants:
        return []
    judge = Judge(folder, kind, jobs, None if is_whole else {mutant.file for mutant in mutants})
    killers = []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for number, killer in enumerate(pool.map(judge.judge, mutants), 1):
            killers.append(killer + how if killer else None)
            if killer:
                with open(folder / TABLE, "a", encoding="utf-8") as table:
                    table.write(f"{mutants[number - 1].key}\t{killers[-1]}\n")
            else:
                print(f"{kind}: alive: {mutants[number - 1].key}", file=sys.stderr)
            if number % 50 == 0 or number == len(mutants):
                print(f"{kind}: {number} of {len(mutants)}, {killers.count(None)} alive",
                      file=sys.stderr, flush=True)
    return list(zip(mutants, killers))


def interval(share, count):
    """Ends of the 95 % confidence interval of a share.

    Source: Wilson 1927, "Probable Inference, the Law of Succession, and Statistical Inference".
    """
    z = 1.96
    middle = share + z * z / (2 * count)
    half = z * math.sqrt(share * (1 - share) / count + z * z / (4 * count * count))
    return tuple((middle + sign * half) / (1 + z * z / count) for sign in (-1, 1))


def write_table(path, verdicts):
    with open(path, "w", encoding="utf-8") as table:
        table.writelines(f"{key}\t{verdict}\n" for key, verdict in sorted(verdicts.items()))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="*", help="of Module/Core; without any: all")
    parser.add_argument("--folder", type=pathlib.Path, default=PROJECT / "build/mutation")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--again", action="store_true",
                        help="believe the last run's table, ended or not, what was caught; only try the"
                             " rest")
    parser.add_argument("--sample", type=int, metavar="COUNT",
                        help="only so many mutants, chosen at random")
    parser.add_argument("--seed", type=int, default=1, help="of --sample")
    parser.add_argument("--check", action="store_true",
                        help="only see whether the list of equivalent mutants names mutants; takes a second")
    arguments = parser.parse_args()

    paths = sorted(path for path in [*CORE.glob("*/*.[ch]"), *CORE.glob("*/*.glsl")]
                   if not arguments.files or path.name in arguments.files)
    mutants = [mutant for path in paths for mutant in mutants_of(path.name, path.read_text())]
    equivalents = read_equivalents()
    # before an hour's work
    keys = {mutant.key for mutant in mutants}
    gone = [key for key in equivalents
            if key not in keys and (not arguments.files or key.split(":")[0] in arguments.files)]
    for key in gone:
        print(f"called equivalent, but gone: {key}")
    if gone or arguments.check:
        print(f"{len(mutants)} mutants, {len(gone)} of {len(equivalents)} called equivalent are gone")
        return 1 if gone else 0
    is_part = bool(arguments.files)  # the table has other mutants, too
    if arguments.sample and arguments.sample < len(mutants):
        is_part = True
        chosen = random.Random(arguments.seed).sample(range(len(mutants)), arguments.sample)
        mutants = [mutants[number] for number in sorted(chosen)]
        keys = {mutant.key for mutant in mutants}
    def is_kept(key):
        """Whether a verdict of the last run is of a mutant that this one does not try."""
        return is_part and key not in keys and (
            arguments.sample is not None or key.split(":")[0] not in arguments.files)

    table_path = arguments.folder / TABLE
    known = {}  # of all files
    if table_path.exists():
        known = dict(line.split("\t") for line in table_path.read_text().splitlines())
    last = {}
    if arguments.again:
        last = {key: verdict for key, verdict in known.items()
                if verdict not in ("equivalent", "ALIVE")}
    else:
        known = {key: verdict for key, verdict in known.items() if is_kept(key)}
        arguments.folder.mkdir(parents=True, exist_ok=True)
        write_table(table_path, known)
    results = {mutant.key: last.get(mutant.key) for mutant in mutants}
    results.update((mutant.key, killer) for mutant, killer in judged(
        [mutant for mutant in mutants if mutant.key not in last],
        arguments.folder, "plain", arguments.jobs))
    # all other tests come last: they take half a minute for a mutant, and catch few
    for kind, is_whole, how in (("sanitized", False, " under the sanitizers"), ("plain", True, "")):
        alive = [mutant for mutant in mutants
                 if not results[mutant.key] and mutant.key not in equivalents]
        results.update((mutant.key, killer) for mutant, killer in
                       judged(alive, arguments.folder, kind, arguments.jobs, how, is_whole))

    known = {key: verdict for key, verdict in known.items() if is_kept(key)}
    known.update((key, killer or ("equivalent" if key in equivalents else "ALIVE"))
                 for key, killer in results.items())
    write_table(table_path, known)

    wrong = 0
    for key in equivalents:
        if results.get(key):
            wrong += 1
            print(f"called equivalent, but caught by {results[key]}: {key}")
    for mutant in mutants:
        if not results[mutant.key] and mutant.key not in equivalents:
            print(f"alive: line {mutant.line} of {mutant.key}")
    same = sum(1 for key, killer in results.items() if not killer and key in equivalents)
    caught = sum(1 for killer in results.values() if killer)
    share = caught / max(len(results) - same, 1)
    print(f"{len(results)} mutants, {same} of them equivalent; of the others {caught} caught, "
          f"{len(results) - same - caught} alive: {100.0 * share:.1f} %")
    if arguments.sample and len(results) > same:
        low, high = interval(share, len(results) - same)
        print(f"of all mutants {100.0 * low:.1f} to {100.0 * high:.1f} %, with 95 % confidence "
              f"(seed {arguments.seed})")
    least = LEAST_OF_SAMPLE if arguments.sample else LEAST_CAUGHT
    return 0 if share >= least and not wrong else 1


if __name__ == "__main__":
    sys.exit(main())
