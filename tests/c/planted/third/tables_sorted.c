/* The end of one table is where the next one starts, or so it is hoped. */
#include <stdio.h>
struct step { short left, right; };
static struct step turn[6] = {{1, -1}, {2, -2}}, drive[8] = {{5, 5}, {6, 6}};
int main(void)
{
    const struct step *s, *last = PLANT(drive, turn + 6);
    int n = 0;
    for (s = turn; s != last && n < 6; s++)
        n++;
    printf("%d %d\n", n, last - turn >= 6); // error: unrelated pointers
    return 0;
}
