"""Every text of the program, as it stands in the source: quotes are of one kind, so that what the window says and what
a file's reader says, which the window shows too, look alike."""

import re
import unittest

from harness import ROOT, main

FOLDERS = ("app", "core", "render", "ui")
# A comment, a character, or a text; the first that begins is what it is.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|\'(?:\\.|[^\'\\\n])+\'|"((?:\\.|[^"\\\n])*)"', re.DOTALL)
BYTES = re.compile(r"((?:\\x[0-9A-Fa-f]{2})+)")


def as_shown(literal):
    """Bytes that are written by their numbers become what they are in UTF-8."""
    def decoded(match):
        return bytes.fromhex(match.group(1).replace("\\x", "")).decode("utf-8", "replace")
    return BYTES.sub(decoded, literal)


def texts():
    for folder in FOLDERS:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            source = file.read_text(encoding="utf-8")
            for token in TOKEN.finditer(source):
                if token.group(1):
                    line = source.count("\n", 0, token.start()) + 1
                    yield f"{file.relative_to(ROOT)}:{line}", as_shown(token.group(1))


class Texts(unittest.TestCase):
    def test_quotes_are_straight(self):
        found = [f"{place}: {text}" for place, text in texts() if re.search("[\u2018\u2019\u201c\u201d]", text)]
        self.assertEqual(found, [])

    def test_all_of_them_are_read(self):
        places = [place for place, _ in texts()]
        self.assertGreater(len(places), 3000)
        self.assertTrue(any("glossary.h" in place for place in places))


if __name__ == "__main__":
    main()
