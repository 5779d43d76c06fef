/* A table in a function, indexed by a character that is no digit. */
#include <stdio.h>
static int segments(char c)
{
    static const unsigned char lit[10] = {63, 6, 91, 79, 102, 109, 125, 7, 127, 111};
    return lit[c - '0']; // error: out of bounds
}
int main(void)
{
    const char *shown = PLANT("12:30", "12930");
    int sum = 0;
    while (*shown)
        sum += segments(*shown++);
    printf("%d\n", sum);
    return 0;
}
