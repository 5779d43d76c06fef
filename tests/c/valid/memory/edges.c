/* Accesses up to the bounds of an object are valid, as are pointers just past the last element. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct tail { int count; char name[]; };

static int total(const int *from, const int *end)
{
    int sum = 0;

    while (from != end)
        sum += *from++;
    return sum;
}

int main(void)
{
    int a[10], i, *p;
    char exact[6], *s;
    struct tail *t;
    long long wide[1];

    for (i = 9; i >= 0; i--)
        a[i] = i;
    printf("%d\n", total(a, a + 10));
    for (p = a + 9; p >= a; p--)
        *p += 1;
    printf("%d\n", total(&a[0], &a[10]));
    strcpy(exact, "abcde");
    printf("%s %u\n", exact, (unsigned) strlen(exact));
    strncpy(exact, "abcdefgh", sizeof exact);
    printf("%.6s\n", exact);
    s = malloc(7);
    memcpy(s, "abcdef", 7);
    printf("%s %c\n", s, s[5]);
    s = realloc(s, 3);
    s[2] = 0;
    printf("%s\n", s);
    s = realloc(s, 300);
    memset(s + 3, 'x', 296);
    s[299] = 0;
    printf("%u\n", (unsigned) strlen(s + 3));
    free(s);
    t = malloc(sizeof *t + 4);
    t->count = 4;
    strcpy(t->name, "abc");
    printf("%s %d\n", t->name, t->count);
    free(t);
    free(NULL);
    s = malloc(0);
    free(s);
    wide[0] = 1;
    ((int *) wide)[1] = 2;
    printf("%llx\n", wide[0]);
    return 0;
}
