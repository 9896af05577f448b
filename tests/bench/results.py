#!/usr/bin/env python3
"""Puts the pages of `loomlight bench accuracy`, `closeup`, `table1`, `figures`, `edit`, `clear`, `converge` and `cloths`,
and that of `first_start`, together as RESULTS.md, with a few small pictures. Suites that are not in RUNS keep the page
that they have there, and each says of which commit it is.

    tests/bench/results.py --run build/app/loomlight RUNS    measures first: two hours on two idle cores
    tests/bench/results.py RUNS                              only writes, from the suites that are in RUNS

RUNS is a folder that keeps the whole pages, tables and pictures, one folder a suite, with the commit that it is of.
"""

import argparse
import pathlib
import re
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
# All of `clear` would take a day: every cloth as it is opened, also in a large picture, and every edit of one.
CLEAR = ("clear", "--seconds", "6", "--reference", "1024", "--only")
SUITES = {
    "accuracy": ("accuracy",),
    "closeup": ("closeup",),
    "table1": ("table1",),
    "figures": ("figures",),
    "edit": ("edit",),
    "clear": (*CLEAR, "open"),
    "clear_large": (*CLEAR, "open,dome", "--share", "on", "--size", "1280x720"),
    "clear_edits": (*CLEAR, "denim,flat,skirt,dome,sky,crossing,twist,colour,light,drape,camera,drag", "--share", "on"),
    "first_start": ("first_start",),
    "converge": ("converge",),
    "cloths": ("cloths",),
}
OWN_PROGRAMS = ("first_start",)  # beside this one, not suites of `bench`
TITLES = {"clear_large": "## Large pictures of every cloth", "clear_edits": "## Every edit of one cloth"}  # instead of those that the suite writes
PICTURES = ("accuracy_plain_filament", "accuracy_raw_denim", "closeup_denim_raw", "blue", "black_and_white", "fig1", "fig4", "fig7", "fig8", "fig11-14_blue")
LARGEST_BYTES = 100_000


def commit():
    words = ("git", "-C", str(HERE), "describe", "--always", "--dirty", "--exclude=*")
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()


def measure(program, runs):
    for name, suite in SUITES.items():
        words = (HERE / name, program, runs / name) if name in OWN_PROGRAMS else (program, "bench", *suite, "-o", runs / name)
        subprocess.run(words, check=True)
        (runs / name / "commit").write_text(commit() + "\n")


def page_of(name, runs, pictures):
    """The page a level further down; copies the pictures that are wanted and leaves the others out."""
    lines = (runs / name / f"{SUITES[name][0]}.md").read_text().splitlines()
    lines[0] = TITLES.get(name, lines[0])
    lines.insert(1, f"\n*Measured at commit {(runs / name / 'commit').read_text().strip()}.*")
    kept, caption = [], None
    for line in lines:
        if line == caption:  # stands below its picture
            caption = None
            continue
        shown = re.fullmatch(r"!\[(.*)\]\((.*)\.png\)", line)
        if shown:
            caption = shown.group(1)
            if shown.group(2) not in PICTURES:
                continue
            small = runs / name / "small" / f"{shown.group(2)}.png"
            assert small.stat().st_size <= LARGEST_BYTES, small
            shutil.copyfile(small, pictures / small.name)
            kept += [f"![{caption}](results/{small.name})", "", f"*{caption}*"]
        elif not (line == "" and kept and kept[-1] == ""):
            kept.append("#" + line if line.startswith("#") else line)
    return "\n".join(kept).strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", metavar="RUNS", type=pathlib.Path)
    parser.add_argument("--run", metavar="LOOMLIGHT", help="the program to measure with")
    arguments = parser.parse_args()
    if arguments.run:
        measure(arguments.run, arguments.runs)
    results, pictures = HERE / "RESULTS.md", HERE / "results"
    pictures.mkdir(exist_ok=True)
    head = (
        "# Results\n\n"
        "Written by [results.py](results.py) from what `loomlight bench` measured. \"The report\" is Schröder, Zinke and "
        "Klein 2011; \"prototype\" a throw-away program of ours that came before this one."
    )
    # A page begins with the mark of its suite; the last is of a program of its own, bench_relaxation.
    marked = re.split(r"^<!-- (\w+) -->\n", results.read_text(), flags=re.MULTILINE)[1:]
    pages = dict(zip(marked[::2], map(str.strip, marked[1::2])))
    for name in SUITES:
        if (arguments.runs / name).exists():
            pages[name] = page_of(name, arguments.runs, pictures)
    order = [name for name in (*SUITES, "relaxation") if name in pages]
    results.write_text("\n\n".join([head, *(f"<!-- {name} -->\n{pages[name]}" for name in order)]) + "\n")
    shown = results.read_text()
    for picture in pictures.iterdir():
        if f"(results/{picture.name})" not in shown:
            picture.unlink()


main()
