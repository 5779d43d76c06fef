/* Typos that are still valid C. */
#include <stdio.h>

int main(void)
{
    int a = 1, b = 2;
    const char *from = "text";
    char buffer[8], *to = buffer;

    if (a = b)  // warning: using the result of an assignment as a condition without parentheses
//        ^
        a = 3;
    while (b = 0)  // warning: use '==' to compare
        ;
    if ((a = b))
        a = 1;
    while (*to++ = *from++)
        ;
    a =+ 2;  // warning: '=+' means '= +' here
//    ^
    a =- 1;  // warning: write '-=', or put a space between '=' and '-'
    b =-1;
    if (a);  // warning: 'if' statement has empty body
//        ^
    for (a = 0; a < 3; a++);  // warning: 'for' statement has empty body
    {
        b++;
    }
    while (getchar() > 0);
    printf("\%d\n", b);  // warning: unknown escape sequence '\%'
    return 0;
}
