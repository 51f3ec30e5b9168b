#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""stage: makes the folder of pages from which Sphinx builds the site.

usage: stage.py FOLDER

The texts stay where they are in the project. Here they get their place in the site, and their links lead to pages of
the site: the README becomes one page for each of its sections, the gallery one for each example, and each file that a
page links to is shown with its code.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
SITE = "Documentation/site"
# section of the README -> page; the first of a page gives its title
README_PAGES = {"Install": "install", "Tested versions and performance": "install", "Licence": "install",
                "PyVista": "start/pyvista", "Python": "start/python", "C++": "start/cxx", "Command line": "start/command",
                "How it works": "concepts", "Source tree": "concepts"}
README_LEFT_OUT = {"Documentation"}  # the site's own contents
WHOLE_PROGRAMS = {"start/pyvista": "Examples/Python/pyvista_water.py",
                  "start/python": "Examples/Python/first_water.py",
                  "start/cxx": "Examples/Cxx/FirstWater/FirstWater.cxx"}
PAGES = {"CONTRIBUTING.md": "contributing", "CODE_OF_CONDUCT.md": "conduct", "CHANGELOG.md": "changelog",
         "Documentation/gallery.md": "gallery/index",
         "Documentation/decisions/README.md": "decisions/index", f"{SITE}/start_c.md": "start/c",
         "ParaView/README.md": "start/paraview",
         f"{SITE}/index.md": "index"}
LANGUAGES = {".py": "python", ".c": "c", ".h": "c++", ".cxx": "c++", ".glsl": "glsl", ".cmake": "cmake",
             ".json": "json", ".sh": "bash", ".txt": "cmake"}
THUMBNAIL = (480, 300)
ENTRY = (r"^!\[([^\]]*)\]\(images/([^)]+)\)\n\n"  # a picture of the gallery; its script, arguments and text
         r"\*\[([^\]]+)\]\(\.\./([^)]+)\)(.*?)\*: (.+?)\n(?=\n|\Z)")
VTK_PAGE = "https://vtk.org/doc/nightly/html/class{}.html"


def slug(title):
    """GitHub's anchor of a heading."""
    return re.sub(r"[^\w\- ]", "", title.strip().lower()).replace(" ", "-")


def all_pages():
    pages = dict(PAGES)
    for path in sorted(ROOT.glob("Documentation/*.md")):
        pages.setdefault(f"Documentation/{path.name}", path.stem)
    for path in sorted(ROOT.glob("Documentation/decisions/*.md")):
        pages.setdefault(f"Documentation/decisions/{path.name}", f"decisions/{path.stem}")
    return pages


def sections(text):
    """The title and the text of each section of level 2."""
    parts = re.split(r"^## (.+)\n", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))


