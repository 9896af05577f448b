#!/usr/bin/env python3
"""Puts the pages of `loomlight bench accuracy`, `closeup`, `table1`, `figures`, `edit`, `clear`, `converge` and `cloths` together
as RESULTS.md, with a few small pictures.

    tests/bench/results.py --run build/app/loomlight RUNS    measures first: two hours on two idle cores
    tests/bench/results.py RUNS                              only writes, from the suites that are in RUNS

RUNS is a folder that keeps the whole pages, tables and pictures, one folder a suite, and the commit they are of.
"""

import argparse
import pathlib
import re
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
# All of `clear` would take hours: every cloth as it is opened, and every edit of one.
CLEAR = ("clear", "--seconds", "6", "--reference", "256", "--only")
SUITES = {
    "accuracy": ("accuracy",),
    "closeup": ("closeup",),
    "table1": ("table1",),
    "figures": ("figures",),
    "edit": ("edit",),
    "clear": (*CLEAR, "flat,skirt,dome,sky,open"),
    "clear_edits": (*CLEAR, "denim,flat,skirt,dome,sky,crossing,twist,colour,light,drape,camera,drag", "--share", "on"),
    "converge": ("converge",),
    "cloths": ("cloths",),
}
TITLES = {"clear_edits": "## Every edit of one cloth"}  # instead of those that the suite writes
PICTURES = ("accuracy_plain_filament", "accuracy_raw_denim", "closeup_denim_raw", "blue", "black_and_white", "fig1", "fig4", "fig7", "fig8", "fig11-14_blue")
LARGEST_BYTES = 100_000


def commit():
    words = ("git", "-C", str(HERE), "describe", "--always", "--dirty", "--exclude=*")
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()


def measure(program, runs):
    runs.mkdir(parents=True, exist_ok=True)
    (runs / "commit").write_text(commit() + "\n")
    for name, suite in SUITES.items():
        subprocess.run((program, "bench", *suite, "-o", runs / name), check=True)


def page_of(name, runs, pictures):
    """The page a level further down; copies the pictures that are wanted and leaves the others out."""
    lines = (runs / name / f"{SUITES[name][0]}.md").read_text().splitlines()
    lines[0] = TITLES.get(name, lines[0])
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
    pictures = HERE / "results"
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir()
    head = (
        "# Results\n\n"
        "Written by [results.py](results.py) from what `loomlight bench` measured at commit "
        f"{(arguments.runs / 'commit').read_text().strip()}. \"The report\" is Schröder, Zinke and Klein 2011; "
        "\"prototype\" a throw-away program of ours that came before this one."
    )
    pages = [page_of(name, arguments.runs, pictures) for name in SUITES if (arguments.runs / name).exists()]
    results = HERE / "RESULTS.md"
    by_hand = "## Crimp and thickness: the closed form against relaxed yarns"  # of a program of its own: bench_relaxation
    kept = by_hand + results.read_text().split(by_hand)[1].rstrip()
    results.write_text("\n\n".join([head, *pages, kept]) + "\n")


main()
