/* The name of a robot is a literal that is cut at its first blank. */
#include <stdio.h>
#include <string.h>

struct robot {
    char *name;
    int id;
};

static void cut(char *name)
{
    char *blank = strchr(name, ' ');

    if (blank)
        *blank = '\0'; // error: write to read-only memory
}

int main(void)
{
    char own[] = "scout two";
    struct robot robot = {PLANT("scout two", own), 2};

    cut(robot.name);
    printf("%s %d\n", robot.name, robot.id + own[0]);
    return 0;
}
