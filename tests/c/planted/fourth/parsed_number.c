/* A number of a line, if it has one. */
#include <stdio.h>

static int angle_of(const char *line)
{
    int angle PLANT(, = 0);

    sscanf(line, "turn %d", &angle);
    return angle; // error: uninitialised read
}

int main(void)
{
    printf("%d\n", angle_of("turn 45") + angle_of("stop"));
    return 0;
}
