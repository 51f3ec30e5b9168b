# SPDX-License-Identifier: BSD-3-Clause
"""three_chromium: three.js in headless Chromium, as a peer: serves its page, passes the lines on.

    three_chromium.py SCENE FOLDER    FOLDER has node_modules/three, and gets Chromium's profile

Chromium is given the GL of Mesa (llvmpipe), which the other peers have, and where that does not
start its own (SwiftShader). "renderer" in the first answer says which it is.
"""

import base64
import functools
import http.server
import json
import os
import pathlib
import queue
import signal
import subprocess
import sys
import tempfile
import threading

from peer import answer

PAGES = pathlib.Path(__file__).parent
CHROMIUM = "chromium"
START_S, ANSWER_S = 60.0, 40.0  # less than compare.py waits: it would leave the browser behind
# the flags of each GL, best first
GLS = {
    "Mesa": ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"],
    "SwiftShader": ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
}
FLAGS = [
    "--no-sandbox",  # root has none
    "--headless=new", "--no-first-run", "--disable-extensions", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--disable-gpu-watchdog", "--hide-scrollbars",
    "--disable-background-timer-throttling", "--disable-renderer-backgrounding",
    "--disable-backgrounding-occluded-windows", "--force-device-scale-factor=1",
]


class Handler(http.server.SimpleHTTPRequestHandler):
    """Files from the two folders, and the two queues."""

    def __init__(self, *rest, folder, orders, answers):
        self._orders, self._answers = orders, answers
        super().__init__(*rest, directory=str(folder))

    def translate_path(self, path):
        page = PAGES / path.lstrip("/")
        is_page = page.parent == PAGES and page.is_file()
        return str(page) if is_page else super().translate_path(path)

    def do_GET(self):
        if self.path != "/next":
            super().do_GET()
            return
        try:
            order = self._orders.get(timeout=20.0).encode()
        except queue.Empty:
            order = b""
        self.send_response(200 if order else 204)
        self.send_header("Content-Length", str(len(order)))
        self.end_headers()
        self.wfile.write(order)

    def do_POST(self):
        self._answers.put(self.rfile.read(int(self.headers["Content-Length"])).decode())
        self.send_response(204)
        self.end_headers()

    def log_message(self, *_):
        pass


class Browser:
    def __init__(self, flags, address, profile):
        self.process = subprocess.Popen(
            [CHROMIUM, *FLAGS, *flags, f"--user-data-dir={profile}", address],
            stdout=sys.stderr, stderr=sys.stderr, start_new_session=True)

    def end(self):
        """With all processes of its own."""
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGTERM)
            try:
                self.process.wait(10.0)
            except subprocess.TimeoutExpired:
                os.killpg(self.process.pid, signal.SIGKILL)


def started(address, answers, profiles):
    """A browser and its first answer, with the first GL that works."""
    for name, flags in GLS.items():
        browser = Browser(flags, address, pathlib.Path(profiles) / name)
        try:
            text = answers.get(timeout=START_S)
            if not text.startswith("error"):
                return browser, json.loads(text)
            print(f"three_chromium: {name}: {text}", file=sys.stderr, flush=True)
        except queue.Empty:
            print(f"three_chromium: {name}: no answer", file=sys.stderr, flush=True)
        browser.end()
    raise SystemExit("three_chromium: no GL works")


def main():
    folder = pathlib.Path(sys.argv[2])
    orders, answers = queue.Queue(), queue.Queue()
    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Handler, folder=folder, orders=orders, answers=answers))
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profiles:
        address = f"http://127.0.0.1:{server.server_port}/three_water.html"
        browser, about = started(address, answers, profiles)
        try:
            version = subprocess.run([CHROMIUM, "--version"], capture_output=True, text=True)
            about["program"] += f", {' '.join(version.stdout.split()[:2])}"
            answer(json.dumps(about))
            for line in sys.stdin:
                orders.put(line.strip())
                text = answers.get(timeout=ANSWER_S)
                if text.startswith("data:"):
                    picture = base64.b64decode(text.split(",", 1)[1])
                    pathlib.Path(line.split()[8]).write_bytes(picture)
                    text = "done"
                answer(text)
        finally:
            browser.end()


if __name__ == "__main__":
    main()
