/* Example: a signal for which the program has no handler. */
#include <signal.h>
#include <stdio.h>

static void watchdog(int signal)
{
    printf("signal %d\n", signal);
}

int main(void)
{
    signal(SIGUSR1, watchdog);
    raise(SIGUSR1);
    raise(SIGTERM); // error: unhandled signal
    return 0;
}
