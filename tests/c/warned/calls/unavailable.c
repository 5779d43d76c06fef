/* Functions that link and always fail are named before the run; those of the program are its own. */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int pipe(int ends[2]) { return ends[0]; }

static void *work(void *argument)
{
    return argument;
}

int main(void)
{
    int ends[2] = {0, 0};
    pthread_t thread;

    if (fork() == 0) // warning: 'fork' always fails here: a robot runs one process
        execlp("ls", "ls", (char *)0); // warning: 'execlp' always fails here
    if (fork() > 0)
        puts("parent");
    if (popen("ls", "r")) // warning: 'popen' always fails here: there are no other programs
        return system("ls"); // warning: 'system' always fails here
    if (pthread_create(&thread, 0, work, 0)) // warning: 'pthread_create' always fails here
        return pipe(ends);
    return 0;
}
