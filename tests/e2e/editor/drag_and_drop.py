"""Drops a file onto a window as a file manager does: the protocol XDND (freedesktop.org), version 5, spoken with Xlib."""

import ctypes
import pathlib
import select
import time

from window_driver import HANGS_S, Failure

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
XDND_VERSION, COPY_NOW = 5, 0
_long, _ulong, _int, _pointer = ctypes.c_long, ctypes.c_ulong, ctypes.c_int, ctypes.c_void_p


class _Message(ctypes.Structure):
    _fields_ = [("type", _int), ("serial", _ulong), ("send_event", _int), ("display", _pointer), ("window", _ulong),
                ("message_type", _ulong), ("format", _int), ("data", _long * 5)]


class _Request(ctypes.Structure):
    _fields_ = [("type", _int), ("serial", _ulong), ("send_event", _int), ("display", _pointer), ("owner", _ulong),
                ("requestor", _ulong), ("selection", _ulong), ("target", _ulong), ("property", _ulong),
                ("time", _ulong)]


class _Notice(ctypes.Structure):
    _fields_ = [("type", _int), ("serial", _ulong), ("send_event", _int), ("display", _pointer),
                ("requestor", _ulong), ("selection", _ulong), ("target", _ulong), ("property", _ulong),
                ("time", _ulong)]


class _Event(ctypes.Union):
    _fields_ = [("type", _int), ("message", _Message), ("request", _Request), ("notice", _Notice),
                ("padding", _long * 24)]


class _Source:
    """The window that the file is dragged from."""

    def __init__(self, display_name):
        self.x = ctypes.CDLL("libX11.so.6")
        x = self.x
        x.XOpenDisplay.restype = _pointer
        x.XOpenDisplay.argtypes = [ctypes.c_char_p]
        x.XInternAtom.restype = _ulong
        x.XInternAtom.argtypes = [_pointer, ctypes.c_char_p, _int]
        x.XDefaultRootWindow.restype = _ulong
        x.XDefaultRootWindow.argtypes = [_pointer]
        x.XCreateSimpleWindow.restype = _ulong
        x.XCreateSimpleWindow.argtypes = [_pointer, _ulong, _int, _int, _int, _int, _int, _ulong, _ulong]
        x.XSetSelectionOwner.argtypes = [_pointer, _ulong, _ulong, _ulong]
        x.XSendEvent.argtypes = [_pointer, _ulong, _int, _long, ctypes.POINTER(_Event)]
        x.XChangeProperty.argtypes = [_pointer, _ulong, _ulong, _ulong, _int, _int, ctypes.c_char_p, _int]
        x.XNextEvent.argtypes = [_pointer, ctypes.POINTER(_Event)]
        for name in ("XPending", "XFlush", "XCloseDisplay", "XConnectionNumber"):
            getattr(x, name).argtypes = [_pointer]
        self.display = x.XOpenDisplay(display_name.encode())
        if not self.display:
            raise Failure("no X server to drag on")
        self.window = x.XCreateSimpleWindow(self.display, x.XDefaultRootWindow(self.display), 0, 0, 1, 1, 0, 0, 0)

    def atom(self, name):
        return self.x.XInternAtom(self.display, name.encode(), 0)

    def send(self, target, name, *data):
        event = _Event()
        event.message = _Message(CLIENT_MESSAGE, 0, 1, self.display, target, self.atom(name), 32,
                                 (_long * 5)(self.window, *data))
        self.x.XSendEvent(self.display, target, 0, 0, ctypes.byref(event))
        self.x.XFlush(self.display)

    def answer(self, request, content):
        """The target asks for what is dragged."""
        self.x.XChangeProperty(self.display, request.requestor, request.property, request.target, 8, 0, content,
                               len(content))
        event = _Event()
        event.notice = _Notice(SELECTION_NOTIFY, 0, 1, self.display, request.requestor, request.selection,
                               request.target, request.property, request.time)
        self.x.XSendEvent(self.display, request.requestor, 0, 0, ctypes.byref(event))
        self.x.XFlush(self.display)

    def wait_for(self, name, content=b""):
        """The target's message of that name; what it asks for meanwhile is answered."""
        end = time.monotonic() + HANGS_S
        while time.monotonic() < end:
            if not self.x.XPending(self.display):
                select.select([self.x.XConnectionNumber(self.display)], [], [], 1)
                continue
            event = _Event()
            self.x.XNextEvent(self.display, ctypes.byref(event))
            if event.type == SELECTION_REQUEST:
                self.answer(event.request, content)
            elif event.type == CLIENT_MESSAGE and event.message.message_type == self.atom(name):
                return list(event.message.data)
        raise Failure(f"the window never answered with {name}")


def drop_file(display_name, target, file, x, y):
    """Drags the file over a place of the screen, where window `target` is, and lets go."""
    source = _Source(display_name)
    content = (pathlib.Path(file).as_uri() + "\r\n").encode()
    source.x.XSetSelectionOwner(source.display, source.atom("XdndSelection"), source.window, 0)
    source.send(target, "XdndEnter", XDND_VERSION << 24, source.atom("text/uri-list"), 0, 0)
    source.send(target, "XdndPosition", 0, x << 16 | y, COPY_NOW, source.atom("XdndActionCopy"))
    if not source.wait_for("XdndStatus")[1] & 1:
        raise Failure("the window takes no files")
    source.send(target, "XdndDrop", 0, COPY_NOW, 0, 0)
    source.wait_for("XdndFinished", content)
    source.x.XCloseDisplay(source.display)
