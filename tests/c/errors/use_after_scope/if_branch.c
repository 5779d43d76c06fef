/* A buffer that exists in one branch only. */
#include <stdio.h>

static void show(int n)
{
    const char *text = "none";

    if (n > 0) {
        char digits[12];
        sprintf(digits, "%d", n);
        text = digits;
    }
    puts(text); // error: use after scope
}

int main(void)
{
    show(0);
    show(5);
    return 0;
}
