#!/usr/bin/env python3
"""Fails when comments, Markdown or texts for users break the rules of plain English more often than LIMITS allows.

usage: check_prose.py [repo root] [--list]        exit 1 if a rule is broken more often than its limit
--list      one line for each finding: FILE:LINE: RULE (detail): text

Rules:
  headless  the text begins with a word that leaves its noun out ("Of beads"): name the noun
  wh        what, those, whatever, whoever, whose or nobody: name the thing
  private   a word that only this project uses in this sense: use the field's term
  long      a sentence of more than 30 words: split it
  setting   the text of a setting does not begin with a capital noun or an imperative verb, or ends with a full stop
"""
import collections
import pathlib
import re
import subprocess
import sys

# Findings that are allowed in the whole repository. Lower a limit when texts have been corrected; never raise one.
LIMITS = {"headless": 0, "wh": 0, "private": 0, "long": 0, "setting": 0}

LONGEST_SENTENCE = 30  # words
HEADLESS = set(
    "Of Those That Which What Whose Its As By From Most Also How Who Whoever Whatever Nothing Nobody Where Wherever Whether "
    "Likewise Such Both Others Nor".split()
)
WH = re.compile(r"\b(what|those|whatever|whoever|whose|nobody)\b", re.I)
PRIVATE = {
    r"\bways?\b": "travel, toolpath or pass",
    r"\bcomes? to\b": "amounts to, becomes",
    r"\bbut for\b": "except",
    r"\bby turns\b": "alternately",
    r"\bborne\b": "supported",
    r"\btells? of\b": "reports",
    r"\bis told\b": "receives, is reported",
    r"\bcame of\b": "resulted",
    r"\bstands? for itself\b": "is independent",
    r"\bhas to do with\b": "concerns",
    r"\bgoes? on\b": "continues",
    r"\bthe others\b": "name them",
    r"\bthe same (?:of|for|as before)\b": "name it",
    r"\blook(?:s|ed)? at\b": "inspects, considers",
    r"\bround(?= (?:it|them|the|a|an|by)\b)": "around",
}
PRIVATE = [(re.compile(pattern, re.I), better) for pattern, better in PRIVATE.items()]
# A setting is described by a noun or an imperative verb: not by these, nor by a verb in the third person.
NO_NOUN = HEADLESS | set("The A An If When While Not No Only Every Each All Any It They This These Further Nearer Longer Shorter".split())
THIRD_PERSON = set(
    "Adds Allows Does Fills Finds Gives Grows Heats Keeps Leads Leaves Makes Prints Puts Retracts Rises Rounds Sets Shrinks Slows "
    "Smooths Takes Tells Turns Writes".split()
)

CPP = (".h", ".cc", ".proto")
HASH = (".py", ".sh", ".cmake", ".yml", "CMakeLists.txt")
LITERAL = r'"(?:[^"\\\n]|\\.)*"'
LITERALS = rf"{LITERAL}(?:\s*{LITERAL})*"
HELP = re.compile(rf'add_(?:option|flag|subcommand)\w*\([^"]*"[^"]*",[^"]*?({LITERALS})|(?:->|\.)(?:description|footer)\(\s*({LITERALS})')
PYTHON_HELP = re.compile(rf"\b(?:help|description|epilog)=({LITERALS})")
DOC = re.compile(rf"\.doc\s*=\s*({LITERALS})")
# A function or lambda with a parameter `doc`: name, and the parameters before that one.
DOC_FUNCTION = re.compile(r"\b(\w+)(?:\s*=\s*\[[^\]]*\])?\(([^(){};]*?)std::string_view doc\b")

Block = collections.namedtuple("Block", "line kind text")  # kind: comment, member, paragraph, help or setting


def line_of(text, position):
    """Returns the number of the line, from 1, in which a position of a text is."""
    return text.count("\n", 0, position) + 1


def joined(literals):
    """Returns the text of adjacent string literals. An escaped line end separates paragraphs."""
    return "".join(each[1:-1] for each in re.findall(LITERAL, literals)).replace("\\n", "\n\n").replace('\\"', '"')


def runs_of_lines(lines, mark):
    """Yields (line number, text) for each run of lines that `mark` matches; its group 1 is a line's text."""
    run, start = [], 0
    for number, line in enumerate([*lines, ""], 1):
        if found := mark.match(line):
            start = start if run else number
            run.append(found[1])
        elif run:
            yield start, "\n".join(run)
            run = []


def comments(text, mark):
    """Yields the comments that fill whole lines."""
    for line, block in runs_of_lines(text.splitlines(), mark):
        yield Block(line, "comment", block)


