/* One of many is left out. */
#include <stdio.h>
struct place { int x, y; };
static struct place all[4];
int main(void)
{
    int i, far = 0;
    for (i = 0; i < 4; i++) {
        struct place p;
        p.x = i;
        if (i != PLANT(3, 7))
            p.y = -i;
        all[i] = p;
    }
    for (i = 0; i < 4; i++)
        if (all[i].x - all[i].y > 4) // error: uninitialised read
            far++;
    printf("%d\n", far);
    return 0;
}
