/* Recursion with arrays. */
#include <string.h>

static int deep(int n)
{
    char room[n * 100000]; // error: no memory for local array
    memset(room, 1, sizeof room);
    return deep(n + 1) + room[0];
}

int main(void)
{
    return deep(1);
}
