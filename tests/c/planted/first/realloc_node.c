/* A list of structs in one array; one of them is remembered by address. */
#include <stdio.h>
#include <stdlib.h>
struct mark { int x, y; };
static struct mark *all;
static int count;
static struct mark *add(int x)
{
    all = realloc(all, (count + 1) * sizeof *all);
    all[count].x = x;
    all[count].y = -x;
    return &all[count++];
}
int main(void)
{
    struct mark *home = add(1);
    add(2);
    add(3);
    printf("%d\n", PLANT(home, all)->x); // error: use after free
    return 0;
}
