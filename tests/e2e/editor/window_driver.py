"""Drives the editor's real window: a virtual X server of its own, mouse and keys by XTEST, screenshots by ImageMagick.

Nothing here sleeps and hopes, and nothing leans on the machine's speed: every step waits for what it should bring about,
woken by the program's own account of its widgets, and gives up with a message that says what did not happen only when
the program must hang. Each event is drawn before the next is sent, because Dear ImGui samples mouse and keys once a
frame.
"""

import contextlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

from folder_watch import FolderWatch
from x_input import MissingLibrary, XInput

HANGS_S = 900  # only what hangs takes so long, however busy the machine


class Failure(Exception):
    pass


def expect(condition, message):
    if not condition:
        raise Failure(message)


def need(tool):
    if shutil.which(tool) is None:
        raise Failure(f"{tool} is not installed, and this test drives the window with it")


class Display:
    """An X server of our own; it chooses a free display itself."""

    def __init__(self, width, height):
        for tool in ("Xvfb", "import", "convert"):
            need(tool)
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp",
             "+extension", "GLX"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise Failure("Xvfb did not start")
        self.name = ":" + number
        try:
            self.input = XInput(self.name)
        except MissingLibrary as error:
            self.server.kill()
            raise Failure(str(error)) from error

    def close(self):
        self.input.close()
        self.server.terminate()
        self.server.wait()


def environment_of(display, home):
    """Of a program on that display, at home there and nowhere else."""
    kinds = ("data", "state", "config", "cache")
    return {**os.environ, "DISPLAY": display.name, "LIBGL_ALWAYS_SOFTWARE": "1", "HOME": home,
            **{f"XDG_{kind.upper()}_HOME": os.path.join(home, kind) for kind in kinds}}


