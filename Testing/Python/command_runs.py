# SPDX-License-Identifier: BSD-3-Clause
"""command_runs: runs `python -m vtkwater` many times. Each run is a process of its own, forked from one that has
imported what the command imports and has opened no window: a run saves the third of a second that imports take."""

import atexit
import gc
import json
import os
import runpy
import subprocess
import sys
import tempfile
from pathlib import Path


class Commands:
    """The process from which runs are forked. It ends with this one."""

    def __init__(self):
        self.process = subprocess.Popen([sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True)
        atexit.register(self.close)

    def close(self):
        self.process.stdin.close()
        self.process.wait(timeout=60)

    def run(self, folder, *arguments):
        """Exit status and all that was said."""
        status, out, err = self.run_apart(folder, *arguments)
        return status, out + err

    def run_apart(self, folder, *arguments):
        """Exit status, what was said on stdout, and on stderr."""
        with tempfile.TemporaryDirectory() as texts:
            said = [str(Path(texts) / name) for name in ("out", "err")]
            print(json.dumps([str(folder), said, [str(argument) for argument in arguments]]), file=self.process.stdin,
                  flush=True)
            status = json.loads(self.process.stdout.readline())
            return status, *(Path(text).read_text() for text in said)


def become(folder, said, arguments):
    """Is the command from here on, as a process that was started for it: its folder, output and arguments."""
    os.chdir(folder)
    for number, text in enumerate(said, 1):
        file = os.open(text, os.O_WRONLY | os.O_CREAT)
        os.dup2(file, number)
        os.close(file)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    sys.argv = ["vtkwater", *arguments]
    runpy.run_module("vtkwater", run_name="__main__", alter_sys=True)


def serve():
    import PIL.Image  # noqa: F401  what a run would import
    import vtkwater.command  # noqa: F401
    import vtkwater.scenes  # noqa: F401
    gc.freeze()  # the ends of runs need not visit what is there before them
    answers = os.fdopen(os.dup(1), "w")
    for line in iter(sys.stdin.readline, ""):
        child = os.fork()
        if child == 0:
            return become(*json.loads(line))
        code = os.waitpid(child, 0)[1]
        print(-os.WTERMSIG(code) if os.WIFSIGNALED(code) else os.WEXITSTATUS(code), file=answers, flush=True)


if __name__ == "__main__":
    serve()
