/* Processes and users (POSIX unistd.h, sys/wait.h): a program is the only one of its machine. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <crs/descriptor.h>
#include <crs/refuse.h>

UNAVAILABLE(pid_t, fork, (void), -1, ENOSYS)
UNAVAILABLE(pid_t, vfork, (void), -1, ENOSYS)
UNAVAILABLE(int, execl, (const char *file, const char *argument, ...), -1, ENOSYS)
UNAVAILABLE(int, execlp, (const char *file, const char *argument, ...), -1, ENOSYS)
UNAVAILABLE(int, execle, (const char *file, const char *argument, ...), -1, ENOSYS)
UNAVAILABLE(int, execv, (const char *file, char *const arguments[]), -1, ENOSYS)
UNAVAILABLE(int, execvp, (const char *file, char *const arguments[]), -1, ENOSYS)
UNAVAILABLE(int, execve,
            (const char *file, char *const arguments[], char *const environment[]), -1, ENOSYS)
UNAVAILABLE(int, pipe, (int descriptors[2]), -1, ENOSYS)
UNAVAILABLE(FILE *, popen, (const char *command, const char *mode), NULL, ENOSYS)

int pclose(FILE *stream)
{
    (void)stream;
    errno = ECHILD;
    return -1;
}

/* There are no child processes. */
pid_t wait(int *status)
{
    (void)status;
    errno = ECHILD;
    return -1;
}

pid_t waitpid(pid_t child, int *status, int options)
{
    (void)child;
    (void)status;
    (void)options;
    errno = ECHILD;
    return -1;
}

pid_t getpid(void)
{
    return 1;
}

pid_t getppid(void)
{
    return 0;
}

pid_t getpgrp(void)
{
    return 1;
}

pid_t setsid(void)
{
    return 1;
}

uid_t getuid(void)
{
    return 0;
}

uid_t geteuid(void)
{
    return 0;
}

gid_t getgid(void)
{
    return 0;
}

gid_t getegid(void)
{
    return 0;
}

int setuid(uid_t user)
{
    (void)user;
    return 0;
}

int setgid(gid_t group)
{
    (void)group;
    return 0;
}

int seteuid(uid_t user)
{
    (void)user;
    return 0;
}

int setegid(gid_t group)
{
    (void)group;
    return 0;
}

int setreuid(uid_t user, uid_t effective)
{
    (void)effective;
    (void)user;
    return 0;
}

int setregid(gid_t group, gid_t effective)
{
    (void)effective;
    (void)group;
    return 0;
}

int setresuid(uid_t user, uid_t effective, uid_t saved)
{
    (void)saved;
    (void)user;
    (void)effective;
    return 0;
}

int setresgid(gid_t group, gid_t effective, gid_t saved)
{
    (void)saved;
    (void)group;
    (void)effective;
    return 0;
}

int gethostname(char *name, size_t size)
{
    if (size < sizeof "robot") {
        errno = ENAMETOOLONG;
        return -1;
    }
    strcpy(name, "robot");
    return 0;
}

char *getlogin(void)
{
    return "robot";
}

int nice(int increment)
{
    (void)increment;
    return 0;
}

int getpagesize(void)
{
    return 4096;
}

int getdtablesize(void)
{
    return CRS_DESCRIPTORS;
}

long sysconf(int name)
{
    switch (name) {
    case _SC_CLK_TCK:
        return 100;
    case _SC_OPEN_MAX:
        return CRS_DESCRIPTORS;
    case _SC_PAGESIZE:
        return 4096;
    case _SC_NPROCESSORS_CONF: case _SC_NPROCESSORS_ONLN:
        return 1;
    }
    errno = EINVAL;
    return -1;
}
