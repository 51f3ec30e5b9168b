#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Finds phrases to avoid in the public texts, with GNU diction and the list in phrases.tsv.

usage: check_prose.py [--self-test] [FILE...]

Without files it reads the Markdown pages, their templates and the README of each folder, the comments of the public
headers (of the classes and the core), the docstrings, messages and --help of the Python package, and the comments and
messages of the scripts. Code is left out. It also finds lines of over 240 characters in the Markdown pages, except in
tables and code. Prints `file:line: sentence [phrase -> replacement]` and ends with 1 if it finds any. --self-test: checks that a
bad sentence is found in each kind of file, and not in code.
"""
import ast
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PHRASES = Path(__file__).with_name("phrases.tsv")
TEXTS = ("*.md", "Documentation/*.md", "Documentation/decisions/*.md", "Documentation/site/*.md",
         "Utilities/**/*.md.in", "Module/**/README.md", "Examples/**/README.md", "Utilities/**/README.md",
         "Module/vtkWater*.h", "Module/Core/*/*.h", "Module/Python/*.py", "Module/Python/*.py.in", "ParaView/**/*.md",
         "script/*")
LONGEST_LINE = 240  # of a paragraph: longer ones cannot be compared, or commented on, in a diff
CODE = "Code"  # replaces code in a sentence


def database():
    """The phrases in diction's format: a leading blank stands for the beginning of a word."""
    lines = PHRASES.read_text().splitlines()
    return "".join(f" {line}\n" for line in lines if line and not line.startswith("#"))


def markdown(text):
    """Paragraphs, list items and table cells, each with its first line; code, links and HTML are left out."""
    is_code, block, first = False, [], 0
    for number, line in enumerate([*text.splitlines(), ""], 1):
        if line.lstrip().startswith("```"):
            is_code = not is_code
            line = ""
        elif is_code or line.startswith("    "):
            line = ""
        begins = re.match(r"\s*([-*]|\d+\.)\s|#|\||!?\[|<!--", line)
        if block and (not line.strip() or begins):
            yield first, " ".join(block)
            block = []
        if line.startswith("|"):
            yield from ((number, cell) for cell in re.split(r"(?<!\\)\|", line))
        elif line.strip():
            first = first if block else number
            block.append(line.strip())


def comments(text):
    """The comments of C and C++, without the code in them."""
    for match in re.finditer(r"/\*.*?\*/|(?<![:\"])//[^\n]*", text, re.DOTALL):
        first = text.count("\n", 0, match.start()) + 1
        body = re.sub(r"@code.*?@endcode", lambda code: "\n" * code.group().count("\n"), match.group(),
                      flags=re.DOTALL)
        lines = [re.sub(r"^\s*(/\*+|\*/|\*|///?<?)", "", line).replace("*/", "") for line in body.splitlines()]
        block, at = [], first
        for number, line in enumerate([*lines, ""], first):
            if line.strip() and not line.startswith("     "):
                at = at if block else number
                block.append(line.strip())
            elif block:
                yield at, " ".join(block)
                block = []


