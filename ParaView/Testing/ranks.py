# SPDX-License-Identifier: BSD-3-Clause
"""Programs on several ranks of pvbatch, or by a client of a pvserver, and what their pictures differ in."""
import os
import re
import socket
import subprocess

import water_scene

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "ranks_program.py")
# a rank that waits leaves the processor to those that do not: by default it asks without end
MPIRUN = [os.environ["WATER_MPIRUN"], "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
LIMIT = 600  # seconds, for a hang; four ranks of a busy machine are slow
# without what says that this process is a rank already: pvpython is one of MPI's programs, too
ENVIRONMENT = {name: value for name, value in os.environ.items()
               if not name.startswith(("OMPI_", "PMIX_")) or name.startswith("OMPI_ALLOW_RUN_AS_ROOT")}


def run(command):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LIMIT,
                          check=False, env=ENVIRONMENT)
    if done.returncode != 0 or "the end" not in done.stdout:
        raise AssertionError("%s\n%s" % (" ".join(command), done.stdout))
    return done.stdout


def on_ranks(ranks, command):
    return command if ranks == 1 else MPIRUN + ["-np", str(ranks)] + command


def batch(ranks, name, *arguments, program=PROGRAM):
    """Runs a program by pvbatch on so many ranks. Returns what it says."""
    return run(on_ranks(ranks, [os.environ["WATER_PVBATCH"], "--force-offscreen-rendering", program, name,
                                *arguments]))


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


def server(ranks, client):
    """Runs a client of a pvserver of so many ranks; its arguments end with the port. Returns what both say."""
    port = free_port()
    said = water_scene.path("server-%d.txt" % port)
    with open(said, "w+", encoding="utf-8") as stream, \
            subprocess.Popen(on_ranks(ranks, [os.environ["WATER_PVSERVER"], "--force-offscreen-rendering",
                                              "--server-port=%d" % port]),
                             stdout=stream, stderr=subprocess.STDOUT, env=ENVIRONMENT) as served:
        try:
            wait_for(served, said)
            of_client = run([os.environ["WATER_PVPYTHON"], "--force-offscreen-rendering", *client, str(port)])
            if served.wait(60) != 0:
                raise AssertionError("pvserver ends with %d\n%s" % (served.returncode, read(said)))
            return of_client, read(said)
        finally:
            if served.poll() is None:
                served.terminate()
                served.wait(30)


def wait_for(served, said):
    """Until the server accepts a client."""
    import time
    for _ in range(600):
        if "Accepting connection" in read(said):
            return
        if served.poll() is not None:
            break
        time.sleep(0.1)
    raise AssertionError("pvserver does not start\n" + read(said))


def read(file):
    with open(file, encoding="utf-8") as stream:
        return stream.read()


def pixels(one, other):
    """How many pixels of two of the programs' pictures differ."""
    return water_scene.differing(water_scene.read(water_scene.path(one + ".png")),
                                 water_scene.read(water_scene.path(other + ".png")))


def rms(one, other):
    """The root mean square of the difference of two of the programs' pictures, of 255."""
    difference = (water_scene.read(water_scene.path(one + ".png")) - water_scene.read(water_scene.path(other + ".png")))
    return float((difference ** 2).mean() ** 0.5)


def counts(said, name):
    """The numbers that a line of the program's output gives."""
    return [int(number) for number in re.search(name + r":([ \d]+)", said).group(1).split()]
