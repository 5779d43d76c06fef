/* Signals that a program sends to itself, and masks. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static volatile sig_atomic_t depth, seen;

static void nested(int signal)
{
    printf("begin %d at %d\n", signal, (int)depth++);
    if (seen++ == 0)
        raise(signal);    /* blocked until the handler returns */
    depth--;
    printf("end\n");
}

static void once(int signal, siginfo_t *info, void *context)
{
    (void)context;
    printf("once %d %d\n", signal, info->si_signo);
}

int main(void)
{
    struct sigaction action, before;
    sigset_t set, pending;

    printf("%d\n", signal(SIGUSR1, nested) == SIG_DFL);
    raise(SIGUSR1);
    printf("%d %d\n", signal(SIGUSR1, SIG_IGN) == nested, raise(SIGUSR1));
    memset(&action, 0, sizeof action);
    action.sa_sigaction = once;
    action.sa_flags = SA_SIGINFO | SA_RESETHAND;
    sigemptyset(&action.sa_mask);
    sigaddset(&action.sa_mask, SIGTERM);
    printf("%d\n", sigaction(SIGUSR2, &action, NULL));
    kill(getpid(), SIGUSR2);
    sigaction(SIGUSR2, NULL, &before);
    printf("%d\n", before.sa_handler == SIG_DFL);

    signal(SIGUSR2, nested);
    sigemptyset(&set);
    sigaddset(&set, SIGUSR2);
    sigprocmask(SIG_BLOCK, &set, NULL);
    raise(SIGUSR2);
    sigpending(&pending);
    printf("pending %d %d\n", sigismember(&pending, SIGUSR2), sigismember(&pending, SIGUSR1));
    sigprocmask(SIG_UNBLOCK, &set, NULL);
    raise(SIGCHLD);
    printf("%d %d\n", signal(SIGKILL, nested) == SIG_ERR, errno == EINVAL);
    printf("%d %d\n", raise(0), raise(99));
    return 0;
}
