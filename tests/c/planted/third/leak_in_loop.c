/* A name is made for each robot, and none is freed. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static char *name_of(int i)
{
    char *name = malloc(20); // leak: 3
    sprintf(name, "robot%d", i);
    return name;
}
int main(void)
{
    int i, n = 0;
    for (i = 0; i < 3; i++) {
        char *name = name_of(i);
        n += strlen(name);
        PLANT(name = 0, free(name));
    }
    printf("%d\n", n);
    return 0;
}
