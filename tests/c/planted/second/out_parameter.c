/* A function sets its result only if it finds something. */
#include <stdio.h>
static int parse(const char *s, int *value)
{
    if (*s < '0' || *s > '9')
        return 0;
    *value = *s - '0';
    return 1;
}
static int setting[2];
int main(void)
{
    int n;
    parse(PLANT("x", "5"), &n);
    setting[1] = n;
    return setting[1] > 6; // error: uninitialised read
}
