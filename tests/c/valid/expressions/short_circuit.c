/* && and || evaluate from left to right and stop early (C17 6.5.13, 6.5.14). */
#include <stdio.h>

static char trace[64];
static int length;

static int say(char name, int value)
{
    trace[length++] = name;
    return value;
}

static void show(int value)
{
    trace[length] = 0;
    printf("%d %s\n", value, trace);
    length = 0;
}

int main(void)
{
    int *null = 0, x = 5, n = 0;

    show(say('a', 0) && say('b', 1));
    show(say('a', 1) && say('b', 7));
    show(say('a', 0) || say('b', 0));
    show(say('a', 3) || say('b', 1));
    show(say('a', 1) && say('b', 0) || say('c', 1));
    show(say('a', 0) && say('b', 0) || say('c', 0));
    show(say('a', 0) || say('b', 1) && say('c', 1));
    show(!(say('a', 1) && say('b', 1)) || say('c', 0));
    show((say('a', 0) || say('b', 1)) && (say('c', 0) || say('d', 9)));
    if (null && *null)
        printf("never\n");
    if (!null || *null == 0)
        printf("guarded\n");
    x && (n = 1);
    x - 5 || (n += 10);
    printf("%d\n", n);
    for (n = 0; n < 10 && say('l', n) < 4; n++)
        ;
    show(n);
    show((say('a', 0), say('b', 2)) && 0.5);
    show(0.0 || say('z', 0));
    return 0;
}
