"""The POSIX part of the library: waiting, alarms, messages, and unsupported functions."""

from __future__ import annotations

from pathlib import Path

from crs_cc.sim.files.world_xml import empty_world
from tests.runtime.library_runner import run
from tests.session.programs import Recorded, build

HEADERS = """
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>
"""


def lines(source: str) -> list[str]:
    """Return what a program with these functions prints, when it ends well."""
    outcome = run(HEADERS + source)
    assert (outcome.err, outcome.error, outcome.status) == (b"", "", 0)
    return outcome.out.decode().splitlines()


def test_an_alarm_ends_a_wait() -> None:
    source = r"""
    static int rings;
    static void ring(int signal) { rings += signal == SIGALRM; }
    static double now(void)
    {
        struct timeval time;
        gettimeofday(&time, NULL);
        return time.tv_sec - 946684800 + time.tv_usec * 1e-6;
    }
    int main(void)
    {
        struct timespec wanted = {3, 0}, left;
        struct itimerval every = {{0, 250000}, {0, 500000}}, never = {{0, 0}, {0, 0}}, before;
        struct timeval wait = {10, 0};
        signal(SIGALRM, ring);
        printf("%u %u\n", alarm(2), alarm(3));
        printf("%u", sleep(10));
        printf(" %d %.3f\n", rings, now());
        alarm(1);
        printf("%d", nanosleep(&wanted, &left));
        printf(" %d %ld %d %.3f\n", errno == EINTR, (long)left.tv_sec, rings, now());
        alarm(5);
        printf("%u", alarm(0));
        printf(" %u %d\n", sleep(6), rings);
        setitimer(ITIMER_REAL, &every, NULL);
        printf("%d", select(0, NULL, NULL, NULL, &wait));
        printf(" %d %ld %d\n", errno == EINTR, (long)wait.tv_sec, rings);
        pause();
        pause();
        setitimer(ITIMER_REAL, &never, &before);
        printf("%d %ld %.3f\n", rings, (long)before.it_interval.tv_usec, now());
        sleep(2);
        printf("%d\n", rings);
        return 0;
    }
    """
    assert lines(source) == [
        "3 0",  # the arguments from the last to the first
        "8 1 2.000",
        "-1 1 2 2 3.000",
        "5 0 2",
        "-1 1 9 3",
        "5 250000 10.000",
        "5",
    ]


def test_an_alarm_without_handler_ends_the_program() -> None:
    outcome = run(HEADERS + 'int main(void) { alarm(1); puts("x"); sleep(5); puts("y"); }')
    assert (outcome.out, outcome.error) == (b"x\n", "unhandled signal")
    assert outcome.err == b"signal 14 (Alarm clock) is not handled\n"


def test_an_alarm_interrupts_a_robot_call(tmp_path: Path) -> None:
    source = r"""
    #include "Nclient.h"
    #include <signal.h>
    #include <stdio.h>
    #include <unistd.h>
    static volatile sig_atomic_t over;
    static void ring(int signal) { over = signal; }
    int main(void)
    {
        int rounds = 0;
        connect_robot(1);
        signal(SIGALRM, ring);
        alarm(1);
        while (!over) {
            get_sn();
            rounds++;
        }
        printf("%d\n", rounds > 10);
        return 0;
    }
    """
    recorded = Recorded(empty_world(), [build(tmp_path, source)], 0)
    for _ in range(100):
        if not recorded.session.step():
            break
    assert recorded.written[0].endswith(b"1\n")
    assert 0.9 < recorded.session.result().robots[0].time_s < 1.2


def test_input_at_its_end_and_output_are_ready() -> None:
    source = r"""
    #include <poll.h>
    int main(void)
    {
        struct timeval wait = {1, 500000};
        struct pollfd files[2] = {{0, POLLIN, 0}, {1, POLLOUT, 0}};
        fd_set in, out;
        FD_ZERO(&in);
        FD_SET(0, &in);
        printf("%d %d", select(1, &in, NULL, NULL, &wait), FD_ISSET(0, &in) != 0);
        printf(" %ld\n", (long)time(NULL));
        FD_SET(0, &in);
        FD_ZERO(&out);
        FD_SET(1, &out);
        printf("%d", select(2, &in, &out, NULL, &wait));
        printf(" %d %d\n", FD_ISSET(0, &in) != 0, FD_ISSET(1, &out) != 0);
        FD_SET(0, &in);
        printf("%d\n", select(1, &in, NULL, NULL, NULL));
        FD_SET(40, &in);
        printf("%d", select(41, &in, NULL, NULL, NULL));
        printf(" %d\n", errno == EBADF);
        printf("%d", poll(files, 2, 1000));
        printf(" %d %d\n", files[0].revents, files[1].revents);
        printf("%d %ld\n", poll(files, 1, 2500), (long)time(NULL));
        return 0;
    }
    """
    assert lines(source) == [
        "1 1 946684800",
        "2 1 1",
        "1",
        "-1 1",
        "2 1 4",
        "1 946684800",
    ]