class Editor:
    """The program in a home of its own, and what it says of its widgets."""

    scale = 1

    def __init__(self, display, width, height, samples):
        self.process = None
        self.input = display.input
        self.home = tempfile.mkdtemp(prefix="loomlight-editor-")
        self.watch = FolderWatch(self.home)
        self.dump_file = os.path.join(self.home, "widgets.json")
        self.log_file = os.path.join(self.home, "log.txt")
        self.width, self.height = width, height
        self.settings_file = os.path.join(self.home, "config", "loomlight", "editor.json")
        self.state = os.path.join(self.home, "state", "loomlight")  # of unsaved work
        self.data = os.path.join(self.home, "data", "loomlight")  # of presets and kept views
        # Of somebody who has been here before, and whose pictures are soon at rest: the processors are for the tests.
        self.write_settings({"hints_seen": True, "viewport_samples": samples})
        self.environment = environment_of(display, self.home)

    def start(self, program, arguments=()):
        if os.path.exists(self.dump_file):
            os.remove(self.dump_file)
        with open(self.log_file, "a", encoding="utf-8") as log:
            self.process = subprocess.Popen(
                [program, "edit", *arguments, "--window", f"{self.width}x{self.height}", "--scale", str(self.scale),
                 "--widget-dump", self.dump_file],
                env=self.environment, stdout=log, stderr=log)
        self.wait_until("the window shows its widgets", lambda: "viewport" in self.widgets())

    def write_settings(self, settings):
        os.makedirs(os.path.dirname(self.settings_file), exist_ok=True)
        with open(self.settings_file, "w", encoding="utf-8") as file:
            json.dump(settings, file)

    def log(self):
        with open(self.log_file, encoding="utf-8") as log:
            return log.read()

    def dump(self):
        try:
            with open(self.dump_file, encoding="utf-8") as file:
                return json.load(file)
        except FileNotFoundError:
            return {"widgets": {}, "facts": {}}

    def widgets(self):
        return self.dump()["widgets"]

    def fact(self, name):
        return self.dump()["facts"].get(name, "")

    def number(self, name):
        return int(self.fact(name) or 0)

    def has_ended(self):
        return self.process.poll() is not None

    def wait_until(self, what, condition):
        """Looks again whenever the program tells of another frame. What it does elsewhere, as in its own folders, is
        looked at every now and then."""
        end = time.monotonic() + HANGS_S
        while time.monotonic() < end:
            if self.has_ended():
                raise Failure(f"the editor ended ({self.process.returncode}) while waiting until {what}\n{self.log()}")
            if condition():
                return
            self.watch.wait(0.2)
        raise Failure(f"waited {HANGS_S} s in vain until {what}; facts: {self.dump()['facts']}\n{self.log()}")

    def act(self, send, *arguments, answered=False):
        """Sends events; returns when the program has drawn a frame with them, or another one too where they are to be
        answered: ImGui does so a frame late. An editor that has ended draws none."""
        before = self.number("inputs")
        events = send(*arguments)
        if not events:
            return  # the pointer is there already
        taken = None

        def drawn():
            nonlocal taken
            dump = self.dump()["facts"]
            if taken is None and int(dump.get("inputs", 0)) >= before + events:
                taken = int(dump["frame"])
            return self.has_ended() or (taken is not None and int(dump["frame"]) >= taken + answered)

        end = time.monotonic() + HANGS_S
        while not drawn():
            if time.monotonic() > end:
                raise Failure(f"no frame is drawn after an event; facts: {self.dump()['facts']}\n{self.log()}")
            self.watch.wait(0.2)

    def centre(self, widget):
        """Where the widget is once it has come to rest: a list that opens is laid out over its first frames."""
        place, frame = None, 0

        def rests():
            nonlocal place, frame
            dump = self.dump()
            now, now_frame = dump["widgets"].get(widget), int(dump["facts"].get("frame", 0))
            if now != place:
                place, frame = now, now_frame
            return now is not None and (now_frame >= frame + 2 or dump["facts"].get("sleeps_then") == "yes")

        self.wait_until(f"{widget} is on the screen", rests)
        x0, y0, x1, y1 = place
        return (x0 + x1) / 2, (y0 + y1) / 2

    def move(self, x, y):
        expect(0 <= x < self.width and 0 <= y < self.height, f"{x:.0f}, {y:.0f} is outside of the window")
        self.act(self.input.move, int(x), int(y))

    def press(self, button=1):
        self.act(self.input.button, button, 1)

    def release(self, button=1):
        self.act(self.input.button, button, 0, answered=True)

    def wheel(self, x, y, away=False, clicks=1):
        self.move(x, y)
        for _ in range(clicks):
            self.act(self.input.wheel, away, answered=True)

    def click(self, widget, button=1):
        self.click_at(*self.centre(widget), button)

    def click_at(self, x, y, button=1):
        self.move(x, y)
        self.press(button)
        self.release(button)

    def drag(self, start, end, button=1, steps=4):
        self.move(*start)
        self.press(button)
        for i in range(1, steps + 1):
            t = i / steps
            self.move(start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1]))
        self.release(button)

    def drag_widget(self, widget, dx, dy=0, button=1):
        x, y = self.centre(widget)
        self.drag((x, y), (x + dx, y + dy), button)

    def key(self, *names):
        for name in names:
            parts = name.split("+")
            for part in parts:
                self.act(self.input.key, part, 1)
            for part in reversed(parts):
                self.act(self.input.key, part, 0, answered=True)

    def type(self, text):
        self.wait_until("a text field listens", lambda: self.fact("text_input") == "yes")
        self.act(self.input.type, text, answered=True)

    def name_file(self, file):
        """In the file browser, which is open."""
        self.click("browser.name")
        self.key("ctrl+a")
        self.type(file)
        self.key("Return")

    def screenshot(self, name, widget=None, kind="png"):
        """Writes a picture of the window, or of one widget, and returns its file. Packing a png takes the processors for
        longer than a ppm."""
        file = os.path.join(self.home, f"{name}.{kind}")
        command = ["import", "-window", "root"]
        if widget:
            x0, y0, x1, y1 = (int(v) for v in self.widgets()[widget])
            command += ["-crop", f"{x1 - x0}x{y1 - y0}+{x0}+{y0}", "+repage"]
        subprocess.run([*command, file], env=self.environment, check=True)
        return file

    def wait_for_picture(self):
        """Until what is shown is of the newest state of the fabric, and no sketch of it."""
        def follows():
            facts = self.dump()["facts"]
            newest = int(facts.get("generation", 0))
            return newest > 0 and facts["shown_generation"] == facts["generation"] and facts["shown_sketch"] == "no"

        self.wait_until("the picture follows the fabric", follows)

    def wait_for_end(self):
        try:
            return self.process.wait(HANGS_S)
        except subprocess.TimeoutExpired as error:
            raise Failure("the editor does not end") from error

    def leave(self):
        """Without saving; it asks where something is not saved, and has to end well."""
        self.key("ctrl+q")
        if self.fact("dirty") == "yes":
            self.click("message.answer_1")
        status = self.wait_for_end()
        expect(status == 0, f"the editor ended with status {status}\n{self.log()}")

    def saved(self, file):
        """The fabric that it saves in that file, where it has it from."""
        self.key("ctrl+s")
        self.wait_until("the fabric is saved", lambda: self.fact("dirty") == "no" and self.fact("dialog") == "none")
        return read_json(file)

    def close(self):
        if self.process and self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.watch.close()
        shutil.rmtree(self.home, ignore_errors=True)


@contextlib.contextmanager
def window(width, height, samples=4):
    """An editor to start, on a display of its own, whose pictures rest at so many samples a pixel."""
    display = Display(width, height)
    editor = None
    try:
        editor = Editor(display, width, height, samples)
        yield editor
    finally:
        if editor:
            editor.close()
        display.close()


def read_json(file):
    """A file that is none as a whole, such as a torn one, fails the test."""
    with open(file, encoding="utf-8") as text:
        try:
            return json.load(text)
        except ValueError as error:  # of JSON, and of UTF-8
            raise Failure(f"{file} is torn, or no JSON: {error}") from error


def write_json(home, name, content):
    """Returns the file."""
    file = os.path.join(home, name)
    with open(file, "w", encoding="utf-8") as text:
        json.dump(content, text)
    return file


def picture_statistics(file):
    """Mean and standard deviation of all samples of a picture, 0..1."""
    out = subprocess.run(["convert", file, "-format", "%[fx:mean] %[fx:standard_deviation]", "info:"],
                         check=True, capture_output=True, text=True).stdout
    mean, deviation = out.split()
    return float(mean), float(deviation)


def difference(a, b):
    """Root mean square difference of two pictures of one size, 0..1."""
    out = subprocess.run(["convert", a, b, "-metric", "RMSE", "-compare", "-format", "%[distortion]", "info:"],
                         check=True, capture_output=True, text=True).stdout
    return float(out)


def run(test):
    """Runs test(); says what failed and exits accordingly."""
    try:
        test()
    except Failure as failure:
        print(f"FAILED: {failure}", file=sys.stderr)
        sys.exit(1)