def members(text):
    """Yields the `///<` comments behind members, which may continue on the next lines."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        if found := re.match(r"^\s*[^\s/].*?///<\s?(.*)$", line):
            rest = [found[1]]
            for next_line in lines[number + 1 :]:
                if not (more := re.match(r"^\s*///<\s?(.*)$", next_line)):
                    break
                rest.append(more[1])
            yield Block(number + 1, "member", "\n".join(rest))


def paragraphs(text):
    """Yields the paragraphs and list items of a Markdown file, without code, tables and headings."""
    text = re.sub(r"```.*?```", lambda code: "\n" * code[0].count("\n"), text, flags=re.S)
    plain = re.compile(r"^(?!    |#|\||!\[)(.*\S.*)$")
    for line, block in runs_of_lines(text.splitlines(), plain):
        yield Block(line, "paragraph", block)


def argument(text, start, index):
    """Returns the `index`-th argument of the call whose parenthesis is at `start`, with its position; None: no such one."""
    depth, begin, count = 0, start + 1, 0
    for token in re.finditer(rf"{LITERAL}|[(){{}}\[\],]", text[start : start + 4000]):
        at = start + token.start()
        if token[0] in "({[":
            depth += 1
        elif token[0] in ")}]":
            depth -= 1
        if depth == 0 or (token[0] == "," and depth == 1):
            if count == index:
                return begin, text[begin:at]
            count, begin = count + 1, at + 1
        if depth == 0:
            return None
    return None


def setting_docs(text):
    """Yields the texts of settings: `.doc = "..."`, and arguments of functions that have a parameter `doc`."""
    for found in DOC.finditer(text):
        yield Block(line_of(text, found.start(1)), "setting", joined(found[1]))
    for function in DOC_FUNCTION.finditer(text):
        index = function[2].count(",")
        for call in re.finditer(rf"\b{function[1]}(?:<[^()]*?>)?(?=\()", text):
            value = argument(text, call.end(), index)
            if value and re.fullmatch(rf"\s*{LITERALS}\s*", value[1]):
                yield Block(line_of(text, value[0] + 1), "setting", joined(value[1]))


def helps(text, pattern):
    """Yields the help texts of options, flags, subcommands and footers."""
    for found in pattern.finditer(text):
        for group in range(1, pattern.groups + 1):
            if found[group]:
                yield Block(line_of(text, found.start(group)), "help", joined(found[group]))


def blocks_of(name, text):
    """Yields the blocks of prose in a file."""
    if name.endswith(".md"):
        yield from paragraphs(text)
    elif name.endswith(CPP):
        yield from comments(text, re.compile(r"^\s*//(?!/<)/?\s?(.*)$"))
        yield from members(text)
        if not name.endswith("_test.cc"):
            yield from setting_docs(text)
            yield from helps(text, HELP)
    elif name.endswith(HASH):
        yield from comments(text, re.compile(r"^\s*#(?!!)\s?(.*)$"))
        if name.endswith(".py"):
            yield from helps(text, PYTHON_HELP)


def sentences(text):
    """Returns the sentences of a block. A blank line and a list item begin a new one. Indented paragraphs are tables or code."""
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )", text):
        if all(line.startswith("  ") for line in paragraph.splitlines()):
            continue
        yield from re.split(r"(?<=[.:;!?])\s+", " ".join(paragraph.split()))


def headless(block, text):
    """Yields the first word of a text that leaves its noun out."""
    first = re.match(r"[A-Za-z']+", text)
    if block.kind != "paragraph" and first and first[0].capitalize() in HEADLESS and " " in text:
        yield first[0]


def wh(block, text):
    """Yields words that stand for an unnamed thing."""
    yield from WH.findall(text)


def private(block, text):
    """Yields the project's private words, with the usual ones."""
    for pattern, better in PRIVATE:
        for word in pattern.findall(text):
            yield f"{word} -> {better}"


def long(block, text):
    """Yields the lengths of sentences that are too long."""
    for sentence in sentences(text):
        if (count := len(sentence.split())) > LONGEST_SENTENCE:
            yield f"{count} words"


def setting(block, text):
    """Yields faults of a setting's text."""
    if block.kind != "setting":
        return
    first = text.split(" ")[0]
    if not first[:1].isupper() or first in NO_NOUN or first in THIRD_PERSON:
        yield f"begins with {first}"
    if text.endswith("."):
        yield "ends with a full stop"


RULES = {"headless": headless, "wh": wh, "private": private, "long": long, "setting": setting}


def findings(block):
    """Yields (rule, detail) for each fault of a block. Code in backquotes does not count."""
    text = re.sub(r"`[^`]*`", "X", block.text).strip()
    if len(re.findall(r"[A-Za-z]{2,}", text)) < 2:
        return
    for name, rule in RULES.items():
        for detail in rule(block, text):
            yield name, detail


def files_of(root):
    """Returns the names of the repository's files; of a folder without git, all of its files."""
    listed = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True)
    names = listed.stdout.split("\n") if listed.returncode == 0 else []
    if not any(names):
        names = [file.relative_to(root).as_posix() for file in sorted(root.rglob("*")) if file.is_file()]
    return [name for name in names if name.endswith((".md", *CPP, *HASH)) and "corpus/" not in name and (root / name).is_file()]


def check(root):
    """Returns the number of findings by rule, and a line for each of them."""
    counts, lines = collections.Counter(), []
    for name in files_of(root):
        for block in blocks_of(name, (root / name).read_text(errors="replace")):
            for rule, detail in findings(block):
                counts[rule] += 1
                lines.append(f"{name}:{block.line}: {rule} ({detail}): {' '.join(block.text.split())[:110]}")
    return counts, lines


def exceeded(counts, limits):
    """Returns a line for each rule that is broken more often than its limit."""
    return [f"{rule}: {counts[rule]} findings, at most {limit} are allowed; --list shows them" for rule, limit in limits.items() if counts[rule] > limit]


def main():
    arguments = [each for each in sys.argv[1:] if each != "--list"]
    counts, lines = check(pathlib.Path(arguments[0] if arguments else ".").resolve())
    if "--list" in sys.argv:
        print("\n".join(lines))
    over = exceeded(counts, LIMITS)
    print("\n".join(over) or ", ".join(f"{rule} {counts[rule]} of {limit}" for rule, limit in LIMITS.items()))
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
