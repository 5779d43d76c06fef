/* siglongjmp out of a handler lets its signal come again, when sigsetjmp kept the mask. */
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>

static sigjmp_buf late;
static volatile sig_atomic_t came;

static void handler(int signal)
{
    came++;
    siglongjmp(late, signal);
}

static int is_blocked(void)
{
    sigset_t now;

    sigprocmask(SIG_BLOCK, NULL, &now);
    return sigismember(&now, SIGUSR1);
}

int main(void)
{
    volatile int round;
    sigset_t usr1;

    signal(SIGUSR1, handler);
    for (round = 0; round < 3; round++)
        if (sigsetjmp(late, 1) == 0)
            raise(SIGUSR1);
    printf("kept: came %d, blocked %d\n", came, is_blocked());

    for (round = 0; round < 3; round++)
        if (sigsetjmp(late, 0) == 0)
            raise(SIGUSR1);
    printf("not kept: came %d, blocked %d\n", came, is_blocked());

    sigemptyset(&usr1);
    sigaddset(&usr1, SIGUSR1);
    if (sigsetjmp(late, 1) == 0)
        sigprocmask(SIG_UNBLOCK, &usr1, NULL);
    printf("pending: came %d, blocked %d\n", came, is_blocked());
    return 0;
}
