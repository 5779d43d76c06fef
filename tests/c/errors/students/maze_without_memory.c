/* A search that does not note where it was. */
#include <stdio.h>

static int explore(int x, int y) // error: stack overflow
{
    if (x < 0 || y < 0 || x >= 100 || y >= 100)
        return 0;
    return 1 + explore(x + 1, y) + explore(x - 1, y) + explore(x, y + 1) + explore(x, y - 1);
}

int main(void)
{
    printf("%d\n", explore(50, 50));
    return 0;
}
