# SPDX-License-Identifier: BSD-3-Clause
"""workers: the peers as processes, and the lines exchanged with them (peer.py has their form)."""

import json
import os
import queue
import subprocess
import threading

START_S = 150.0
ANSWER_S = 60.0

# The frames' memory stays with the process, as in BenchmarkLookup.cxx: returning it costs time.
ENVIRONMENT = {"MALLOC_TRIM_THRESHOLD_": "1073741824", "MALLOC_MMAP_THRESHOLD_": "1073741824",
               "PYTHONDONTWRITEBYTECODE": "1"}


class PeerFailed(Exception):
    """A peer that cannot be measured, and why."""


class Worker:
    """A running peer. variants: names, the one without water first; program, renderer: what it is.
    """

    def __init__(self, name, command, log):
        self.name = name
        self._log = log
        with open(log, "w") as errors:
            try:
                self._process = subprocess.Popen(
                    command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors,
                    text=True, env={**os.environ, **ENVIRONMENT})
            except OSError as error:
                raise PeerFailed(f"does not start: {error.strerror}") from None
        self._answers = queue.Queue()
        threading.Thread(target=self._listen, daemon=True).start()

    def wait(self):
        about = json.loads(self._answer(START_S))
        self.variants, self.program = about["variants"], about["program"]
        self.renderer = about["renderer"]

    def frame(self, variant, camera):
        """Milliseconds of one frame."""
        return float(self._ask("frame", variant, camera))

    def picture(self, variant, camera, file):
        self._ask("picture", variant, camera, str(file))

    def end(self):
        try:
            self._process.stdin.close()
            self._process.wait(20.0)
        except (OSError, subprocess.TimeoutExpired):
            self._process.kill()

    def _ask(self, what, variant, camera, *rest):
        numbers = [f"{value:.4f}" for place in camera for value in place]
        try:
            self._process.stdin.write(" ".join([what, variant, *numbers, *rest]) + "\n")
            self._process.stdin.flush()
        except OSError:
            pass  # it has ended, which the answer says
        return self._answer(ANSWER_S)

    def _listen(self):
        """Answers begin with "> "; programs print other things as well."""
        for line in self._process.stdout:
            if line.startswith("> "):
                self._answers.put(line[2:].strip())
        self._answers.put(None)

    def _answer(self, seconds):
        try:
            text = self._answers.get(timeout=seconds)
        except queue.Empty:
            raise PeerFailed(f"no answer for {seconds:g} s") from None
        if text is None or text.startswith("error"):
            raise PeerFailed(text or self._last_words())
        return text

    def _last_words(self):
        with open(self._log, errors="replace") as log:
            lines = [line.strip() for line in log if line.strip()]
        return f"ended: {lines[-1] if lines else 'without a word'}"[:200]
