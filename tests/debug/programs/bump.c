/* Drives ahead until a bumper is pressed, backs off, and says how often it has. */
#include <stdio.h>
#include "Nclient.h"

#define SPEED 100
#define LONGEST 400

static int bumps;
static long x[LONGEST];

static int is_pressed(void)
{
    get_bp();
    return State[STATE_BUMPER] != 0;
}

static void back_off(void)
{
    bumps++;
    pr(-50, -50, 0);
    ws(1, 1, 0, 5);
}

int main(void)
{
    int i;

    connect_robot(1);
    for (i = 0; i < LONGEST && bumps < 2; i++) {
        vm(SPEED, SPEED, 0);
        get_rc();
        x[i] = State[STATE_CONF_X];
        if (is_pressed())
            back_off();
    }
    st();
    printf("%d bumps after %d rounds, at %ld\n", bumps, i, x[i - 1]);
    disconnect_robot(1);
    return 0;
}
