/* Two robots: each goes its own way, by its name, and says so. */
#include <stdio.h>
#include <string.h>
#include "Nclient.h"

static void turn(int tenths)
{
    pr(tenths, -tenths, 0);
    ws(1, 1, 0, 3);
}

int main(int argc, char **argv)
{
    int id = argc > 1 && strcmp(argv[1], "left") == 0 ? 1 : 2;

    connect_robot(id);
    printf("robot %d\n", id);
    if (id == 1)
        turn(30);
    pr(20, 20, 0);
    ws(1, 1, 0, 3);
    printf("done at %ld, %ld\n", State[STATE_CONF_X], State[STATE_CONF_Y]);
    return id;
}
