/* A member of a constant struct gets a new value. */
#include <stdio.h>
struct model { const char *name; int sonars; };
static const struct model scout = {"scout", 16};
static struct model mine = {"mine", 16};
static void change(const struct model *m, int n)
{
    ((struct model *)m)->sonars = n; // error: write to read-only memory
}
int main(void)
{
    change(PLANT(&scout, &mine), 8);
    printf("%d\n", scout.sonars + mine.sonars);
    return 0;
}
