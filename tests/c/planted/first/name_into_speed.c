/* A name that runs into the member behind it. */
#include <stdio.h>
struct robot { char name[8]; int speed; };
int main(void)
{
    struct robot r = {"", 20};
    const char *from = PLANT("wanderer", "wander");
    int i = 0;
    while ((r.name[i] = from[i]) != 0) // error: out of bounds
        i++;
    printf("%s %d\n", r.name, r.speed);
    return 0;
}
