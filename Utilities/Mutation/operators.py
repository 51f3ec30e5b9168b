# SPDX-License-Identifier: BSD-3-Clause
"""Which mutants a source in C, or in GLSL that is C, too, has: signs and comparisons, one changed at a time."""
import dataclasses
import re

COMPARISONS = {
    "<": ("<=", ">="),
    "<=": ("<", ">"),
    ">": (">=", "<="),
    ">=": (">", "<"),
    "==": ("!=",),
    "!=": ("==",),
    "&&": ("||",),
    "||": ("&&",),
    "fmin": ("fmax",),
    "fmax": ("fmin",),
    "min": ("max",),
    "max": ("min",),
}
SIGNS = {"+": ("-",), "-": ("+",), "+=": ("-=",), "-=": ("+=",), "++": ("--",), "--": ("++",)}

# Longer tokens first. Comments, strings and preprocessor lines are blanked out before.
TOKEN = re.compile(
    r"(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[a-zA-Z]*|[A-Za-z_]\w*"
    r"|->|<<=?|>>=?|<=|>=|==|!=|&&|\|\||\+\+|--|[-+*/%&|^]=|[^\s\w]")
HIDDEN = re.compile(
    r"//[^\n]*|/\*.*?\*/|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'"
    r"|^[ \t]*#(?:[^\n\\]|\\.)*(?:\\\n(?:[^\n\\]|\\.)*)*", re.S | re.M)
TYPES = {"double", "float", "int", "unsigned", "char", "size_t", "uint32_t", "uint64_t"}
BEFORE_UNARY = {"return", "case", "else"}


@dataclasses.dataclass(frozen=True)
class Mutant:
    """A token of a file and what stands in its place; the key names it whatever its line's number."""

    file: str
    line: int
    start: int  # of the token in the file's text
    end: int
    new: str
    key: str  # "file: line of code with the token in [[ ]] -> new", and #n if there are several


def _blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def _is_operand(tokens, index):
    """Whether the token ends an operand, so that a sign after it joins two."""
    if index < 0:
        return False
    text = tokens[index].group()
    if text == ")":
        is_cast = (index >= 2 and tokens[index - 1].group() in TYPES and
                   tokens[index - 2].group() == "(")
        return not is_cast
    return text == "]" or (re.match(r"[\w.]", text) is not None and text not in BEFORE_UNARY)


def _is_in_for(code, start):
    line = code[code.rfind("\n", 0, start) + 1:start]
    return re.match(r"\s*for \(", line) is not None


def _replacements(code, tokens, index):
    text = tokens[index].group()
    if text in COMPARISONS:
        return COMPARISONS[text]
    if text == "!":
        return ("",)
    if text not in SIGNS:
        return ()
    if text in "+-" and not _is_operand(tokens, index - 1):
        return ("",) if text == "-" else ()
    if text in ("++", "--") and _is_in_for(code, tokens[index].start()):
        return ()  # a loop that runs backwards: nothing to learn, and every test times out
    return SIGNS[text]


def mutants_of(name, text):
    """All mutants of a file, in its order."""
    code = HIDDEN.sub(_blank, text)
    tokens = list(TOKEN.finditer(code))
    seen = {}
    for index, token in enumerate(tokens):
        for new in _replacements(code, tokens, index):
            begin = text.rfind("\n", 0, token.start()) + 1
            end = text.find("\n", token.end())
            marked = (text[begin:token.start()] + "[[" + token.group() + "]]" +
                      text[token.end():end])
            key = f"{name}: {' '.join(marked.split())} -> {new or 'nothing'}"
            seen[key] = seen.get(key, 0) + 1
            if seen[key] > 1:
                key += f" #{seen[key]}"
            line = text.count("\n", 0, token.start()) + 1
            yield Mutant(name, line, token.start(), token.end(), new, key)
