/* Sets of signals, and their BSD forms (POSIX signal.h). */
#include <errno.h>
#include <signal.h>
#include <stdio.h>

const char *const sys_siglist[NSIG] = {
    NULL, "Hangup", "Interrupt", "Quit", "Illegal instruction", "Trace/breakpoint trap", "Aborted",
    "Bus error", "Floating point exception", "Killed", "User defined signal 1",
    "Segmentation fault", "User defined signal 2", "Broken pipe", "Alarm clock", "Terminated",
    "Stack fault", "Child exited", "Continued", "Stopped (signal)", "Stopped",
    "Stopped (tty input)", "Stopped (tty output)", "Urgent I/O condition",
    "CPU time limit exceeded", "File size limit exceeded", "Virtual timer expired",
    "Profiling timer expired", "Window changed", "I/O possible", "Power failure",
    "Bad system call",
};

static int is_signal(int signal)
{
    if (signal > 0 && signal < NSIG)
        return 1;
    errno = EINVAL;
    return 0;
}

int sigemptyset(sigset_t *set)
{
    *set = 0;
    return 0;
}

int sigfillset(sigset_t *set)
{
    *set = ~0UL;
    return 0;
}

int sigaddset(sigset_t *set, int signal)
{
    if (!is_signal(signal))
        return -1;
    *set |= sigmask(signal);
    return 0;
}

int sigdelset(sigset_t *set, int signal)
{
    if (!is_signal(signal))
        return -1;
    *set &= ~sigmask(signal);
    return 0;
}

int sigismember(const sigset_t *set, int signal)
{
    return is_signal(signal) ? (*set & sigmask(signal)) != 0 : -1;
}

char *strsignal(int signal)
{
    static char unknown[32];

    if (signal > 0 && signal < NSIG)
        return (char *)sys_siglist[signal];
    sprintf(unknown, "Unknown signal %d", signal);
    return unknown;
}

void psignal(int signal, const char *text)
{
    if (text != NULL && *text)
        fprintf(stderr, "%s: ", text);
    if (signal > 0 && signal < NSIG)
        fprintf(stderr, "%s\n", sys_siglist[signal]);
    else
        fprintf(stderr, "Unknown signal %d\n", signal);
}
