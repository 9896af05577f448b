"""Mouse and keyboard of an X server, by its extension XTEST, spoken with Xlib: no program has to be started for an
event, and each call returns when the server has passed the event on."""

import ctypes

_long, _ulong, _int, _pointer = ctypes.c_long, ctypes.c_ulong, ctypes.c_int, ctypes.c_void_p
_windows = ctypes.POINTER(_ulong)
# GLFW takes two presses of a key within a millisecond of the server's clock for one that an input method has doubled.
_APART_MS = 2
_KEYSYMS = {"ctrl": "Control_L", "shift": "Shift_L"}


class MissingLibrary(Exception):
    pass


def _library(name, package):
    try:
        return ctypes.CDLL(name)
    except OSError as error:
        raise MissingLibrary(f"{name} is not installed ({package}), and this test drives the window with it") from error


class ActionCount:
    """What a designer would call an action: a click, a drag, a key with what is held beside it, one value that is typed
    with the Enter or Tab that takes it, one turn of the wheel. Moving the mouse is none."""

    def __init__(self):
        self.count, self.last = 0, None

    def _another(self, kind):
        self.count += 1
        self.last = kind

    def button(self):
        self._another("button")

    def wheel(self):
        if self.last != "wheel":
            self._another("wheel")

    def typed(self):
        self._another("typed")

    def key(self, name):
        if name in _KEYSYMS or (self.last == "typed" and name in ("Return", "Tab")):
            self.last = name if name in _KEYSYMS else "taken"
        else:
            self._another("key")


class XInput:
    """All calls return how many events the window under the pointer is told of."""

    def __init__(self, display_name):
        self.x, self.test = _library("libX11.so.6", "libx11-6"), _library("libXtst.so.6", "libxtst6")
        x, test = self.x, self.test
        x.XOpenDisplay.restype = _pointer
        x.XOpenDisplay.argtypes = [ctypes.c_char_p]
        x.XDefaultRootWindow.restype = _ulong
        x.XStringToKeysym.restype = _ulong
        x.XStringToKeysym.argtypes = [ctypes.c_char_p]
        x.XKeysymToKeycode.restype = ctypes.c_ubyte
        x.XKeysymToKeycode.argtypes = [_pointer, _ulong]
        x.XkbKeycodeToKeysym.restype = _ulong
        x.XkbKeycodeToKeysym.argtypes = [_pointer, ctypes.c_ubyte, _int, _int]
        x.XSync.argtypes = [_pointer, _int]
        x.XQueryTree.argtypes = [_pointer, _ulong, _windows, _windows, ctypes.POINTER(_windows),
                                 ctypes.POINTER(ctypes.c_uint)]
        x.XFetchName.argtypes = [_pointer, _ulong, ctypes.POINTER(_pointer)]
        x.XFree.argtypes = [_pointer]
        for name in ("XDefaultRootWindow", "XCloseDisplay", "XAutoRepeatOff"):
            getattr(x, name).argtypes = [_pointer]
        test.XTestFakeMotionEvent.argtypes = [_pointer, _int, _int, _int, _ulong]
        test.XTestFakeButtonEvent.argtypes = [_pointer, ctypes.c_uint, _int, _ulong]
        test.XTestFakeKeyEvent.argtypes = [_pointer, ctypes.c_uint, _int, _ulong]
        self.display = x.XOpenDisplay(display_name.encode())
        if not self.display:
            raise MissingLibrary(f"no X server at {display_name}")
        x.XAutoRepeatOff(self.display)  # a key that a slow window holds for long is one key
        self.pointer = None
        self.actions = ActionCount()
        self.move(0, 0)

    def close(self):
        self.x.XCloseDisplay(self.display)

    def _sent(self, events):
        self.x.XSync(self.display, 0)
        return events

    def move(self, x, y):
        if (x, y) == self.pointer:
            return 0
        self.pointer = x, y
        self.test.XTestFakeMotionEvent(self.display, -1, x, y, 0)
        return self._sent(1)

    def button(self, number, down):
        if down:
            self.actions.button()
        self.test.XTestFakeButtonEvent(self.display, number, down, 0)
        return self._sent(1)

    def wheel(self, away):
        """One click of it, away from the user or towards."""
        self.actions.wheel()
        for down in (1, 0):
            self.test.XTestFakeButtonEvent(self.display, 4 if away else 5, down, 0)
        return self._sent(1)

    def key(self, name, down):
        if down:
            self.actions.key(name)
        keysym = self.x.XStringToKeysym(_KEYSYMS.get(name, name).encode())
        code = self.x.XKeysymToKeycode(self.display, keysym)
        if not code:
            raise ValueError(f"there is no key {name}")
        self.test.XTestFakeKeyEvent(self.display, code, down, _APART_MS)
        return self._sent(1)

    def type(self, text):
        """Latin letters, whose symbols have their numbers."""
        events = 0
        for letter in text:
            code = self.x.XKeysymToKeycode(self.display, ord(letter))
            if not code:
                raise ValueError(f"there is no key for {letter!r}")
            shifted = self.x.XkbKeycodeToKeysym(self.display, code, 0, 0) != ord(letter)
            if shifted:
                events += self.key("shift", 1)
            for down in (1, 0):
                self.test.XTestFakeKeyEvent(self.display, code, down, _APART_MS)
                events += 1
            if shifted:
                events += self.key("shift", 0)
        self.actions.typed()
        return self._sent(events)

    def window_called(self, part):
        """The number of a window whose title has this part; None where there is none."""
        root, parent, children, count = _ulong(), _ulong(), _windows(), ctypes.c_uint()
        self.x.XQueryTree(self.display, self.x.XDefaultRootWindow(self.display), ctypes.byref(root),
                          ctypes.byref(parent), ctypes.byref(children), ctypes.byref(count))
        found = None
        for i in range(count.value):
            title = _pointer()
            if self.x.XFetchName(self.display, children[i], ctypes.byref(title)) and title.value:
                if part in ctypes.string_at(title.value).decode(errors="replace"):
                    found = children[i]
                self.x.XFree(title)
        if count.value:
            self.x.XFree(children)
        return found
