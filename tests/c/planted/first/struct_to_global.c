/* Assigned to a global, and read there. */
#include <stdio.h>
struct state { int mode, speed; } now;
static void start(void)
{
    struct state s;
    s.mode = 1;
    PLANT(, s.speed = 2);
    now = s;
}
int main(void)
{
    start();
    if (now.speed > 10) // error: uninitialised read
        puts("fast");
    puts("end");
    return 0;
}
