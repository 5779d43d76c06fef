"""The requests that a program's host computer serves: streams, time, arguments, files."""

from __future__ import annotations

from typing import Final

from crs_cc.requests.request import Request, fields

HOST_REQUESTS: Final = (
    Request(
        "EXIT", 1, "host", "void exit(int status)", "ends the program",
        fields(("status", "i[0]", "1", "exit status")),
    ),
    Request(
        "WRITE", 2, "host", "int write(int fd, const void *bytes, unsigned count)",
        "writes to the standard output (1) or error (2) stream",
        fields(
            ("stream", "i[0]", "1", "stream"),
            ("size", "size", "byte", "bytes"),
            ("bytes", "data", "1", "the bytes"),
        ),
        fields(("count", "result", "byte", "bytes written, -1 on error")),
    ),
    Request(
        "READ", 3, "host", "int read(int fd, void *bytes, unsigned count)",
        "reads from the standard input stream (0)",
        fields(("stream", "i[0]", "1", "stream"), ("count", "i[1]", "byte", "requested bytes")),
        fields(
            ("count", "result", "byte", "bytes read, 0 at the end, -1 on error"),
            ("size", "size", "byte", "bytes"), ("bytes", "data", "1", "the bytes"),
        ),
    ),
    Request(
        "CLOCK", 4, "host", "int gettimeofday(struct timeval *now, void *zone)",
        "reads the program's simulated clock",
        (), fields(("time_s", "f[0]", "s", "time since the start of the run"),
                       ("cpu_s", "f[1]", "s", "processor time used")),
    ),
    Request(
        "SLEEP", 5, "host", "int usleep(unsigned microseconds)",
        "waits for some simulated time",
        fields(("duration_s", "f[0]", "s", "duration")), fields(("zero", "result", "1", "0")),
    ),
    Request(
        "ARGUMENT", 6, "host", "int main(int argc, char **argv)",
        "reads a piece of one of the program's arguments",
        fields(
            ("number", "i[0]", "1", "number of the argument"),
            ("first", "i[1]", "byte", "first requested byte"),
        ),
        fields(
            ("length", "result", "byte", "length of the argument, -1 if there is none"),
            ("size", "size", "byte", "bytes"), ("piece", "data", "1", "the piece"),
        ),
    ),
    Request(
        "FILE_OPEN", 7, "host", "FILE *fopen(const char *name, const char *mode)",
        "opens a file on the robot's own disk, or creates it",
        fields(
            ("flags", "i[0]", "1", "flags: O_CREAT, O_EXCL, O_TRUNC, O_TMPFILE of fcntl.h"),
            ("size", "size", "byte", "length of the name"), ("name", "data", "1", "the name"),
        ),
        fields(("number", "result", "1", "the file's number, or -errno")),
    ),
    Request(
        "FILE_CLOSE", 8, "host", "int close(int fd)", "closes an open file",
        fields(("number", "i[0]", "1", "the file's number")),
        fields(("zero", "result", "1", "0, or -errno")),
    ),
    Request(
        "FILE_READ", 9, "host",
        "size_t fread(void *items, size_t size, size_t count, FILE *stream)",
        "reads from a file",
        fields(
            ("number", "i[0]", "1", "the file's number"),
            ("first", "i[1]", "byte", "first requested byte"),
            ("count", "i[2]", "byte", "requested bytes"),
        ),
        fields(
            ("count", "result", "byte", "bytes read, 0 at the end, or -errno"),
            ("size", "size", "byte", "bytes"), ("bytes", "data", "1", "the bytes"),
        ),
    ),
    Request(
        "FILE_WRITE", 10, "host",
        "size_t fwrite(const void *items, size_t size, size_t count, FILE *stream)",
        "writes to a file",
        fields(
            ("number", "i[0]", "1", "the file's number"),
            ("position", "i[1]", "byte", "position, -1 for the end"),
            ("size", "size", "byte", "bytes"), ("bytes", "data", "1", "the bytes"),
        ),
        fields(("end", "result", "byte", "position after the written bytes, or -errno")),
    ),
    Request(
        "FILE_RESIZE", 11, "host", "int ftruncate(int fd, off_t size)",
        "truncates a file, or extends it with zeros",
        fields(
            ("number", "i[0]", "1", "the file's number"),
            ("length", "i[1]", "byte", "size, -1 for no change"),
        ),
        fields(("length", "result", "byte", "size, or -errno")),
    ),
    Request(
        "FILE_REMOVE", 12, "host", "int remove(const char *name)", "removes a file",
        fields(("size", "size", "byte", "length of the name"), ("name", "data", "1", "the name")),
        fields(("zero", "result", "1", "0, or -errno")),
    ),
    Request(
        "FILE_RENAME", 13, "host", "int rename(const char *from, const char *to)",
        "renames a file",
        fields(
            ("old_size", "i[0]", "byte", "length of the old name"),
            ("size", "size", "byte", "length of both"),
            ("names", "data", "1", "the old name, the new name"),
        ),
        fields(("zero", "result", "1", "0, or -errno")),
    ),
    Request(
        "CLIENT", 14, "host", "int server_is_running(void)",
        "returns which of the vendor's two client libraries is emulated",
        (), fields(("client", "result", "1", "0 Nclient, 1 Ndirect")),
    ),
    Request(
        "UNCONNECTED", 15, "host", "int connect_robot(long id, ...)",
        "reports, once, that the program calls its robot without a connection",
        (), fields(("zero", "result", "1", "0")),
    ),
    Request(
        "FILE_LIST", 17, "host", "struct dirent *readdir(DIR *folder)",
        "returns the name of an entry of a folder, with a slash if it is a folder",
        fields(
            ("index", "i[0]", "1", "number of the entry, by name, from 0"),
            ("size", "size", "byte", "length of the folder's name"),
            ("name", "data", "1", "the folder's name"),
        ),
        fields(
            ("count", "result", "byte", "length of the entry's name, 0 at the end, or -errno"),
            ("length", "size", "byte", "the same"), ("entry", "data", "1", "the entry's name"),
        ),
    ),
    Request(
        "INPUT", 16, "host", "int select(int count, fd_set *readable, ...)",
        "returns how much of the standard input can be read, and when there will be more",
        (),
        fields(
            ("count", "result", "byte", "bytes, 0 also at the end"),
            ("wait", "f[0]", "s", "time until a read returns, 0 for at once, inf if not known"),
        ),
    ),
)  # fmt: skip
"""All requests that the host serves."""
