"""What Python has on Unix and lacks on Windows, as far as tests themselves can do without it."""

MODULES = ("resource", "fcntl", "termios", "tty", "pty", "grp", "pwd", "readline", "curses")
NAMES = (
    *("uname", "geteuid", "getegid", "pread", "pwrite", "sched_getaffinity", "fork", "sendfile"),
    *("O_NOFOLLOW", "O_DIRECTORY", "O_NONBLOCK", "O_CLOEXEC", "register_at_fork", "statvfs"),
    *("openpty", "killpg", "setsid", "sysconf", "fchown", "chown"),
)
"""Of `os`."""
