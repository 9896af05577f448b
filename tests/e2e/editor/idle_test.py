"""An editor whose picture is finished and that nobody touches sleeps: it wakes every few seconds for a few frames, and
between them none of its threads does anything."""

import os
import time

from small_cloth import small_cloth
from window_driver import expect, run, window

PROGRAM = os.environ["LOOMLIGHT"]
WIDTH, HEIGHT = 640, 400
FRAMES_A_WAKE, LONGEST_SLEEP_S = 6, 5  # as in app/editor/editor.cpp
WAKES = 3
LEAST_SPAN_S = 1  # of a sleep that is measured
BUSY_SHARE = 0.01  # of a processor, that threads asleep may take: they take none


def processor_s(process):
    """What all threads of it have had of the processor by now."""
    total = 0
    for thread in os.listdir(f"/proc/{process.pid}/task"):
        try:
            with open(f"/proc/{process.pid}/task/{thread}/schedstat", encoding="ascii") as times:
                total += int(times.read().split()[0])
        except FileNotFoundError:
            pass  # it has just ended
    return 1e-9 * total


def a_few_frames_a_wake(editor):
    """Frames are counted over the time that they take: a busy machine takes longer for them, never less."""
    first, began = editor.number("frame"), time.monotonic()
    made = lambda: editor.number("frame") - first
    editor.wait_until("some frames are made", lambda: made() >= WAKES * FRAMES_A_WAKE)
    took = time.monotonic() - began
    most = FRAMES_A_WAKE * (took / LONGEST_SLEEP_S + 2)
    expect(made() <= most, f"{made()} frames in {took:.1f} s: an editor at rest makes {most:.0f} at most")


def none_of_them_is_drawn(editor):
    """Once all workers sleep, frames look like the one on the screen, and are left out; one that a button lights up in
    is not."""
    def frames_and_drawn():
        facts = editor.dump()["facts"]
        return int(facts["frame"]), int(facts["drawn_frames"])

    frame, drawn = frames_and_drawn()
    editor.wait_until("some frames have been", lambda: frames_and_drawn()[0] >= frame + FRAMES_A_WAKE)
    expect(frames_and_drawn()[1] == drawn, "frames are drawn in which nothing changes")
    editor.move(*editor.centre("menu.file"))
    editor.wait_until("what the mouse is over is lit", lambda: frames_and_drawn()[1] > drawn)


def nothing_between_them(editor):
    """For as long as WAKES sleeps take, nobody does anything while no frame is drawn. Workers that still see to
    something, such as the colours of yarns, come to their end; whoever never rests, or not for so long, is waited for
    in vain."""
    frame, since, before, quiet_s = None, 0, 0, 0

    def slept():
        nonlocal frame, since, before, quiet_s
        dump = editor.dump()["facts"]
        now, spent = time.monotonic(), processor_s(editor.process)
        asleep = dump["sleeps_then"] == "yes" and dump["frame"] == frame and editor.fact("frame") == frame
        if asleep and now - since <= LEAST_SPAN_S:
            return False
        if asleep:
            rested = spent - before < BUSY_SHARE * (now - since)
            quiet_s = quiet_s + now - since if rested else 0
        frame, since, before = dump["frame"], now, spent
        return quiet_s > WAKES * LONGEST_SLEEP_S

    editor.wait_until("all of it sleeps", slept)


def test():
    with window(WIDTH, HEIGHT) as editor:
        editor.start(PROGRAM, [small_cloth(editor.home, "At rest")])
        editor.wait_until("the picture is finished", lambda: editor.fact("phase") == "converged")
        editor.wait_until("the yarn is seen close up", lambda: editor.fact("yarn.close_up") == "there")
        editor.click_at(WIDTH - 3, HEIGHT - 3)  # the last that somebody does
        samples = editor.fact("shown_samples")
        nothing_between_them(editor)  # first, as workers wake it until they have come to their end
        a_few_frames_a_wake(editor)
        none_of_them_is_drawn(editor)
        expect(editor.fact("shown_samples") == samples, "a finished picture gets more samples")


run(test)
