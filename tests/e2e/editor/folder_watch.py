"""Waits until something happens to the files of a folder, by inotify of the kernel."""

import ctypes
import os
import select

WHOLE_FILE = 0x80  # one came into the folder, or took another one's place
ANY_CHANGE = 0x02 | 0x100 | WHOLE_FILE  # and one was made or written


class FolderWatch:
    def __init__(self, folder, changes=WHOLE_FILE):
        libc = ctypes.CDLL(None, use_errno=True)
        self.file = libc.inotify_init1(os.O_NONBLOCK)
        if self.file < 0 or libc.inotify_add_watch(self.file, folder.encode(), changes) < 0:
            raise OSError(ctypes.get_errno(), f"{folder} cannot be watched")

    def wait(self, seconds):
        """Returns at the next change, at once where there was one since the last call, or when the time is over."""
        if select.select([self.file], [], [], seconds)[0]:
            os.read(self.file, 1 << 16)

    def close(self):
        os.close(self.file)
