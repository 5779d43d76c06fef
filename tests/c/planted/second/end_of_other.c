/* Two pointers into different strings are compared. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char one[20] = "a;b", two[20] = "c;d", *semicolon = strchr(PLANT(two, one), ';'), *p;
    int n = 0;
    for (p = one; p < semicolon; p++) // warning: pointers to different objects
        n += *p != 0;
    printf("%d\n", n > 0);
    return 0;
}
