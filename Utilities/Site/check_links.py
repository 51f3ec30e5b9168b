#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_links: finds links and pictures of the built site that lead nowhere.

usage: check_links.py FOLDER
       check_links.py --self-test

Reads every HTML page below FOLDER. A link to another page of the site, to a picture or to an anchor must lead to
something. Links to other sites are counted, not followed. Exit status 1: something is missing.
"""
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        for name in ("id", "name"):
            if attributes.get(name):
                self.anchors.add(attributes[name])
        for name in ("href", "src"):
            if attributes.get(name):
                self.links.append(attributes[name])


def missing_links(folder):
    """Lines `page: link`, and the numbers of links inside and outside."""
    pages = {path: Page(path.read_text(errors="replace")) for path in folder.rglob("*.html")}
    found, inside, outside = [], 0, 0
    for path, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                outside += 1
                continue
            inside += 1
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target /= "index.html"
            anchor = unquote(parts.fragment)
            is_there = target.is_file() and target.is_relative_to(folder)
            is_scripted = "cxx" in target.parts  # Doxygen's pages make some anchors by script
            if is_there and anchor and target in pages and not is_scripted:
                is_there = anchor in pages[target].anchors
            if not is_there:
                found.append(f"{path.relative_to(folder)}: {link}")
    return found, inside, outside


def self_test():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        (folder / "a").mkdir()
        (folder / "index.html").write_text(
            '<h1 id="top">x</h1><a href="a/page.html#here">good</a><a href="#top">good</a>'
            '<a href="a/page.html#there">bad</a><img src="gone.png"><a href="#no">bad</a>'
            '<a href="https://example.org/gone">other</a><a href="a/none.html">bad</a>')
        (folder / "a/page.html").write_text('<p id="here"><a href="../index.html">good</a>')
        found, inside, outside = missing_links(folder)
    expected = [f"index.html: {link}" for link in ("a/page.html#there", "gone.png", "#no", "a/none.html")]
    print("\n".join(found))
    if (found, inside, outside) != (expected, 7, 1):
        sys.exit(f"check_links: found {found}, {inside}, {outside}")
    print("check_links: all planted links were found")


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        sys.exit(__doc__.strip())
    found, inside, outside = missing_links(Path(sys.argv[1]).resolve())
    print("\n".join(sorted(set(found))))
    print(f"check_links: {inside} links inside the site, {len(found)} of them broken; "
          f"{outside} to other sites, not followed")
    return 1 if found or not inside else 0


if __name__ == "__main__":
    sys.exit(main())