def test_the_time_functions_before_gettimeofday_work() -> None:
    source = r"""
    #include <sys/timeb.h>
    int main(void)
    {
        struct timeb now;
        usleep(2345678);
        printf("%d", ftime(&now));
        printf(" %ld %d %d\n", (long)now.time - 946684800, now.millitm, now.timezone);
        return 0;
    }
    """
    assert lines(source) == ["0 2 345 0"]


def test_fionread_reports_the_readable_bytes() -> None:
    source = r"""
    #include <fcntl.h>
    #include <sys/ioctl.h>
    int main(void)
    {
        int waiting = -1, on = 1, file = open("log", O_RDWR | O_CREAT, 0600);
        printf("%d", ioctl(0, FIONREAD, &waiting));
        printf(" %d\n", waiting);
        write(file, "abcde", 5);
        lseek(file, 2, SEEK_SET);
        ioctl(file, FIONREAD, &waiting);
        printf("%d %d\n", waiting, ioctl(0, FIONBIO, &on));
        printf("%d", ioctl(0, TIOCGWINSZ, &on) < 0 && errno == ENOTTY);
        printf(" %d\n", ioctl(50, FIONREAD, &waiting) < 0 && errno == EBADF);
        return 0;
    }
    """
    assert lines(source) == ["0 0", "3 0", "1 1"]


def test_memory_comes_by_the_page_and_a_file_as_a_copy() -> None:
    source = r"""
    #include <fcntl.h>
    #include <sys/mman.h>
    static void *map(int protection, int flags, int file, long offset)
    {
        return mmap(NULL, 6000, protection, flags, file, offset);
    }
    int main(void)
    {
        int i, zero = 1, both = PROT_READ | PROT_WRITE, file = open("map", O_RDWR | O_CREAT, 0600);
        char *memory = map(both, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0), *copy;
        for (i = 0; i < 8192; i++)
            zero &= memory[i] == 0;
        printf("%d %d %d\n", zero, (unsigned)memory % getpagesize() == 0, mlockall(MCL_CURRENT));
        memset(memory, 'a', 4096);
        strcpy(memory + 4096, "second page");
        write(file, memory, 5000);
        printf("%d %d\n", munmap(memory + 1, 1), munmap(memory, 6000));
        copy = map(both, MAP_PRIVATE, file, 0);
        printf("%c %s %d", copy[4095], copy + 4096, copy[5000]);
        copy[0] = 'b';
        printf(" %ld %d\n", (long)lseek(file, 0, SEEK_CUR), munmap(copy, 6000));
        copy = map(PROT_READ, MAP_SHARED, file, 4096);
        printf("%s\n", copy);
        lseek(file, 0, SEEK_SET);
        read(file, &i, 1);
        printf("%c\n", i);
        printf("%d", map(both, MAP_SHARED, file, 0) == MAP_FAILED);
        printf(" %d", errno == ENODEV);
        printf(" %d", map(both, MAP_PRIVATE, 40, 0) == MAP_FAILED && errno == EBADF);
        printf(" %d", map(both, MAP_PRIVATE, 0, 0) == MAP_FAILED && errno == ENODEV);
        printf(" %d\n", map(both, MAP_PRIVATE, file, 7) == MAP_FAILED && errno == EINVAL);
        return 0;
    }
    """
    assert lines(source) == [
        "1 1 0",
        "-1 0",
        "a second page 0 5000 0",
        "second page",
        "a",
        "1 1 1 1 1",
    ]


def test_unsupported_calls_are_reported_once() -> None:
    source = r"""
    #include <dirent.h>
    #include <sys/ioctl.h>
    #include <sys/wait.h>
    #include <termios.h>
    int main(void)
    {
        struct termios settings;
        int i, pair[2];
        for (i = 0; i < 2; i++) {
            printf("%d", (int)fork());
            printf(" %d\n", errno == ENOSYS);
        }
        printf("%d %d %d\n", system("ls"), system(NULL), popen("ls", "r") == NULL);
        printf("%d %d\n", chdir("x") == -1, pipe(pair));
        printf("%d %d %d\n", execl("/bin/sh", "sh", NULL), (int)wait(NULL), errno == ECHILD);
        printf("%d", tcgetattr(0, &settings));
        printf(" %d", errno == ENOTTY);
        printf(" %d %d\n", ioctl(0, TIOCGWINSZ), isatty(1));
        return 0;
    }
    """
    outcome = run(HEADERS + source)
    said = "() is not available to a simulated robot's program: it fails\n"
    names = ["fork", "popen", "system", "pipe", "chdir", "execl"]
    assert outcome.err.decode() == "".join(name + said for name in names)
    assert outcome.out.decode().splitlines() == [
        "-1 1", "-1 1", "-1 0 1", "1 -1", "-1 -1 0", "-1 1 -1 0",
    ]  # fmt: skip


