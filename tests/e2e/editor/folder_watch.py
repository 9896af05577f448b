"""Waits until a file comes into a folder, or another takes its place, by inotify of the kernel."""

import ctypes
import os
import select

_MOVED_TO = 0x80  # a file is there as a whole


class FolderWatch:
    def __init__(self, folder):
        libc = ctypes.CDLL(None, use_errno=True)
        self.file = libc.inotify_init1(os.O_NONBLOCK)
        if self.file < 0 or libc.inotify_add_watch(self.file, folder.encode(), _MOVED_TO) < 0:
            raise OSError(ctypes.get_errno(), f"{folder} cannot be watched")

    def wait(self, seconds):
        """Returns at the next change, at once where there was one since the last call, or when the time is over."""
        if select.select([self.file], [], [], seconds)[0]:
            os.read(self.file, 1 << 16)

    def close(self):
        os.close(self.file)
