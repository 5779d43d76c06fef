/* Unusual switches: labels inside loops and if statements, bodies of one statement or none, nested cases. */
#include <stdio.h>

enum { A = 1, B = A + 1 };

static int inside(int n)
{
    int r = 0;
    switch (n) {
        if (0) {
        case 1: r += 1;
        } else {
        case 2: r += 20;
        }
        for (; r < 100; r += 50) {
        case 3: r += 300;
        }
        r += 1000;
    default:;
    }
    return r;
}

static int single(int n)
{
    switch (n) case 4: case 5: return 45;
    switch (n) default: n++;
    switch (n++);
    switch (n) { }
    return n;
}

static const char *kind(unsigned char c)
{
    switch (c) {
    case '0': case '1': case '2': return "digit";
    case 'a': case 'f': return "letter";
    case 255: return "last";
    case (B + 1) * 2: return "six";
    }
    return "none";
}

static int falls(long long n)
{
    int r = 1;
    switch (n) {
    default: r *= 2;
    case -1: r *= 3; break;
    case 1ll << 40: r *= 5;
    case 0: r *= 7;
    }
    return r;
}

int main(void)
{
    for (int i = 0; i < 7; i++)
        printf("%d %d\n", inside(i), single(i));
    printf("%s %s %s %s %s\n", kind('1'), kind('f'), kind(-1), kind(6), kind('z'));
    printf("%d %d %d %d\n", falls(9), falls(-1), falls(1ll << 40), falls(0));
    return 0;
}
