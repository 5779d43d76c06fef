/* Qualifiers in every place of a declaration. */
#include <stdio.h>

static const int table[] = { 1, 2, 3 };
static volatile int flag = 5;
const char *const names[] = { "north", "east", 0 };
extern const double limit;
const double limit = 2.5;

static int total(const int *const values, const int count)
{
    int sum = 0, i;

    for (i = 0; i < count; i++)
        sum += values[i];
    return sum;
}

static char *skip(const char *text, char c)
{
    while (*text == c)
        ++text;
    return (char *) text;
}

int main(void)
{
    const int *p = table;
    int const *q = &table[2];
    int n = 4, *const fixed = &n;
    volatile const unsigned char *port = (unsigned char *) &n;
    int i = 0;

    printf("%d %d\n", *p, *q);
    *fixed += 1;
    printf("%d %d\n", n, *port);
    while (flag-- > 2)
        i++;
    printf("%d %d\n", i, flag);
    for (i = 0; names[i]; i++)
        printf("%s ", names[i]);
    printf("\n%d %g\n", total(table, 3), limit);
    printf("%s\n", skip("---x", '-'));
    p++;
    printf("%d\n", *p);
    return 0;
}
