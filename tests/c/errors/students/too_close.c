/* A distance of 0 that nobody thought of, in a macro. */
#include <stdio.h>

#define GAIN 300
#define SPEED(distance) (GAIN / (distance))

static int speed_for(int sonar, int bumper)
{
    return SPEED(sonar - bumper) + 10; // error: division by zero
}

int main(void)
{
    printf("%d\n", speed_for(30, 5));
    printf("%d\n", speed_for(5, 5));
    return 0;
}