def test_messages_begin_with_the_programs_name() -> None:
    source = r"""
    #include <err.h>
    #include <error.h>
    #include <syslog.h>
    int main(void)
    {
        errno = ENOENT;
        warn("file %d", 1);
        warnx("only %s", "text");
        error(0, EACCES, "part %d", 2);
        error(0, 0, "plain");
        openlog("robot", 0, LOG_USER);
        syslog(LOG_ERR, "log %d", 3);
        setlogmask(LOG_UPTO(LOG_ERR));
        syslog(LOG_DEBUG, "hidden");
        psignal(SIGTERM, "why");
        errx(4, "end");
    }
    """
    outcome = run(HEADERS + source)
    assert outcome.status == 4
    assert outcome.err.decode().splitlines() == [
        "program.c: file 1: No such file or directory",
        "program.c: only text",
        "program.c: part 2: Permission denied",
        "program.c: plain",
        "robot: log 3",
        "why: Terminated",
        "program.c: end",
    ]


def test_user_host_and_folder_of_a_program() -> None:
    source = r"""
    #include <pwd.h>
    #include <sys/resource.h>
    #include <sys/times.h>
    #include <sys/utsname.h>
    int main(int argc, char **argv, char **environment)
    {
        char name[64];
        struct utsname system;
        struct rusage used;
        struct tms ticks;
        gethostname(name, sizeof name);
        uname(&system);
        printf("%s %s %s\n", name, system.nodename, getpwuid(getuid())->pw_name);
        printf("%d %d %s\n", getpid(), getppid(), getcwd(name, sizeof name));
        printf("%d %d %d\n", environment[0] == NULL, *environ == NULL, getenv("HOME") == NULL);
        sleep(2);
        getrusage(RUSAGE_SELF, &used);
        printf("%ld %ld", (long)used.ru_utime.tv_sec, (long)times(&ticks));
        printf(" %ld\n", (long)ticks.tms_utime);
        printf("%ld %d\n", sysconf(_SC_CLK_TCK), setlogin_is_not_here());
        return 0;
    }
    int setlogin_is_not_here(void) { return chdir("/") == 0; }
    """
    outcome = run(HEADERS + source)
    assert outcome.out.decode().splitlines() == [
        "robot robot robot", "1 0 /", "1 1 1", "1 200 100", "100 0",
    ]  # fmt: skip


def test_strings_of_openbsd() -> None:
    source = r"""
    int main(void)
    {
        char text[8];
        printf("%u %s\n", strlcpy(text, "robot", 8), text);
        printf("%u ", strlcpy(text, "longer than that", 8));
        printf("%s\n", text);
        text[3] = 0;
        printf("%u ", strlcat(text, "abcdefgh", 8));
        printf("%s %u %u\n", text, strlcpy(text, "xyz", 0), strlcat(text, "q", 2));
        return 0;
    }
    """
    assert lines(source)[1:] == ["16 longer ", "11 lonabcd 3 3"]


def test_a_program_knows_its_name_before_main() -> None:
    source = r"""
    extern const char *__progname;
    int main(void)
    {
        printf("%s %s %s\n", program_invocation_name, program_invocation_short_name, __progname);
        setprogname("bin/turn");
        printf("%s %d\n", getprogname(), setregid(getgid(), getegid()));
        return 0;
    }
    """
    assert lines(source) == ["program.c program.c program.c", "turn 0"]


def test_the_end_of_the_data_segment_moves() -> None:
    source = r"""
    #include <errno.h>
    int main(void)
    {
        char *first = sbrk(0), *got = sbrk(100);
        int i, zero = 1;
        for (i = 0; i < 100; i++)
            zero &= got[i] == 0;
        memset(got, 'a', 100);
        printf("%d %d ", got == first, zero);
        got = sbrk(50);
        printf("%d %d ", got - first, brk(first + 10));
        got = sbrk(-10);
        printf("%d %d\n", got - first, (char *)sbrk(0) - first);
        printf("%d ", sbrk(-1) == (void *)-1);
        printf("%d ", errno == ENOMEM);
        printf("%d %d\n", brk(first + 0x300000), sbrk(0) == first);
        return 0;
    }
    """
    assert lines(source) == ["1 1 100 0 10 0", "1 1 -1 1"]


def test_select_h_alone_has_the_times_of_its_functions() -> None:
    source = r"""#include <sys/select.h>
    int main(void)
    {
        struct timespec short_time = {0, 1000};
        struct timeval longer = {0, 10};
        return pselect(0, 0, 0, 0, &short_time, 0) + select(0, 0, 0, 0, &longer);
    }
    """
    outcome = run(source)
    assert (outcome.error, outcome.status) == ("", 0)
