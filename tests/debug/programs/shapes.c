/* Structs, an enum, a union, bit-fields, recursion and function pointers, to be looked at. */
#include <stdio.h>

enum kind { CIRCLE, BOX = 5 };

struct point {
    double x, y;
};

struct shape {
    enum kind kind;
    struct point at;
    union {
        float radius;
        int side[2];
    } size;
    unsigned is_solid : 1, colour : 3;
    const char *name;
    double (*area)(const struct shape *);
};

static double circle_area(const struct shape *it)
{
    return 3 * it->size.radius * it->size.radius;
}

static double box_area(const struct shape *it)
{
    return it->size.side[0] * it->size.side[1];
}

struct shape shapes[] = {
    { CIRCLE, { 1.5, -2 }, { .radius = 0.5f }, 1, 4, "disc", circle_area },
    { BOX, { 0, 7 }, { .side = { 3, 4 } }, 0, 2, "crate", box_area },
};
int calls;

static int factorial(int n)
{
    int rest;

    calls++;
    if (n <= 1)
        return 1;
    rest = factorial(n - 1);
    return n * rest;
}

static double total(const struct shape *first, int count)
{
    double sum = 0;
    int i;

    for (i = 0; i < count; i++)
        sum += first[i].area(&first[i]);
    return sum;
}

int main(int argc, char **argv)
{
    char word[8] = "scout";
    const struct shape *largest = &shapes[1];
    int result;

    result = factorial(argc + 3);
    printf("%d after %d calls\n", result, calls);
    printf("%s covers %.2f\n", largest->name, total(shapes, 2));
    word[0] = 'S';
    puts(word);
    return argv[0] == NULL ? 1 : 3;
}
