#include <Nclient.h>

/* The nearest things around the robot, by the numbers of their sonars. */
static int readings[8];

static int worst(int first, int last)
{
    int i, found = 0;

    for (i = first; i <= last; i++)
        if (readings[i] > found)
            found = readings[i];
    return found;
}

int main(void)
{
    int i, step;

    connect_robot(1);
    vm(100, 100, 0);
    for (step = 0; step < 400; step++) {
        get_sn();
        for (i = 0; i < 8; i++)
            readings[i] = State[STATE_SONAR_0 + i];
        worst(step / 50, step / 50 + 3);
    }
    return 0;
}
