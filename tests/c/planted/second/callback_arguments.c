/* A callback wants more than it is given. */
#include <stdio.h>
typedef void (*callback)(int);
static int last;
static void note(int n) { last = n; }
static void note_two(int n, int m) { last = n + m; }
static void each(callback f)
{
    int i;
    for (i = 0; i < 3; i++)
        f(i); // error: mismatched call
}
int main(void)
{
    (void)note_two;
    each(PLANT((callback)note_two, note));
    return last > 100;
}
