/* A scanner written with gotos, as generated code is. */
#include <stdio.h>

static int scan(const char *p, int *number, int *signs)
{
    int value, sign;

start:
    sign = 1;
    switch (*p) {
    case '\0': goto accept;
    case ' ': p++; goto start;
    case '-': sign = -1; p++; ++*signs; goto digits_required;
    case '+': p++; ++*signs; goto digits_required;
    default:
        if (*p >= '0' && *p <= '9') {
            value = 0;
            goto digits;
        }
        goto reject;
    }
digits_required:
    if (*p < '0' || *p > '9')
        goto reject;
    value = 0;
digits:
    value = value * 10 + (*p++ - '0');
    if (*p >= '0' && *p <= '9')
        goto digits;
    *number += sign * value;
    if (*p == ',' || *p == ' ') {
        p++;
        goto start;
    }
    if (*p)
        goto reject;
accept:
    return 1;
reject:
    return 0;
}

int main(void)
{
    const char *tests[] = { "1,2,3", " 42 -2  +10", "", "-", "12a", "7,,8", "100,-99" };
    int i;

    for (i = 0; i < 7; i++) {
        int n = 0, signs = 0, ok = scan(tests[i], &n, &signs);
        printf("%s: %d %d %d\n", tests[i], ok, n, signs);
    }
    return 0;
}