class Stage:
    """The folder of pages. Files that a page links to are shown as pages, too."""

    def __init__(self, folder):
        self.folder = folder
        self.pages = all_pages()
        self.readme_anchors = {}
        self.shown = set()

    def write(self, page, text):
        path = self.folder / f"{page}.md"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def address(self, target, source):
        """The place in the site to which a link of a file leads. Raises ValueError if there is none."""
        if re.match(r"[a-z]+:|#", target) or target.startswith("../cxx/"):
            return target
        path, _, anchor = target.partition("#")
        base = ROOT if path.startswith("/") else (ROOT / source).parent
        full = Path(os.path.normpath(base / path.lstrip("/")))
        if not full.exists() or not full.is_relative_to(ROOT):
            raise ValueError(f"{source}: link to {target}, which is not there")
        name = full.relative_to(ROOT).as_posix()
        if name == "README.md":
            if anchor and anchor not in self.readme_anchors:
                raise ValueError(f"{source}: README.md has no section #{anchor}")
            return f"/{self.readme_anchors.get(anchor, 'index.md')}" + (f"#{anchor}" if anchor else "")
        if name.startswith("Documentation/images/"):
            return f"/{name.removeprefix('Documentation/')}"
        page = self.pages.get(name) or self.show(name)
        return f"/{page}.md" + (f"#{anchor}" if anchor else "")

    def moved(self, text, source):
        """The text of a file with the addresses that its links and pictures have in the site; code stays."""
        parts = re.split(r"(^(```|~~~).*?^\2\s*$)", text, flags=re.MULTILINE | re.DOTALL)
        for i in range(0, len(parts), 3):
            parts[i] = re.sub(r"(\]\()([^)\s]+)(\))",
                              lambda link: link[1] + self.address(link[2], source) + link[3], parts[i])
            parts[i] = re.sub(r"^(:link: )(\S+)$", lambda link: link[1] + self.card(link[2], source), parts[i],
                              flags=re.MULTILINE)
            parts[i] = re.sub(r"^<!-- code: (\S+) -->$", lambda code: self.code(code[1]), parts[i],
                              flags=re.MULTILINE)
        for i in range(1, len(parts), 3):
            parts[i] = re.sub(r"^(```\{image\} )(\S+)", lambda image: image[1] + self.address(image[2], source),
                              parts[i])
        return "".join(part for i, part in enumerate(parts) if i % 3 != 2)

    def card(self, target, source):
        """A card's link: to a document, or to a heading, as HTML has it."""
        page, _, anchor = self.address(target, source).lstrip("/").partition("#")
        return page.removesuffix(".md") + ".html" + (f"#{anchor}" if anchor else "")

    def code(self, name):
        text = (ROOT / name).read_text()
        return f"`````{LANGUAGES.get(Path(name).suffix, 'text')}\n{text}`````\n"

    def show(self, name):
        """The page of a file or folder of the project; made when it is first linked to."""
        page = f"files/{name}"
        if name in self.shown:
            return page
        self.shown.add(name)
        path = ROOT / name
        if path.is_dir():
            files = [file for file in sorted(path.iterdir()) if file.is_file()]
            text = f"# {name}\n\n" + "".join(f"- [{file.name}](/{self.show(f'{name}/{file.name}')}.md)\n"
                                             for file in files)
        elif path.suffix == ".md":
            text = self.moved(path.read_text(), name)
        else:
            text = f"# {name}\n\n{self.code(name)}"
        self.write(page, f"---\norphan: true\n---\n{text}")
        return page

    def stage_readme(self):
        found = sections((ROOT / "README.md").read_text())
        unknown = set(found) - set(README_PAGES) - README_LEFT_OUT
        if unknown:
            raise ValueError(f"README.md: no page of the site has its sections {', '.join(sorted(unknown))}; "
                             "Utilities/Site/stage.py lists the pages")
        for title, page in README_PAGES.items():
            for name in [title, *re.findall(r"^#{3,} (.+)$", found[title], flags=re.MULTILINE)]:
                self.readme_anchors[slug(name)] = f"{page}.md"
        self.readme_anchors[slug("Documentation")] = "index.md"
        texts = {}
        for title, page in README_PAGES.items():
            level = "##" if page in texts else "#"
            texts[page] = texts.get(page, "") + f"{level} {title}\n{found[title]}\n"
        return texts

    def stage_gallery(self):
        """A card for each picture of the gallery, and a page with its code."""
        source = "Documentation/gallery.md"
        text = (ROOT / source).read_text()
        entries = re.findall(ENTRY, text, flags=re.MULTILINE | re.DOTALL)
        if len(entries) != text.count("![") or not entries:
            raise ValueError(f"{source}: {text.count('![')} pictures, but {len(entries)} entries of the usual form")
        (self.folder / "images/thumbnails").mkdir(parents=True)
        cards, names = "", []
        for title, image, script, path, arguments, about in entries:
            name = Path(image).stem
            names.append(name)
            with Image.open(ROOT / "Documentation/images" / image) as picture:
                picture = picture.convert("RGB")
                picture.thumbnail(THUMBNAIL)
                picture.save(self.folder / f"images/thumbnails/{name}.jpg", quality=85)
            cards += (f":::{{grid-item-card}} {name.replace('_', ' ')}\n:img-top: /images/thumbnails/{name}.jpg\n"
                      f":link: {name}\n:link-type: doc\n{title}\n:::\n")
            code = (ROOT / path).read_text()
            command = f"python {path} {arguments.strip(' `')}".strip()
            self.write(f"gallery/{name}", f"# {name.replace('_', ' ').capitalize()}\n\n![{title}](/images/{image})\n\n"
                       f"{self.moved(about, source)}\n\n```sh\n{command}\n```\n\n{self.code(path)}\n"
                       f"{classes_of(code)}\n")
        self.write("gallery/index", "# Gallery\n\n"
                   "Each picture is rendered by one script. Click a picture for its code.\n\n"
                   f"::::{{grid}} 1 2 3 3\n:gutter: 3\n\n{cards}::::\n\n```{{toctree}}\n:hidden:\n\n"
                   + "\n".join(names) + "\n```\n")

    def stage_api(self):
        shutil.copy(ROOT / SITE / "python.rst", self.folder / "python.rst")
        (self.folder / "api/classes").mkdir(parents=True)
        (self.folder / "python.rst").rename(self.folder / "api/python.rst")
        rows = ""
        for header in sorted((ROOT / "Module").glob("vtkWater*.h")):
            brief = re.search(r"@brief\s+(.+?)\n \*\n", header.read_text(), flags=re.DOTALL)
            page = f"class{header.stem}.html" if brief else "vtkWaterC_8h.html"
            about = re.sub(r"\s*\n \*\s*", " ", brief[1]) if brief else "the interface for C and other languages"
            rows += f'| <a href="../cxx/{page}">{header.stem}</a> | {about} |\n'
        self.write("api/index", "# C++ and C\n\n| | |\n|---|---|\n" + rows
                   + '| <a href="../cxx/files.html">water_*.h</a> | the core in C: formulas and decisions |\n\n'
                   'The <a href="../cxx/index.html">Doxygen pages</a> have all classes, functions and files, with '
                   "their own search. Classes of VTK link to VTK's documentation.\n")
        text = "# The command\n\nMade from `--help`.\n"
        for words in ([], ["render"], ["animate"], ["view"], ["info"]):
            run = subprocess.run([sys.executable, "-m", "vtkwater", *words, "--help"], capture_output=True, text=True,
                                 env=dict(os.environ, COLUMNS="110"), check=False)
            if run.returncode == 0:
                text += f"\n## {' '.join(['vtkwater', *words])}\n\n```text\n{run.stdout}```\n"
            elif "invalid choice" not in run.stderr:
                raise ValueError(f"vtkwater {' '.join(words)} --help: {run.stderr}")
        self.write("api/command", text)

    def stage(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(ROOT / "Documentation/images", self.folder / "images")
        for name in ("conf.py", "style.css"):
            shutil.copy(ROOT / SITE / name, self.folder / name)
        readme = self.stage_readme()  # first: it knows where its sections are
        for page, text in readme.items():
            text = self.moved(text, "README.md")
            if page in WHOLE_PROGRAMS:
                text += f"\n## The whole program\n\n{self.code(WHOLE_PROGRAMS[page])}"
            self.write(page, text)
        self.stage_gallery()
        for source, page in self.pages.items():
            if page != "gallery/index":
                self.write(page, self.moved((ROOT / source).read_text(), source) + self.tree_of(page))
        self.stage_api()

    def tree_of(self, page):
        return "\n```{toctree}\n:hidden:\n:glob:\n\n*\n```\n" if page == "decisions/index" else ""


def classes_of(code):
    """The classes of a script, with links to their documentation."""
    names = sorted(set(re.findall(r"\bvtk[A-Z]\w+", code)) - {"vtkModules"})
    ours = [f'<a href="../cxx/class{name}.html">{name}</a>' for name in names
            if (ROOT / f"Module/{name}.h").exists()]
    theirs = [f"[{name}]({VTK_PAGE.format(name)})" for name in names if not name.startswith("vtkWater")
              and not re.match(r"vtk(Common|Filters|Rendering|IO|Interaction|Imaging|Charts|Views)[A-Z]", name)]
    return f"Classes: {', '.join(ours + theirs)}\n" if names else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path)
    stage = Stage(parser.parse_args().folder.resolve())
    try:
        stage.stage()
    except ValueError as error:
        sys.exit(f"stage: {error}")
    print(f"stage: {len(list(stage.folder.rglob('*.md')))} pages, {len(stage.shown)} of them files of the project")


if __name__ == "__main__":
    main()
