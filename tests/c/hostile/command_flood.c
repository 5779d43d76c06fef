/* Commands as fast as the link takes them, with absurd values, on a connected robot. */
// ends: running
#include "Nclient.h"

int main(void)
{
    int i;

    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0;; i++) {
        vm(2147483647 - i, -2147483647 + i, i);
        pr(-2147483647 - 1, 2147483647, 0);
        ac(0, -1, 0);
        sp(0, 0, 0);
        dp(i << 20, -i << 18);
        da(-i, i);
        conf_tm(i);
        conf_sn(-i, 0);
        mv(i, i, -i, i, 7, 7);
        ws(1, 1, 1, 1);
        zr();
        get_sn();
    }
}