def strings(text):
    """Docstrings and messages of Python: strings with a blank in them. Examples and tables are left out."""
    tree = ast.parse(re.sub(r"@[A-Z_]+@", "x", text))
    inner = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in ast.walk(node)
             if part is not node}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            value = "".join(part.value if isinstance(part, ast.Constant) else CODE for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in inner:
            value = node.value
        else:
            continue
        if " " in value.strip():
            for block in re.finditer(r"(?:[^\n]+\n?)+", value):
                if not block.group().lstrip().startswith((">>>", "import ")):
                    yield node.lineno + value.count("\n", 0, block.start()), " ".join(block.group().split())


def shell(text):
    """The blocks of comments in a script, and its messages."""
    block, first = [], 0
    for number, line in enumerate([*text.splitlines(), ""], 1):
        comment = re.match(r"\s*# ?(?!!|shellcheck)(.*)", line)
        if comment and comment.group(1).strip():
            first = first if block else number
            block.append(comment.group(1).strip())
        elif block:
            yield first, " ".join(block)
            block = []
        for message in re.finditer(r"\b(?:say|die|echo) \"([^\"]* [^\"]*)\"", line):
            yield number, message.group(1)


READERS = {".md": markdown, ".in": markdown, ".h": comments, ".py": strings, "": shell, ".sh": shell}


def sentences(path, name):
    """The blocks of a file as sentences without code, each with the place that it comes from."""
    reader = strings if name.endswith(".py.in") else READERS[path.suffix]
    for number, block in reader(path.read_text()):
        block = re.sub(r"``.*?``|`[^`]*`", CODE, block)
        block = re.sub(r"\]\([^)]*\)", "", block)  # the address of a link
        block = re.sub(r"[*_#<>\[\]!|]|\s[-*]\s|^\s*([-*]|\d+\.)\s", " ", block).strip()
        for part in re.split(r"(?<=[.:;?!])\s+", block):  # diction leaves out what begins with a small letter
            part = part.strip(" .:;?!\"'(")
            if re.search("[a-z]{3}", part):
                yield f"{name}:{number}", f"{part[0].upper()}{part[1:]}."


def check(paths, root):
    """What diction finds in these files."""
    places, blocks = zip(*(pair for path in paths for pair in sentences(path, str(path.relative_to(root)))))
    with tempfile.TemporaryDirectory() as folder:
        phrases, text = Path(folder, "phrases"), Path(folder, "text")
        phrases.write_text(database())
        text.write_text("".join(f"{block}\n\n" for block in blocks))
        command = ["diction", "--ignore-double-words", "--suggest", "--no-default-file", "--file", phrases, text]
        found = subprocess.run(command, capture_output=True, text=True, check=True)
    hits = (re.fullmatch(r"\S+:(\d+): (.*\[.* -> .*)", line) for line in found.stdout.splitlines())
    return [f"{places[(int(hit[1]) - 1) // 2]}: {hit[2]}" for hit in hits if hit] + [
        line for path in paths for line in long_lines(path, root)]


def long_lines(path, root):
    """The lines of a Markdown page that are too long, except in tables and code."""
    if path.suffix not in (".md", ".in") or path.name.endswith(".py.in"):
        return []
    is_code, found = False, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        is_code ^= line.lstrip().startswith("```")
        if len(line) > LONGEST_LINE and not is_code and not line.startswith(("|", "![", "    ")):
            found.append(f"{path.relative_to(root)}:{number}: a line of {len(line)} characters; at most {LONGEST_LINE}")
    return found


def texts():
    return sorted({path for pattern in TEXTS for path in ROOT.glob(pattern)})


def self_test():
    """Exit status 0 if a bad sentence is found in each kind of text, and none in code."""
    bad = "The scene's unit is\ntaken for a metre."
    planted = {
        "page.md": f"# Title\n\nGood.\n\n- an item\n- {bad.lower()}\n\n| a | {bad.split(chr(10))[1]} |\n",
        "page.md.in": f"Good. {bad}\n",
        "public.h": f"/**\n * Good.\n *\n * {bad.replace(chr(10), chr(10) + ' * ')}\n */\nint x; ///< wants two\n",
        "long.md": f"{'word ' * 60}\n\n| {'cell ' * 60} |\n",
        "script": f"#!/usr/bin/env bash\n# Good.\n# {bad.replace(chr(10), chr(10) + '# ')}\nwants=1\ndie \"it wants two\"\n",
        "module.py": f'"""Good.\n\n{bad}\n"""\nraise ValueError(f"{{x}} wants {{y}} numbers")\n',
    }
    code = {
        "code.md": "Good.\n\n```sh\nwants\n```\n\n    wants code\n\nGood `wants x` and [this](wants.md).\n",
        "code.h": "/** @code\n * wants code\n * @endcode */\nint wants(int refused);\n",
        "code.py": 'wants = "refused"\n# wants\n',
    }
    expected = {"page.md": [6, 9], "page.md.in": [1], "public.h": [4, 7], "module.py": [3, 6],
                "long.md": [1], "script": [2, 6]}
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**planted, **code}.items():
            Path(folder, name).write_text(text)
        found = check(sorted(Path(folder).iterdir()), Path(folder))
    lines = {}
    for line in found:
        name, number = line.split(":")[:2]
        lines.setdefault(name, []).append(int(number))
    print("\n".join(found))
    if lines != expected:
        print(f"check_prose: found {lines}, planted {expected}")
        return 1
    print("check_prose: all planted phrases were found")
    return 0


def main(arguments):
    if not shutil.which("diction"):
        print("check_prose: diction is missing (Debian: apt-get install diction)")
        return 2
    if arguments == ["--self-test"]:
        return self_test()
    paths = [Path(argument).resolve() for argument in arguments] or texts()
    found = check(paths, ROOT)
    print("\n".join(found))
    print(f"check_prose: {len(paths)} texts, {len(found)} sentences with phrases to avoid"
          + ("; Utilities/Prose/phrases.tsv lists the replacements" if found else ""))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
