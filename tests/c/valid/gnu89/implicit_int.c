/* Missing types are int: functions, parameters, variables (C89 3.5.2). */
#include <stdio.h>

counter = 3;
static limit = 10;
*place;
unsigned natural = 7;

twice(n)
{
    return 2 * n;
}

static difference(a, b)
    int a;
{
    return a - b;
}

const fixed = 12;

main()
{
    register i;
    auto j = 2;
    static calls;
    const k = 5;

    place = &counter;
    for (i = 0; i < 3; i++)
        calls += twice(i) + j;
    printf("%d %d %d %d\n", counter + limit, *place, fixed, calls);
    printf("%d %d %u\n", difference(9, 4), k + j, natural + 1);
    return 0;
}
