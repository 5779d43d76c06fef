/* A small stack grows by one too many; what lies behind is the next variable. */
#include <stdio.h>
static int depth;
static struct { int x[3]; int y[3]; } path;
static void push(int x, int y)
{
    path.x[depth] = x; // error: out of bounds
    path.y[depth] = y;
    depth++;
}
int main(void)
{
    int i;
    for (i = 0; i < PLANT(4, 3); i++)
        push(i, i + 1);
    printf("%d\n", path.y[0]);
    return 0;
}
