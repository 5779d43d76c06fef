/* A variable without value is passed to a small function that does not use it always. */
#include <stdio.h>

static int choose(int condition, int yes, int no)
{
    return condition ? yes : no;
}

int main(int count, char **words)
{
    int number, i, total = 0;
    for (i = 0; i < 3; i++) {
        if (count > 5)
            number = i;
        total += choose(i > 1, number, 1);  // error: uninitialised read
    }
    printf("%d\n", total);
    return 0;
}
