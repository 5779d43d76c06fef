/* The value of an assignment is that of the left operand after it (C17 6.5.16p3). */
#include <stdio.h>

int main(void)
{
    int a, b, c;
    unsigned char u;
    signed char s;
    float f;
    double d;
    int v[3] = { 0 }, *p = v;
    char text[10], *from = "copied", *to = text;

    a = b = c = 4;
    printf("%d %d %d\n", a, b, c);
    a = u = 300;
    printf("%d %d\n", a, u);
    a = s = 200;
    printf("%d %d\n", a, s);
    d = f = 0.1;
    printf("%d\n", d == 0.1);
    printf("%d\n", (a = 5) + 1);
    if ((c = a - 5))
        printf("never\n");
    printf("%d\n", c);
    while ((*to++ = *from++))
        ;
    printf("%s\n", text);
    *p++ = 1;
    *p++ = 2;
    *p = 3;
    printf("%d %d %d\n", v[0], v[1], v[2]);
    v[v[0]] = v[v[1] - 1] + 40;
    printf("%d\n", v[1]);
    (a = 3, p = &a, *p) ? (b = 8) : (b = 9);
    printf("%d\n", b);
    return 0;
}
