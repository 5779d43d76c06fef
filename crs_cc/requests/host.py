"""The requests that a program's host computer serves: streams, time, arguments, files."""

from __future__ import annotations

from typing import Final

from crs_cc.requests.code import RequestCode, arguments

HOST_REQUESTS: Final = (
    RequestCode(
        "EXIT", 1, "host", "void exit(int status)", "ends the program",
        arguments(("i[0]", "exit status", "1")),
    ),
    RequestCode(
        "WRITE", 2, "host", "int write(int fd, const void *bytes, unsigned count)",
        "writes to the standard output (1) or error (2) stream",
        arguments(("i[0]", "stream", "1"), ("size", "bytes", "byte"), ("data", "the bytes", "1")),
        arguments(("result", "bytes written, -1 on error", "byte")),
    ),
    RequestCode(
        "READ", 3, "host", "int read(int fd, void *bytes, unsigned count)",
        "reads from the standard input stream (0)",
        arguments(("i[0]", "stream", "1"), ("i[1]", "number of bytes requested", "byte")),
        arguments(
            ("result", "bytes read, 0 at the end, -1 on error", "byte"),
            ("size", "bytes", "byte"), ("data", "the bytes", "1"),
        ),
    ),
    RequestCode(
        "CLOCK", 4, "host", "int gettimeofday(struct timeval *now, void *zone)",
        "reads the program's simulated clock",
        (), arguments(("f[0]", "time since the start of the run", "s"),
                       ("f[1]", "processor time used", "s")),
    ),
    RequestCode(
        "SLEEP", 5, "host", "int usleep(unsigned microseconds)",
        "sleeps in simulated time",
        arguments(("f[0]", "duration", "s")), arguments(("result", "0", "1")),
    ),
    RequestCode(
        "ARGUMENT", 6, "host", "int main(int argc, char **argv)",
        "reads a part of one of the program's arguments",
        arguments(("i[0]", "argument number", "1"), ("i[1]", "first byte requested", "byte")),
        arguments(
            ("result", "length of the argument, -1 if there is none", "byte"),
            ("size", "bytes", "byte"), ("data", "the part", "1"),
        ),
    ),
    RequestCode(
        "FILE_OPEN", 7, "host", "FILE *fopen(const char *name, const char *mode)",
        "opens or creates a file on the robot's own disk",
        arguments(
            ("i[0]", "flags: O_CREAT, O_EXCL, O_TRUNC, O_TMPFILE of fcntl.h", "1"),
            ("size", "length of the name", "byte"), ("data", "the name", "1"),
        ),
        arguments(("result", "the file's number, or -errno", "1")),
    ),
    RequestCode(
        "FILE_CLOSE", 8, "host", "int close(int fd)", "closes an open file",
        arguments(("i[0]", "the file's number", "1")), arguments(("result", "0, or -errno", "1")),
    ),
    RequestCode(
        "FILE_READ", 9, "host",
        "size_t fread(void *items, size_t size, size_t count, FILE *stream)",
        "reads from a file",
        arguments(
            ("i[0]", "the file's number", "1"), ("i[1]", "first byte requested", "byte"),
            ("i[2]", "number of bytes requested", "byte"),
        ),
        arguments(
            ("result", "bytes read, 0 at the end, or -errno", "byte"),
            ("size", "bytes", "byte"), ("data", "the bytes", "1"),
        ),
    ),
    RequestCode(
        "FILE_WRITE", 10, "host",
        "size_t fwrite(const void *items, size_t size, size_t count, FILE *stream)",
        "writes to a file",
        arguments(
            ("i[0]", "the file's number", "1"), ("i[1]", "position, -1 for the end", "byte"),
            ("size", "bytes", "byte"), ("data", "the bytes", "1"),
        ),
        arguments(("result", "position after the written data, or -errno", "byte")),
    ),
    RequestCode(
        "FILE_RESIZE", 11, "host", "int ftruncate(int fd, off_t size)",
        "truncates a file, or extends it with zeros",
        arguments(
            ("i[0]", "the file's number", "1"), ("i[1]", "size, -1 for no change", "byte")
        ),
        arguments(("result", "size, or -errno", "byte")),
    ),
    RequestCode(
        "FILE_REMOVE", 12, "host", "int remove(const char *name)", "removes the name of a file",
        arguments(("size", "length of the name", "byte"), ("data", "the name", "1")),
        arguments(("result", "0, or -errno", "1")),
    ),
    RequestCode(
        "FILE_RENAME", 13, "host", "int rename(const char *from, const char *to)",
        "renames a file",
        arguments(
            ("i[0]", "length of the old name", "byte"), ("size", "length of both", "byte"),
            ("data", "the old name, the new name", "1"),
        ),
        arguments(("result", "0, or -errno", "1")),
    ),
    RequestCode(
        "CLIENT", 14, "host", "int server_is_running(void)",
        "returns which of the vendor's two client libraries to imitate",
        (), arguments(("result", "0 Nclient, 1 Ndirect", "1")),
    ),
    RequestCode(
        "UNCONNECTED", 15, "host", "int connect_robot(long id, ...)",
        "reports, once, that the program calls its robot without a connection",
        (), arguments(("result", "0", "1")),
    ),
)  # fmt: skip
"""All requests that the host serves."""
