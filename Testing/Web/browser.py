# SPDX-License-Identifier: BSD-3-Clause
"""browser: pages in headless Chromium, for tests that want to see what a person sees.

    with Browser(folder) as browser:
        png = browser.picture("http://localhost:8080/", wait_s=5.0, script="document.title = 'x'")

Speaks Chromium's DevTools protocol over aiohttp, which trame brings.
"""
import asyncio
import base64
import json
import pathlib
import subprocess
import time
import urllib.request

import aiohttp

CHROMIUM = "chromium"
START_S = 30.0
FLAGS = [
    "--no-sandbox",  # root has none
    "--headless=new", "--no-first-run", "--disable-extensions", "--disable-background-networking", "--disable-gpu",
    "--hide-scrollbars", "--remote-debugging-port=0", "--window-size=1000,700", "--force-device-scale-factor=1",
]


class Browser:
    def __init__(self, folder):
        self._profile = pathlib.Path(folder) / "profile"
        (self._profile / "DevToolsActivePort").unlink(missing_ok=True)

    def __enter__(self):
        self._process = subprocess.Popen(
            [CHROMIUM, *FLAGS, f"--user-data-dir={self._profile}", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + START_S
        port_file = self._profile / "DevToolsActivePort"
        while not port_file.is_file() or not port_file.read_text().strip():
            if time.monotonic() > end or self._process.poll() is not None:
                self.__exit__()
                raise RuntimeError(f"{CHROMIUM} does not start")
            time.sleep(0.1)
        port = port_file.read_text().split()[0]
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/json") as answer:
            pages = json.load(answer)
        self._address = next(page["webSocketDebuggerUrl"] for page in pages if page["type"] == "page")
        return self

    def __exit__(self, *_):
        self._process.terminate()
        try:
            self._process.wait(timeout=10.0)
        except subprocess.TimeoutExpired:
            self._process.kill()

    def picture(self, address, wait_s, script=""):
        """PNG of a page, wait_s after it began to load; a script, if any, runs half way."""
        return asyncio.run(self._picture(address, wait_s, script))

    async def _picture(self, address, wait_s, script):
        async with aiohttp.ClientSession() as session, session.ws_connect(self._address, max_msg_size=0) as page:
            number = 0

            async def call(method, **parameters):
                nonlocal number
                number += 1
                await page.send_json({"id": number, "method": method, "params": parameters})
                while True:
                    answer = await page.receive_json()
                    if answer.get("id") == number:
                        return answer["result"]

            await call("Page.navigate", url=address)
            await asyncio.sleep(wait_s)
            if script:
                await call("Runtime.evaluate", expression=script)
                await asyncio.sleep(wait_s)
            return base64.b64decode((await call("Page.captureScreenshot"))["data"])
