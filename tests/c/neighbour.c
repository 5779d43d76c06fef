/* The program beside a hostile one in test_hostile.py: drives, looks, computes and prints. */
#include <stdio.h>
#include <stdlib.h>
#include "Nclient.h"

int main(void)
{
    int order[16] = { 0, 1, 15, 255 };
    long *log = malloc(100 * sizeof *log);
    int i;

    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    conf_sn(5, order);
    for (i = 0;; i++) {
        vm(60 + i % 40, 60 - i % 40, 0);
        get_sn();
        log[i % 100] = State[STATE_SONAR_0] + State[STATE_CONF_X];
        printf("%d at (%ld, %ld) sees %ld\n", i, State[STATE_CONF_X], State[STATE_CONF_Y],
               log[i / 2 % 100]);
    }
}
