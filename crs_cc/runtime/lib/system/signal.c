/* Signals (C17 7.14; sigaction and masks: POSIX). As on Linux a handler stays after its signal,
   which is blocked while it runs. */
#include <crs_request.h>
#include <errno.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>

#include <crs/signals.h>
#include <crs/stream.h>
#include <crs/write.h>

#define BIT(signal) (1UL << ((signal) - 1))
#define IGNORED (BIT(SIGCHLD) | BIT(SIGCONT) | BIT(SIGURG) | BIT(SIGWINCH) | BIT(SIGSTOP) | \
                 BIT(SIGTSTP) | BIT(SIGTTIN) | BIT(SIGTTOU))

static struct sigaction actions[NSIG];
static sigset_t blocked, pending;

static int is_signal(int signal)
{
    if (signal > 0 && signal < NSIG)
        return 1;
    errno = EINVAL;
    return 0;
}

/* The default action of a signal. */
static void end_program(int signal)
{
    char text[64];

    if (BIT(signal) & IGNORED)
        return;
    __crs_flush_all();
    sprintf(text, "signal %d (%s) is not handled\n", signal, sys_siglist[signal]);
    __crs_complain(text, "");
    if (signal == SIGABRT)
        __crs_stop("abort called");
    __crs_stop("unhandled signal");
}

static void deliver(int signal)
{
    struct sigaction action = actions[signal];
    sigset_t before = blocked;
    siginfo_t info = {signal, 0, 0, 1, 0, NULL};

    if (action.sa_handler == SIG_IGN)
        return;
    if (action.sa_handler == SIG_DFL) {
        end_program(signal);
        return;
    }
    if (action.sa_flags & SA_RESETHAND)
        actions[signal].sa_handler = SIG_DFL;
    blocked |= action.sa_mask | (action.sa_flags & SA_NODEFER ? 0 : BIT(signal));
    if (action.sa_flags & SA_SIGINFO)
        action.sa_sigaction(signal, &info, NULL);
    else
        action.sa_handler(signal);
    blocked = before;
}

static void deliver_pending(void)
{
    int signal;

    while (pending & ~blocked) {
        signal = __builtin_ctzl(pending & ~blocked) + 1;
        pending &= ~BIT(signal);
        deliver(signal);
    }
}

void __crs_signal(int signal)
{
    pending |= BIT(signal);
    deliver_pending();
}

/* Number 0 only checks whether a signal could be sent. */
static int send(int signal)
{
    if (signal == 0)
        return 0;
    if (!is_signal(signal))
        return -1;
    __crs_signal(signal);
    return 0;
}

int raise(int signal)
{
    return send(signal);
}

/* The program is the only process, number 1. */
int kill(pid_t process, int signal)
{
    if (process > 1) {
        errno = ESRCH;
        return -1;
    }
    return send(signal);
}

int killpg(pid_t group, int signal)
{
    if (group > 1) {
        errno = ESRCH;
        return -1;
    }
    return send(signal);
}

static void run_abort_handler(void)
{
    if (actions[SIGABRT].sa_handler != SIG_DFL)
        deliver(SIGABRT);
}

static int set_action(int signal, const struct sigaction *action)
{
    if (signal == SIGKILL || signal == SIGSTOP) {
        errno = EINVAL;
        return -1;
    }
    actions[signal] = *action;
    if (signal == SIGABRT)
        __crs_on_abort = run_abort_handler;
    return 0;
}

__sighandler_t signal(int signal, __sighandler_t handler)
{
    struct sigaction action = {{handler}, 0, SA_RESTART, NULL};
    __sighandler_t before;

    if (!is_signal(signal))
        return SIG_ERR;
    before = actions[signal].sa_handler;
    return set_action(signal, &action) < 0 ? SIG_ERR : before;
}

int __crs_restarts(int signal)
{
    return (actions[signal].sa_flags & SA_RESTART) != 0;
}

int sigaction(int signal, const struct sigaction *action, struct sigaction *before)
{
    struct sigaction old;

    if (!is_signal(signal))
        return -1;
    old = actions[signal];
    if (action != NULL && set_action(signal, action) < 0)
        return -1;
    if (before != NULL)
        *before = old;
    return 0;
}

static void set_mask(sigset_t mask)
{
    blocked = mask & ~(BIT(SIGKILL) | BIT(SIGSTOP));
    deliver_pending();
}

int sigprocmask(int how, const sigset_t *set, sigset_t *before)
{
    sigset_t old = blocked;

    if (set != NULL && how == SIG_BLOCK)
        blocked |= *set;
    else if (set != NULL && how == SIG_UNBLOCK)
        blocked &= ~*set;
    else if (set != NULL && how == SIG_SETMASK)
        blocked = *set;
    else if (set != NULL) {
        errno = EINVAL;
        return -1;
    }
    set_mask(blocked);
    if (before != NULL)
        *before = old;
    return 0;
}

unsigned long __crs_swap_mask(unsigned long mask)
{
    unsigned long before = blocked;

    blocked = mask;
    set_mask(blocked);
    return before;
}

/* The signal mask saved by sigsetjmp: never 0, as SIGKILL cannot be blocked. */
unsigned long __crs_unblocked(void)
{
    return ~blocked;
}

void siglongjmp(sigjmp_buf buffer, int value)
{
    if (buffer->activation != 0 && buffer->unblocked != 0)
        set_mask(~buffer->unblocked);
    longjmp(buffer, value);
}

/* BSD's forms of the same. */
int sigblock(int mask)
{
    sigset_t before = blocked;

    set_mask(blocked | mask);
    return before;
}

int sigsetmask(int mask)
{
    sigset_t before = blocked;

    set_mask(mask);
    return before;
}

/* An alarm always interrupts blocking calls, whatever is requested. */
int siginterrupt(int signal, int flag)
{
    (void)signal;
    (void)flag;
    return 0;
}

int sigpending(sigset_t *set)
{
    *set = pending;
    return 0;
}

int sigsuspend(const sigset_t *mask)
{
    sigset_t before = blocked;

    blocked = *mask;
    if (pending & ~blocked)
        deliver_pending();
    else
        __crs_await_signal(blocked);
    blocked = before;
    errno = EINTR;
    return -1;
}
