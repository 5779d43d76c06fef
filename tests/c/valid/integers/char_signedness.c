/* Plain char is signed here, as on i386. */
#include <stdio.h>

int main(void)
{
    char c = 200;
    signed char s = 200;
    unsigned char u = 200;
    char text[] = "\xE4\xF6";
    unsigned char *bytes = (unsigned char *) text;
    int sum = 0, i;

    printf("%d %d %d\n", c, s, u);
    printf("%d %d\n", c == s, c == u);
    printf("%d %d\n", c < 0, u < 0);
    printf("%d %d %d %d\n", text[0], text[1], bytes[0], bytes[1]);
    for (i = -3; i < 4; i++) {
        c = (char) (i * 100);
        sum += c;
        printf("%d ", c);
    }
    printf("%d\n", sum);
    c = 127;
    c++;
    printf("%d\n", c);
    u = 0;
    u--;
    printf("%d\n", u);
    return 0;
}
